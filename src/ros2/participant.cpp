// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/participant.hpp"
#include "ros2/cyclone_log.hpp"

#include <dds/dds.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsrt/log.h>
#include <ifaddrs.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "io/bags/message_source.hpp"
#include "io/messages/message_writer.hpp"
#include "ros2/names.hpp"
#include "ros2/raw_type.hpp"
#include "text/printable.hpp"

namespace surefoot::ros2 {
namespace {

constexpr const char* kDiscoveryTopic = "ros_discovery_info";
constexpr const char* kDiscoveryType = "rmw_dds_common/ParticipantEntitiesInfo";
constexpr TopicQos kDiscoveryQos = {.depth = 1, .latched = true};

struct QosDeleter {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, QosDeleter>;

Qos qos_of(const TopicQos& wanted, const std::string& user_data) {
  Qos qos(dds_create_qos());
  constexpr dds_data_representation_id_t kRepresentation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &kRepresentation);
  dds_qset_reliability(qos.get(),
                       wanted.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       wanted.waits ? DDS_MSECS(100) : 0);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, wanted.depth);
  dds_qset_durability(qos.get(),
                      wanted.latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  if (wanted.latched) {
    dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, wanted.depth,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  }
  dds_qset_writer_data_lifecycle(qos.get(), false);
  if (!user_data.empty()) dds_qset_userdata(qos.get(), user_data.data(), user_data.size());
  return qos;
}

bool is_loopback(const std::string& interface) {
  return interface == "lo" || interface == "localhost" || interface.starts_with("127.");
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// What is asked for comes after what the environment says, and so goes before it.
std::string configuration(const ParticipantOptions& options) {
  std::vector<std::string> peers = options.peers;
  std::string general;
  if (!options.interface.empty()) {
    const bool is_address = std::isdigit(static_cast<unsigned char>(options.interface[0])) != 0;
    general += "<Interfaces><NetworkInterface " + std::string(is_address ? "address" : "name") +
               "=\"" + escaped(options.interface) + "\"/></Interfaces>";
    if (is_loopback(options.interface)) {  // which has no multicast
      general += "<AllowMulticast>false</AllowMulticast>";
      peers.emplace_back("127.0.0.1");
    }
  }
  std::string discovery;
  if (!peers.empty()) {
    discovery =
        "<ParticipantIndex>auto</ParticipantIndex>"
        "<MaxAutoParticipantIndex>32</MaxAutoParticipantIndex><Peers>";
    for (const std::string& peer : peers) {
      discovery += "<Peer Address=\"" + escaped(peer) + "\"/>";
    }
    discovery += "</Peers>";
  }
  const char* const environment = std::getenv("CYCLONEDDS_URI");
  const std::string before = environment == nullptr || *environment == '\0'
                                 ? std::string()
                                 : std::string(environment) + ",";
  return before + "<CycloneDDS><Domain Id=\"any\"><General>" + general + "</General><Discovery>" +
         discovery +
         "</Discovery><Internal><SocketReceiveBufferSize max=\"16MB\"/></Internal>"
         "</Domain></CycloneDDS>";
}

std::string interfaces_text() {
  std::set<std::string> names;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) return {};
  for (const ifaddrs* one = first; one != nullptr; one = one->ifa_next) names.insert(one->ifa_name);
  ::freeifaddrs(first);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string guid_of(dds_entity_t entity) {
  dds_guid_t guid = {};
  (void)dds_get_guid(entity, &guid);
  return {reinterpret_cast<const char*>(guid.v), sizeof(guid.v)};
}

/// Visits what others publish.
template <typename Visitor>
void for_each_publication(dds_entity_t reader, const std::string& own, Visitor&& visit) {
  constexpr std::uint32_t kMost = 4096;
  std::vector<void*> samples(kMost, nullptr);
  std::vector<dds_sample_info_t> infos(kMost);
  const dds_return_t count = dds_read(reader, samples.data(), infos.data(), kMost, kMost);
  if (count <= 0) return;
  for (dds_return_t i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto* const endpoint = static_cast<const dds_builtintopic_endpoint_t*>(samples[at]);
    if (!infos[at].valid_data || infos[at].instance_state != DDS_IST_ALIVE) continue;
    if (endpoint->topic_name == nullptr || endpoint->type_name == nullptr) continue;
    const std::string_view participant(reinterpret_cast<const char*>(endpoint->participant_key.v),
                                       sizeof(dds_guid_t));
    if (participant != own) visit(*endpoint);
  }
  (void)dds_return_loan(reader, samples.data(), count);
}

}  // namespace

Participant::Participant(const ParticipantOptions& options) : options_(options) {
  if (!is_node_name(options_.node)) {
    throw std::invalid_argument("ROS 2 node: got '" + text::printable(options_.node) +
                                "', expected a name such as robot_1");
  }
  const auto fail = [&](dds_return_t error, const std::string& said) {
    const std::string network = options_.interface.empty() ? "" : " on " + options_.interface;
    throw std::runtime_error("ROS 2 domain " + std::to_string(options_.domain) + network + ": " +
                             (said.empty() ? dds_strretcode(error) : said) +
                             "; interfaces there are: " + interfaces_text());
  };
  const Complaints complaints;
  const auto id = static_cast<dds_domainid_t>(options_.domain);
  domain_.id = dds_create_domain(id, configuration(options_).c_str());
  // Another participant of this process may have made it.
  const bool is_there = domain_.id == DDS_RETCODE_PRECONDITION_NOT_MET;
  if (domain_.id < 0 && !is_there) fail(domain_.id, complaints.text());
  const Qos qos(dds_create_qos());
  constexpr std::string_view kEnclave = "enclave=/;";
  dds_qset_userdata(qos.get(), kEnclave.data(), kEnclave.size());
  participant_.id = dds_create_participant(id, qos.get(), nullptr);
  if (participant_.id < 0) fail(participant_.id, complaints.text());
  publications_ =
      dds_create_reader(participant_.id, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr);
  discovery_ = add({kDiscoveryTopic, wire_type(kDiscoveryType), type_hash_data(kDiscoveryType)},
                   Direction::out, kDiscoveryQos);
  introduce();
}

Participant::Entity::~Entity() {
  if (id > 0) (void)dds_delete(id);
}

std::vector<SeenTopic> Participant::seen_topics() const {
  std::map<std::string, SeenTopic> topics;
  for_each_publication(
      publications_, guid_of(participant_.id), [&](const dds_builtintopic_endpoint_t& endpoint) {
        SeenTopic topic{topic_of(endpoint.topic_name), io::plain_type_name(endpoint.type_name)};
        if (topic.name.empty()) return;
        dds_reliability_kind_t kind = DDS_RELIABILITY_BEST_EFFORT;
        (void)dds_qget_reliability(endpoint.qos, &kind, nullptr);
        topic.reliable = kind == DDS_RELIABILITY_RELIABLE;
        topics.emplace(topic.name + '\n' + topic.type, topic);
      });
  std::vector<SeenTopic> sorted;
  for (auto& [key, topic] : topics) sorted.push_back(std::move(topic));
  return sorted;
}

Participant::Endpoint Participant::add(const WireTopic& wire, Direction direction,
                                       const TopicQos& qos) const {
  const auto check = [&](dds_return_t result) {
    if (result < 0) {
      throw std::runtime_error("ROS 2 topic " + wire.name + ": " + dds_strretcode(result));
    }
  };
  Endpoint endpoint;
  endpoint.type = make_raw_type(wire.type);
  const dds_entity_t topic = dds_create_topic_sertype(participant_.id, wire.name.c_str(),
                                                      &endpoint.type, nullptr, nullptr, nullptr);
  if (topic < 0) ddsi_sertype_unref(endpoint.type);
  check(topic);
  const Qos settings = qos_of(qos, wire.user_data);
  endpoint.entity = direction == Direction::in
                        ? dds_create_reader(participant_.id, topic, settings.get(), nullptr)
                        : dds_create_writer(participant_.id, topic, settings.get(), nullptr);
  (void)dds_delete(topic);  // lives as long as its endpoint
  check(endpoint.entity);
  return endpoint;
}

Participant::Endpoint Participant::add_reader(const WireTopic& topic, const TopicQos& qos) {
  const Endpoint reader = add(topic, Direction::in, qos);
  const std::lock_guard lock(mutex_);
  readers_.push_back(guid_of(reader.entity));
  introduce();
  return reader;
}

void Participant::remove_reader(const Endpoint& reader) {
  const std::lock_guard lock(mutex_);
  std::erase(readers_, guid_of(reader.entity));
  (void)dds_delete(reader.entity);
  introduce();
}

Participant::Endpoint Participant::add_writer(const WireTopic& topic, const TopicQos& qos) {
  const Endpoint writer = add(topic, Direction::out, qos);
  const std::lock_guard lock(mutex_);
  writers_.push_back(guid_of(writer.entity));
  introduce();
  return writer;
}

bool Participant::write(const Endpoint& writer, std::string_view cdr) {
  return dds_writecdr(writer.entity, make_raw_sample(writer.type, cdr)) >= 0;
}

/// A GID was of 24 bytes until Iron made it 16, the version that began to tell types' hashes.
std::size_t Participant::gid_bytes() const {
  constexpr std::size_t kNew = 16, kOld = 24;
  std::size_t bytes = kNew;
  for_each_publication(publications_, guid_of(participant_.id),
                       [&](const dds_builtintopic_endpoint_t& endpoint) {
                         if (std::string_view(endpoint.topic_name) != kDiscoveryTopic) return;
                         void* data = nullptr;
                         std::size_t size = 0;
                         const bool any = dds_qget_userdata(endpoint.qos, &data, &size);
                         const std::string_view text(static_cast<const char*>(data), size);
                         if (!any || text.find("typehash=") == text.npos) bytes = kOld;
                         dds_free(data);
                       });
  return bytes;
}

/// rmw_dds_common/ParticipantEntitiesInfo: one node, and which endpoints are its.
void Participant::introduce() {
  gid_bytes_ = gid_bytes();
  io::MessageWriter message;
  const auto gid = [&](std::string guid) {
    guid.resize(gid_bytes_, '\0');
    message.raw(guid);
  };
  gid(guid_of(participant_.id));
  message.count(1).string("/").string(options_.node);
  for (const std::vector<std::string>* guids : {&readers_, &writers_}) {
    message.count(guids->size());
    for (const std::string& guid : *guids) gid(guid);
  }
  (void)write(discovery_, message.take());
}

void Participant::refresh() {
  const std::lock_guard lock(mutex_);
  if (gid_bytes() != gid_bytes_) introduce();
}

}  // namespace surefoot::ros2
