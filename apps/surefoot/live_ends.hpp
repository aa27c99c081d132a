// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What surefoot live reads from and publishes to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "io/bags/bag_writer.hpp"
#include "live/command_queue.hpp"
#include "live/live_recording.hpp"
#include "runs/run_options.hpp"
#ifdef SUREFOOT_HAS_ROS1
#include "ros1/trigger_services.hpp"
#include "ros1_options.hpp"
#endif
#ifdef SUREFOOT_HAS_ROS2
#include "ros2/command_server.hpp"
#include "ros2_options.hpp"
#endif

namespace surefoot::app {

struct LiveArguments {
  runs::RunOptions run;
  live::LiveOptions live;
  std::uint16_t udp = 0;
  std::string address;
  std::filesystem::path replay;
  double speed = 1.0;
  std::filesystem::path record;
  std::optional<std::uint16_t> page;  ///< port of it; empty: none
#ifdef SUREFOOT_HAS_ROS1
  Ros1Arguments ros1;
#endif
#ifdef SUREFOOT_HAS_ROS2
  Ros2Arguments ros2;
#endif
};

/// Where scans come from and where messages go.
struct Ends {
  std::unique_ptr<live::ScanStream> stream;
  std::shared_ptr<io::BagWriter> messages;  ///< null: nowhere
  bool of_topic = false;
#ifdef SUREFOOT_HAS_ROS1
  std::unique_ptr<ros1::TriggerServices> ros1_commands;
#endif
#ifdef SUREFOOT_HAS_ROS2
  std::unique_ptr<ros2::CommandServer> commands;
#endif
};

/// Throws std::invalid_argument where no source is named, or too many are.
void check_source(LiveArguments& arguments);
/// Opens them, and notes in the run's options what repeats it; commands of others go to the queue,
/// which has to outlive them. Throws io::ReadError, std::runtime_error.
[[nodiscard]] Ends ends_of(LiveArguments& arguments, live::CommandQueue& commands);

}  // namespace surefoot::app
