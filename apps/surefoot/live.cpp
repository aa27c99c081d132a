// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot live: a sensor's packets or a topic's messages as they come, or a capture at its own
// pace; the same files as of surefoot run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "io/robots.hpp"
#include "live/command_queue.hpp"
#include "live/live_recording.hpp"
#include "live_figures.hpp"
#include "option_checks.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "recorded_options.hpp"
#include "run_options.hpp"
#include "runs/odometry_run.hpp"
#ifdef SUREFOOT_HAS_ROS2
#include "ros2/command_server.hpp"
#include "ros2/topic_publisher.hpp"
#include "ros2/topic_subscription.hpp"
#include "ros2_options.hpp"
#endif

namespace surefoot::app {

namespace {

using Clock = std::chrono::steady_clock;

struct LiveArguments {
  runs::RunOptions run;
  live::LiveOptions live;
  std::uint16_t udp = 0;
  std::string address;
  std::filesystem::path replay;
  double speed = 1.0;
  std::filesystem::path record;
#ifdef SUREFOOT_HAS_ROS2
  Ros2Arguments ros2;
#endif
};

void print_end(const live::LiveFigures& figures, const runs::RunOutcome& outcome, bool of_topic) {
  fmt::print("{}\n", state_text(figures));
  if (of_topic) {
    fmt::print("{} messages, {} unreadable; {} lost on the way\n", figures.received,
               figures.unreadable, figures.lost);
  } else {
    fmt::print(
        "{} datagrams, {} of them data; {} lost by the sensor's clock, {} by a full socket\n",
        figures.received, figures.packets.data_packets, figures.packets.lost, figures.lost);
  }
  for (const auto& [status, count] : outcome.statuses) {
    if (status != Status::ok) fmt::print("  {:5} {}\n", count, to_string(status));
  }
  if (outcome.partial > 0) fmt::print("  {:5} partial, left out\n", outcome.partial);
  fmt::print("results: {}\n", outcome.folder.string());
}

/// An Ouster's packets are not understood without what it says about itself.
std::string metadata_of(const LiveArguments& arguments) {
  std::filesystem::path file = arguments.replay;
  std::ifstream stream(file.replace_extension(".json"), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What is not kept has a name, but cannot be opened again.
void name_input(LiveArguments& arguments, const std::string& name) {
  arguments.run.is_live = arguments.record.empty();
  arguments.run.input = arguments.run.is_live ? std::filesystem::path(name) : arguments.record;
}

std::unique_ptr<live::ScanStream> packets_of(LiveArguments& arguments) {
  arguments.run.given.emplace_back("repair-stamps", "false");  // which would wait for two scans
  if (!arguments.replay.empty()) {
    arguments.run.input = arguments.replay;
    return live::packet_stream(live::replay_capture(arguments.replay, arguments.speed),
                               arguments.run.reader, metadata_of(arguments), {});
  }
  name_input(arguments, fmt::format("udp-{}", arguments.udp));
  return live::packet_stream(live::listen_udp(arguments.address, arguments.udp),
                             arguments.run.reader, "", arguments.record);
}

#ifdef SUREFOOT_HAS_ROS2
std::unique_ptr<live::ScanStream> messages_of(LiveArguments& arguments,
                                              std::shared_ptr<ros2::Participant> participant) {
  if (!arguments.record.empty() && arguments.record.extension() != ".mcap") {
    throw std::invalid_argument("live: messages are recorded as MCAP: --record expects FILE.mcap");
  }
  std::string name = "ros2" + arguments.ros2.topic;
  std::replace(name.begin(), name.end(), '/', '-');
  name_input(arguments, name);
  io::OpenOptions& reader = arguments.run.reader;
  reader = io::with_robot(reader);
  if (!std::exchange(reader.repair_at_once, true) || !reader.robot.empty()) {
    arguments.run.given.emplace_back("repair-at-once", "true");
  }
  const auto say = [quiet = arguments.run.quiet](const std::string& text) {
    if (!quiet) fmt::print(stderr, "note: {}\n", text);
  };
  return live::topic_stream(
      ros2::subscribe(std::move(participant), {arguments.ros2.topic, arguments.ros2.reliable, say}),
      reader, arguments.record);
}
#endif

[[maybe_unused]] std::vector<std::string> command_names() {
  return {"reset", "pause", "resume", "save_map"};
}

live::CommandAnswer execute(const std::string& command, live::LiveRecording& recording,
                            runs::RunControl& run) {
  if (command == "pause" || command == "resume") {
    recording.pause(command == "pause");
    return {true, command == "pause" ? "scans are left out" : "scans are used"};
  }
  if (command == "save_map") return {true, std::filesystem::absolute(run.save_map()).string()};
  if (command != "reset") return {false, command + " is not known"};
  recording.log().reset();
  run.reset();
  return {true, "the odometry begins anew with the next scan"};
}

/// Where scans come from and where messages go.
struct Ends {
  std::unique_ptr<live::ScanStream> stream;
  std::shared_ptr<io::BagWriter> messages;  ///< null: nowhere
  bool of_topic = false;
#ifdef SUREFOOT_HAS_ROS2
  std::unique_ptr<ros2::CommandServer> commands;
#endif
};

Ends ends_of(LiveArguments& arguments, [[maybe_unused]] live::CommandQueue& commands) {
  Ends ends;
#ifdef SUREFOOT_HAS_ROS2
  std::shared_ptr<ros2::Participant> participant;
  if (arguments.ros2.any()) {
    participant = std::make_shared<ros2::Participant>(arguments.ros2.participant);
  }
  if (arguments.ros2.publish) ends.messages = ros2::publish(participant);
  if (arguments.ros2.commands) {
    ends.commands = std::make_unique<ros2::CommandServer>(
        participant, command_names(),
        [&](const std::string& command) { return commands.ask(command); });
  }
  ends.of_topic = !arguments.ros2.topic.empty();
  if (ends.of_topic) {
    ends.stream = messages_of(arguments, participant);
    return ends;
  }
#endif
  ends.stream = packets_of(arguments);
  return ends;
}

void check_source(LiveArguments& arguments) {
  bool has_topic = false;
  const bool has_packets = !arguments.replay.empty() || arguments.udp != 0;
#ifdef SUREFOOT_HAS_ROS2
  std::string& topic = arguments.ros2.topic;
  const std::string& robot = arguments.run.reader.robot;
  if (topic.empty() && !robot.empty() && !has_packets) topic = io::robot_named(robot).topic;
  has_topic = !topic.empty();
  constexpr const char* kExpected =
      "live: expected --udp PORT, --replay CAPTURE or --ros2-topic TOPIC";
#else
  constexpr const char* kExpected = "live: expected --udp PORT or --replay CAPTURE";
#endif
  if (!has_topic && !has_packets) throw std::invalid_argument(kExpected);
  if (!arguments.record.empty() && !arguments.replay.empty()) {
    throw std::invalid_argument("live: --record of what --replay plays would be that capture");
  }
}

int run_live(CLI::App& command, LiveArguments& arguments) {
  check_source(arguments);
  (void)runs::config_of(arguments.run);
  const process::InterruptGuard interrupt;
  arguments.run.given = recorded_options(command);
  arguments.live.stopped = [&] { return interrupt.interrupted(); };
  live::CommandQueue commands;
  Ends ends = ends_of(arguments, commands);
  // Whoever still waits for an answer is told before the server that waits for it ends.
  const std::shared_ptr<void> at_end(nullptr, [&](void*) { commands.close(); });
  std::function<void()> work = [] {};
  arguments.live.idle = [&] { work(); };
  live::LiveRecording recording(std::move(ends.stream), arguments.live);
  std::optional<LivePublisher> publisher;
  if (ends.messages) publisher.emplace(ends.messages);

  const bool quiet = arguments.run.quiet;
  Clock::time_point told = Clock::now();
  const auto say = [&](const std::string& text) {
    if (!quiet) fmt::print(stderr, "{}\n", text);
  };
  const auto progress = [&](std::size_t, double) {
    recording.done();
    work();
    if (publisher) publisher->tell(recording.figures());
    constexpr auto kPeriod = std::chrono::seconds(10);
    if (quiet || Clock::now() - told < kPeriod) return;
    told = Clock::now();
    say(state_text(recording.figures()));
  };
  const auto started = [&](const std::filesystem::path& folder, runs::RunControl& run) {
    work = [&] {
      commands.work([&](const std::string& one) { return execute(one, recording, run); });
    };
    const std::filesystem::path log = folder / live::kLogFile;
    recording.log().open(log);
    arguments.run.given.emplace_back("like", std::filesystem::absolute(log).string());
  };
  // Ctrl-C ends the stream, not the run: what was received is used.
  const runs::RunOutcome outcome = runs::run_odometry(
      arguments.run, {say, progress, [] { return false; }, started, ends.messages}, recording);
  if (!quiet) print_end(recording.figures(), outcome, ends.of_topic);
  if (outcome.poses == 0) {
    throw io::ReadError(fmt::format("{}: none of {} scans could be used; scans.csv in {} says why",
                                    arguments.run.input.string(), outcome.scans(),
                                    outcome.folder.string()));
  }
  return process::kDone;
}

void add_source_options(CLI::App& command, LiveArguments& arguments) {
  constexpr const char* kSourceGroup = "Source";
  command.add_option("--udp", arguments.udp, "port that the sensor sends its packets to")
      ->check(CLI::Range(1, 65535))
      ->group(kSourceGroup);
  command
      .add_option("--address", arguments.address,
                  "address of the interface to listen on (default: all of them)")
      ->needs("--udp")
      ->group(kSourceGroup);
  command.add_option("--replay", arguments.replay, "a capture, played at its own pace, instead")
      ->excludes("--udp")
      ->group(kSourceGroup);
  command
      .add_option("--speed", arguments.speed,
                  "times that pace; 0: as fast as it is used, nothing is dropped")
      ->check(number_within(0.0, 1000.0))
      ->needs("--replay")
      ->capture_default_str()
      ->group(kSourceGroup);
  command
      .add_option("--queue", arguments.live.queue,
                  "scans that may wait; beyond that the oldest is dropped, and told")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str()
      ->group(kSourceGroup);
  command
      .add_option("--record", arguments.record,
                  "also write all packets to this capture, from which the run can be repeated; "
                  "of a topic all messages, to an MCAP file")
      ->group(kSourceGroup);
  command
      .add_option("--silence", arguments.live.silence,
                  "end after so long without a packet or message [s]; without it Ctrl-C or SIGTERM "
                  "ends it")
      ->check(number_within(0.1, 1e6))
      ->group(kSourceGroup);
}

}  // namespace

void add_live_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<LiveArguments>();
  CLI::App* command =
      app.add_subcommand("live", "Run on a sensor's packets or a topic's messages as they come");
  add_source_options(*command, *arguments);
#ifdef SUREFOOT_HAS_ROS2
  add_ros2_options(*command, arguments->ros2);
#endif
  add_run_options(*command, arguments->run);
  command->callback(
      [command, arguments, &exit_code] { exit_code = run_live(*command, *arguments); });
}

}  // namespace surefoot::app
