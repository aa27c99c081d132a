// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "cyclone_peer.hpp"

#include <dds/dds.h>
#include <ros2_messages.h>

#include <array>
#include <chrono>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <thread>

namespace surefoot::test {
namespace {

constexpr const char* kLoopback =
    "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface "
    "name=\"lo\"/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General><Discovery>"
    "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
    "<Peers><Peer Address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>";

dds_entity_t checked(dds_entity_t entity) {
  if (entity < 0) throw std::runtime_error(dds_strretcode(entity));
  return entity;
}

struct Header {
  std::int64_t stamp_ns;
  std::string frame;
};
Header header_of(const std_msgs_msg_dds__Header_& header) {
  return {std::int64_t{header.stamp.sec} * 1'000'000'000 + header.stamp.nanosec, header.frame_id};
}

}  // namespace

struct CyclonePeer::Parts {
  dds_entity_t domain = 0, participant = 0, clouds = 0;
  dds_entity_t odometry = 0, transforms = 0, scans = 0;
  dds_qos_t* qos = dds_create_qos();

  [[nodiscard]] dds_entity_t topic(const std::string& name,
                                   const dds_topic_descriptor_t& type) const {
    return checked(dds_create_topic(participant, &type, name.c_str(), nullptr, nullptr));
  }
  [[nodiscard]] dds_entity_t reader(const std::string& name,
                                    const dds_topic_descriptor_t& type) const {
    return checked(dds_create_reader(participant, topic(name, type), qos, nullptr));
  }

  /// What came so far, each as `Sample`, Cyclone's own structure.
  template <typename Sample>
  static void take(dds_entity_t from, const std::function<void(const Sample&)>& each) {
    void* samples[1] = {nullptr};
    dds_sample_info_t info;
    while (dds_take(from, samples, &info, 1, 1) == 1) {
      if (info.valid_data) each(*static_cast<const Sample*>(samples[0]));
      dds_return_loan(from, samples, 1);
    }
  }
};

CyclonePeer::CyclonePeer(int domain, const std::string& cloud_topic)
    : parts_(std::make_unique<Parts>()) {
  Parts& parts = *parts_;
  const auto id = static_cast<dds_domainid_t>(domain);
  parts.domain = checked(dds_create_domain(id, kLoopback));
  parts.participant = checked(dds_create_participant(id, nullptr, nullptr));
  dds_qset_reliability(parts.qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  dds_qset_history(parts.qos, DDS_HISTORY_KEEP_LAST, 1000);
  const dds_topic_descriptor_t& cloud = sensor_msgs_msg_dds__PointCloud2__desc;
  parts.clouds = checked(
      dds_create_writer(parts.participant, parts.topic(cloud_topic, cloud), parts.qos, nullptr));
  parts.odometry = parts.reader("rt/surefoot/odometry", nav_msgs_msg_dds__Odometry__desc);
  parts.transforms = parts.reader("rt/tf", tf2_msgs_msg_dds__TFMessage__desc);
  parts.scans = parts.reader("rt/surefoot/scan", cloud);
}

CyclonePeer::~CyclonePeer() {
  dds_delete_qos(parts_->qos);
  dds_delete(parts_->domain);
}

bool CyclonePeer::wait_for_peer() const {
  for (int i = 0; i < 1000; ++i) {
    dds_publication_matched_status_t heard{};
    dds_subscription_matched_status_t told{};
    dds_get_publication_matched_status(parts_->clouds, &heard);
    dds_get_subscription_matched_status(parts_->odometry, &told);
    if (heard.current_count > 0 && told.current_count > 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

void CyclonePeer::write(const Scan& scan) {
  constexpr std::uint8_t kI32 = 5, kF32 = 7;
  constexpr std::uint32_t kStep = 16;
  const std::array<const char*, 4> names = {"x", "y", "z", "t"};
  std::array<sensor_msgs_msg_dds__PointField_, 4> fields{};
  for (std::uint32_t i = 0; i < fields.size(); ++i) {
    fields[i] = {const_cast<char*>(names[i]), 4 * i, i < 3 ? kF32 : kI32, 1};
  }
  const auto count = static_cast<std::uint32_t>(scan.points.size());
  std::vector<std::uint8_t> data(std::size_t{count} * kStep);
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(&data[i * kStep], scan.points[i].data(), 12);
    std::memcpy(&data[i * kStep + 12], &scan.times_ns[i], 4);
  }
  sensor_msgs_msg_dds__PointCloud2_ cloud{};
  cloud.header.stamp = {static_cast<std::int32_t>(scan.stamp_ns / 1'000'000'000),
                        static_cast<std::uint32_t>(scan.stamp_ns % 1'000'000'000)};
  cloud.header.frame_id = const_cast<char*>("velodyne");
  cloud.height = 1;
  cloud.width = count;
  cloud.fields._length = cloud.fields._maximum = fields.size();
  cloud.fields._buffer = fields.data();
  cloud.point_step = kStep;
  cloud.row_step = kStep * count;
  cloud.data._length = cloud.data._maximum = static_cast<std::uint32_t>(data.size());
  cloud.data._buffer = data.data();
  cloud.is_dense = true;
  (void)checked(dds_write(parts_->clouds, &cloud));
}

std::vector<HeardOdometry> CyclonePeer::odometry() const {
  std::vector<HeardOdometry> heard;
  Parts::take<nav_msgs_msg_dds__Odometry_>(parts_->odometry, [&](const auto& sample) {
    const auto [stamp_ns, frame] = header_of(sample.header);
    HeardOdometry one{stamp_ns, frame, sample.child_frame_id, {}};
    const auto add = [&](const double* first, std::size_t count) {
      one.numbers.insert(one.numbers.end(), first, first + count);
    };
    const auto& [position, orientation] = sample.pose.pose;
    const auto& [linear, angular] = sample.twist.twist;
    one.numbers = {position.x,    position.y,    position.z,   orientation.x,
                   orientation.y, orientation.z, orientation.w};
    add(sample.pose.covariance, 36);
    one.numbers.insert(one.numbers.end(),
                       {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z});
    add(sample.twist.covariance, 36);
    heard.push_back(std::move(one));
  });
  return heard;
}

std::vector<HeardTransforms> CyclonePeer::transforms() const {
  std::vector<HeardTransforms> heard;
  Parts::take<tf2_msgs_msg_dds__TFMessage_>(parts_->transforms, [&](const auto& sample) {
    HeardTransforms all;
    for (std::uint32_t i = 0; i < sample.transforms._length; ++i) {
      const auto& one = sample.transforms._buffer[i];
      all.push_back(header_of(one.header).frame + " > " + one.child_frame_id);
    }
    heard.push_back(std::move(all));
  });
  return heard;
}

std::vector<std::size_t> CyclonePeer::cloud_sizes() const {
  std::vector<std::size_t> sizes;
  Parts::take<sensor_msgs_msg_dds__PointCloud2_>(parts_->scans, [&](const auto& sample) {
    sizes.push_back(std::size_t{sample.width} * sample.height);
  });
  return sizes;
}

}  // namespace surefoot::test
