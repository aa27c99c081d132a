// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "fastdds_peer.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace surefoot::test {
namespace {

using namespace eprosima;
namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

/// Samples are strings of CDR.
class RawType final : public dds::TopicDataType {
 public:
  explicit RawType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = 8 << 20;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, fastrtps::rtps::SerializedPayload_t* payload) override {
    const auto& bytes = *static_cast<std::string*>(data);
    payload->encapsulation = CDR_LE;
    payload->length = static_cast<std::uint32_t>(bytes.size());
    std::memcpy(payload->data, bytes.data(), bytes.size());
    return true;
  }
  bool deserialize(fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    static_cast<std::string*>(data)->assign(reinterpret_cast<const char*>(payload->data),
                                            payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<std::string*>(data)->size()); };
  }
  void* createData() override { return new std::string; }
  void deleteData(void* data) override { delete static_cast<std::string*>(data); }
  bool getKey(void*, fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

template <typename Qos>
void set(Qos& qos, bool reliable, bool transient_local) {
  qos.reliability().kind =
      reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind =
      transient_local ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = 1000;
  qos.endpoint().history_memory_policy = fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
}

dds::DomainParticipantQos loopback_qos(int domain) {
  constexpr int kBase = 7400, kPerDomain = 250, kUnicast = 10, kPerParticipant = 2, kMost = 10;
  dds::DomainParticipantQos qos;
  qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.push_back("127.0.0.1");
  udp->sendBufferSize = udp->receiveBufferSize = 4 << 20;
  qos.transport().user_transports.push_back(udp);
  auto& builtin = qos.wire_protocol().builtin;
  for (int i = 0; i < kMost; ++i) {
    fastrtps::rtps::Locator_t peer;
    fastrtps::rtps::IPLocator::setIPv4(peer, 127, 0, 0, 1);
    peer.port =
        static_cast<std::uint32_t>(kBase + kPerDomain * domain + kUnicast + kPerParticipant * i);
    builtin.initialPeersList.push_back(peer);
  }
  builtin.discovery_config.leaseDuration_announcementperiod = {0, 300'000'000};
  return qos;
}

std::string text_of(const std::vector<fastrtps::rtps::octet>& bytes) {
  return {bytes.begin(), bytes.end()};
}

class Listener final : public dds::DomainParticipantListener {
 public:
  void on_publisher_discovery(dds::DomainParticipant*,
                              fastrtps::rtps::WriterDiscoveryInfo&& found) override {
    if (found.status != fastrtps::rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) return;
    const auto& qos = found.info.m_qos;
    const std::lock_guard lock(mutex);
    writers.push_back({found.info.topicName().c_str(), found.info.typeName().c_str(),
                       text_of(qos.m_userData.data_vec()),
                       qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS,
                       qos.m_durability.kind == dds::TRANSIENT_LOCAL_DURABILITY_QOS});
  }
  void on_participant_discovery(dds::DomainParticipant*,
                                fastrtps::rtps::ParticipantDiscoveryInfo&& found) override {
    if (found.status != fastrtps::rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT) return;
    const std::lock_guard lock(mutex);
    participants.push_back(text_of(found.info.m_userData.data_vec()));
  }

  std::mutex mutex;
  std::vector<Discovered> writers;
  std::vector<std::string> participants;
};

}  // namespace

struct FastDdsPeer::Parts {
  Listener listener;
  dds::DomainParticipant* participant = nullptr;
  dds::Publisher* publisher = nullptr;
  dds::Subscriber* subscriber = nullptr;
  std::map<std::string, dds::Topic*> topics;
  std::map<std::string, dds::DataWriter*> writers;
  std::map<std::string, dds::DataReader*> readers;

  dds::Topic* topic(const std::string& name, const std::string& type) {
    if (topics.count(name) == 0) {
      const dds::TypeSupport support(new RawType(type));
      support.register_type(participant);
      topics[name] = participant->create_topic(name, type, dds::TOPIC_QOS_DEFAULT);
    }
    return topics[name];
  }
};

FastDdsPeer::FastDdsPeer(int domain) : parts_(std::make_unique<Parts>()) {
  auto* const factory = dds::DomainParticipantFactory::get_instance();
  parts_->participant =
      factory->create_participant(static_cast<std::uint32_t>(domain), loopback_qos(domain),
                                  &parts_->listener, dds::StatusMask::none());
  if (parts_->participant == nullptr) throw std::runtime_error("no participant of Fast DDS");
  parts_->publisher = parts_->participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  parts_->subscriber = parts_->participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
}

FastDdsPeer::~FastDdsPeer() {
  parts_->participant->set_listener(nullptr);
  parts_->participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(parts_->participant);
}

void FastDdsPeer::add_writer(const std::string& topic, const std::string& type, bool reliable) {
  dds::DataWriterQos qos;
  set(qos, reliable, false);
  qos.publish_mode().kind = dds::ASYNCHRONOUS_PUBLISH_MODE;
  parts_->writers[topic] = parts_->publisher->create_datawriter(parts_->topic(topic, type), qos);
}

