// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_page/page_history.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/voxel_key.hpp"
#include "report/base64.hpp"
#include "report/map_json.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::live_page {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// One number a scan, as base64 of float32.
template <typename Of>
std::string series(std::span<const PageScan> scans, Of of) {
  std::vector<float> values;
  values.reserve(scans.size());
  for (const PageScan& scan : scans) values.push_back(static_cast<float>(of(scan)));
  return report::base64_of(std::span<const float>(values));
}

std::string positions(std::span<const PageScan> scans) {
  std::vector<float> values;
  values.reserve(3 * scans.size());
  for (const PageScan& scan : scans) {
    const Eigen::Vector3f place = scan.T_world_lidar.translation.cast<float>();
    values.insert(values.end(), {place.x(), place.y(), place.z()});
  }
  return report::base64_of(std::span<const float>(values));
}

Json pose_json(const Pose& pose) {
  const Eigen::Vector3d& t = pose.translation;
  const Eigen::Quaterniond& q = pose.rotation;
  return {{"position", {t.x(), t.y(), t.z()}}, {"quaternion", {q.x(), q.y(), q.z(), q.w()}}};
}

/// Nothing for what lies further out than keys reach.
std::optional<std::uint64_t> cube_of(const Eigen::Vector3f& point, double cube) {
  constexpr double kReach = 1 << 20;
  const Eigen::Vector3d place = point.cast<double>();
  if (!((place / cube).array().abs() < kReach).all()) return std::nullopt;
  return voxel_key(voxel_index(place, 1.0 / cube));
}

}  // namespace

void PageHistory::begin(int segment) {
  segment_ = segment;
  way_ = 0.0;
  path_.clear();
  points_.clear();
  cubes_.clear();
  stride_ = 1;
  since_kept_ = 0;
  cube_ = limits_.cube;
  ++path_number_;
  ++map_number_;
}

void PageHistory::add(PageScan scan) {
  if (!last_) first_stamp_ns_ = scan.stamp_ns;
  if (!last_ || scan.segment != segment_) {
    begin(scan.segment);
  } else {
    way_ += (scan.T_world_lidar.translation - last_->T_world_lidar.translation).norm();
  }
  if (since_kept_++ % stride_ == 0) {
    path_.push_back(scan);
    if (path_.size() > limits_.poses) thin_path();
  }
  last_ = std::move(scan);
}

void PageHistory::thin_path() {
  // The first stays; moved to itself its texts would be gone.
  for (std::size_t i = 1; 2 * i < path_.size(); ++i) path_[i] = std::move(path_[2 * i]);
  path_.resize((path_.size() + 1) / 2);
  stride_ *= 2;
  since_kept_ = 1;  // the last one that is there was kept just now
  ++path_number_;
}

void PageHistory::add(const PageCloud& cloud) {
  if (cloud.segment != segment_ || !last_) return;
  const Eigen::Matrix3f R = cloud.T_world_lidar.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = cloud.T_world_lidar.translation.cast<float>();
  for (const Eigen::Vector3f& point : cloud.points) {
    keep(R * point + t);
    if (points_.size() > limits_.points) coarsen_map();
  }
}

void PageHistory::keep(const Eigen::Vector3f& point) {
  const std::optional<std::uint64_t> cube = cube_of(point, cube_);
  if (cube && cubes_.insert(*cube).second) points_.push_back(point);
}

void PageHistory::coarsen_map() {
  const std::vector<Eigen::Vector3f> all = std::exchange(points_, {});
  cubes_.clear();
  cube_ *= 2.0;
  for (const Eigen::Vector3f& point : all) keep(point);
  ++map_number_;
}

bool PageHistory::all_told(const Told& told) const {
  return told.map == map_number_ && told.points == points_.size();
}

Json PageHistory::path_news(Told& told) const {
  const bool anew = std::exchange(told.path, path_number_) != path_number_;
  if (anew) told.poses = 0;
  const auto scans = std::span(path_).subspan(told.poses);
  told.poses = path_.size();
  Json statuses = Json::array(), weak = Json::array();
  for (const PageScan& scan : scans) {
    statuses.push_back(scan.status);
    weak.push_back(scan.weak);
  }
  const auto time = [&](const PageScan& s) { return seconds(s.stamp_ns - first_stamp_ns_); };
  return {{"anew", anew},
          {"times", series(scans, time)},
          {"positions", positions(scans)},
          {"latencies_ms", series(scans, [](const PageScan& scan) { return scan.latency_ms; })},
          {"wrong_probabilities",
           series(scans, [](const PageScan& scan) { return scan.wrong_probability; })},
          {"statuses", std::move(statuses)},
          {"weak", std::move(weak)}};
}

Json PageHistory::map_news(Told& told) const {
  const bool anew = std::exchange(told.map, map_number_) != map_number_;
  if (anew) told.points = 0;
  const std::size_t count = std::min(points_.size() - told.points, limits_.points_at_once);
  const auto from = points_.begin() + static_cast<std::ptrdiff_t>(told.points);
  told.points += count;
  Json json = {{"anew", anew}, {"cube_m", cube_}, {"positions", nullptr}};
  if (count > 0) {
    json["positions"] = report::points_json({from, from + static_cast<std::ptrdiff_t>(count)});
  }
  return json;
}

Json PageHistory::news(Told& told) const {
  Json scan = nullptr;
  if (last_) {
    scan = {{"name", last_->name},
            {"time", seconds(last_->stamp_ns - first_stamp_ns_)},
            {"stamp_ns", std::to_string(last_->stamp_ns)},
            {"status", last_->status},
            {"message", last_->message},
            {"segment", last_->segment},
            {"pose", pose_json(last_->T_world_lidar)},
            {"way_m", number(way_)},
            {"wrong_probability", number(last_->wrong_probability)},
            {"weak", last_->weak},
            {"latency_ms", number(last_->latency_ms)}};
  }
  return {{"scan", std::move(scan)}, {"path", path_news(told)}, {"map", map_news(told)}};
}

}  // namespace surefoot::live_page
