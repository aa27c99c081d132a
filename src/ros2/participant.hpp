// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Who takes part in a domain: the ROS 2 node that Surefoot is to the others.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/names.hpp"

struct ddsi_sertype;

namespace surefoot::ros2 {

struct ParticipantOptions {
  int domain = 0;         ///< 0..232
  std::string interface;  ///< its name or address; empty: CYCLONEDDS_URI's, or Cyclone's choice
  std::vector<std::string> peers;  ///< addresses to look for others at, where multicast is missing
  std::string node = "surefoot";
};

struct TopicQos {
  bool reliable = true;
  int depth = 10;        ///< of the last messages
  bool latched = false;  ///< who comes late gets them, too: "transient local"
  /// Up to a tenth of a second where who listens reliably has too much left to take; false: such a
  /// message is not sent.
  bool waits = true;
};

/// A topic that somebody publishes.
struct SeenTopic {
  std::string name;  ///< "/points"
  std::string type;  ///< "sensor_msgs/PointCloud2"
  bool reliable = false;
};

class Participant {
 public:
  /// Throws std::runtime_error that names domain and interface, std::invalid_argument for a node
  /// of no name.
  explicit Participant(const ParticipantOptions& options);

  /// Of others, by name; those that are no ROS 2 topics are left out.
  [[nodiscard]] std::vector<SeenTopic> seen_topics() const;

  /// An endpoint, and the type that its samples are made of. Throws std::runtime_error.
  struct Endpoint {
    int entity = 0;  ///< dds_entity_t
    ddsi_sertype* type = nullptr;
  };
  [[nodiscard]] Endpoint add_reader(const WireTopic& topic, const TopicQos& qos);
  void remove_reader(const Endpoint& reader);
  [[nodiscard]] Endpoint add_writer(const WireTopic& topic, const TopicQos& qos);
  /// Of a writer's. False where it did not go out.
  static bool write(const Endpoint& writer, std::string_view cdr);

  /// Tells again who it is where the others turn out to be older or newer than they seemed.
  void refresh();
  [[nodiscard]] int domain() const { return options_.domain; }

 private:
  enum class Direction { in, out };
  [[nodiscard]] Endpoint add(const WireTopic& topic, Direction direction,
                             const TopicQos& qos) const;
  void introduce();
  [[nodiscard]] std::size_t gid_bytes() const;

  /// A dds_entity_t, deleted with all that was made of it.
  struct Entity {
    int id = 0;
    Entity() = default;
    ~Entity();
    Entity(const Entity&) = delete;
    Entity& operator=(const Entity&) = delete;
  };

  ParticipantOptions options_;
  Entity domain_, participant_;
  int publications_ = 0;                        ///< a dds_entity_t: reads what others write
  Endpoint discovery_;                          ///< writes what `ros2 node list` shows
  std::mutex mutex_;                            ///< of what follows
  std::vector<std::string> readers_, writers_;  ///< their GUIDs
  std::size_t gid_bytes_ = 0;                   ///< as last told
};

}  // namespace surefoot::ros2