void FastDdsPeer::add_reader(const std::string& topic, const std::string& type, bool reliable,
                             bool transient_local) {
  dds::DataReaderQos qos;
  set(qos, reliable, transient_local);
  parts_->readers[topic] = parts_->subscriber->create_datareader(parts_->topic(topic, type), qos);
}

void FastDdsPeer::write(const std::string& topic, const std::string& cdr) {
  std::string bytes = cdr;
  parts_->writers.at(topic)->write(&bytes);
}

bool FastDdsPeer::wait_for_readers(const std::string& topic, int readers) {
  for (int i = 0; i < 1000; ++i) {
    dds::PublicationMatchedStatus status;
    parts_->writers.at(topic)->get_publication_matched_status(status);
    if (status.current_count >= readers) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

std::vector<std::string> FastDdsPeer::take(const std::string& topic) {
  std::vector<std::string> taken;
  std::string bytes;
  dds::SampleInfo info;
  while (parts_->readers.at(topic)->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
    if (info.valid_data) taken.push_back(bytes);
  }
  return taken;
}

std::vector<Discovered> FastDdsPeer::writers() const {
  const std::lock_guard lock(parts_->listener.mutex);
  return parts_->listener.writers;
}

std::vector<std::string> FastDdsPeer::participants() const {
  const std::lock_guard lock(parts_->listener.mutex);
  return parts_->listener.participants;
}

std::string cloud_by_fast_cdr(const Scan& scan, const std::string& frame) {
  constexpr std::uint8_t kU16 = 4, kI32 = 5, kF32 = 7;
  struct Field {
    const char* name;
    std::uint32_t offset;
    std::uint8_t type;
  };
  constexpr std::uint32_t kStep = 22;
  const std::vector<Field> fields = {{"x", 0, kF32},          {"y", 4, kF32},  {"z", 8, kF32},
                                     {"intensity", 12, kF32}, {"t", 16, kI32}, {"ring", 20, kU16}};
  std::vector<std::uint8_t> points(scan.points.size() * kStep);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    std::uint8_t* const point = points.data() + i * kStep;
    const float intensity = scan.intensities.empty() ? 0.0F : scan.intensities[i];
    const std::int32_t time = scan.times_ns.empty() ? 0 : scan.times_ns[i];
    const std::uint16_t ring = scan.rings.empty() ? std::uint16_t{0} : scan.rings[i];
    std::memcpy(point, scan.points[i].data(), 12);
    std::memcpy(point + 12, &intensity, 4);
    std::memcpy(point + 16, &time, 4);
    std::memcpy(point + 20, &ring, 2);
  }
  fastcdr::FastBuffer buffer;
  fastcdr::Cdr cdr(buffer, fastcdr::Cdr::DEFAULT_ENDIAN, fastcdr::Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  const auto count = static_cast<std::uint32_t>(scan.points.size());
  cdr << static_cast<std::int32_t>(scan.stamp_ns / 1'000'000'000)
      << static_cast<std::uint32_t>(scan.stamp_ns % 1'000'000'000) << frame << std::uint32_t{1}
      << count << static_cast<std::uint32_t>(fields.size());
  for (const Field& field : fields) {
    cdr << std::string(field.name) << field.offset << field.type << std::uint32_t{1};
  }
  cdr << false << kStep << kStep * count << points << true;
  return {buffer.getBuffer(), cdr.getSerializedDataLength()};
}

std::string velodyne_scan_by_fast_cdr(std::span<const std::string> packets, std::int64_t stamp_ns) {
  constexpr std::size_t kBytes = 1206;
  fastcdr::FastBuffer buffer;
  fastcdr::Cdr cdr(buffer, fastcdr::Cdr::DEFAULT_ENDIAN, fastcdr::Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  const auto stamp = [&] {
    cdr << static_cast<std::int32_t>(stamp_ns / 1'000'000'000)
        << static_cast<std::uint32_t>(stamp_ns % 1'000'000'000);
  };
  stamp();
  cdr << std::string("velodyne") << static_cast<std::uint32_t>(packets.size());
  for (const std::string& packet : packets) {
    stamp();
    std::array<std::uint8_t, kBytes> bytes{};
    std::memcpy(bytes.data(), packet.data(), std::min(kBytes, packet.size()));
    cdr << bytes;
  }
  return {buffer.getBuffer(), cdr.getSerializedDataLength()};
}

OdometryFields odometry_by_fast_cdr(const std::string& bytes) {
  std::string copy = bytes;
  fastcdr::FastBuffer buffer(copy.data(), copy.size());
  fastcdr::Cdr cdr(buffer, fastcdr::Cdr::DEFAULT_ENDIAN, fastcdr::Cdr::DDS_CDR);
  cdr.read_encapsulation();
  OdometryFields odometry;
  std::int32_t seconds = 0;
  std::uint32_t nanoseconds = 0;
  cdr >> seconds >> nanoseconds >> odometry.frame >> odometry.child_frame;
  odometry.stamp_ns = std::int64_t{seconds} * 1'000'000'000 + nanoseconds;
  odometry.numbers.resize(7 + 36 + 6 + 36);
  for (double& number : odometry.numbers) cdr >> number;
  return odometry;
}

}  // namespace surefoot::test
