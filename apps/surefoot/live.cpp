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
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "commands.hpp"
#include "live/command_queue.hpp"
#include "live/live_health.hpp"
#include "live/live_recording.hpp"
#include "live_ends.hpp"
#ifdef SUREFOOT_HAS_LIVE_PAGE
#include "live_viewers.hpp"
#endif
#include "command_line/option_checks.hpp"
#include "command_line/option_group.hpp"
#include "map_outcome.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "recorded_options.hpp"
#include "run_options.hpp"
#include "runs/odometry_run.hpp"
#include "runs/run_bag.hpp"
#include "runs/run_files.hpp"

namespace surefoot::app {

namespace {

using Clock = std::chrono::steady_clock;

void print_end(const live::LiveFigures& figures, const runs::RunOutcome& outcome, bool of_topic) {
  fmt::print("{}\n", live::state_text(figures));
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

live::CommandAnswer execute(const std::string& command, live::LiveRecording& recording,
                            runs::RunControl& run) {
  if (command == "pause" || command == "resume") {
    recording.pause(command == "pause");
    return {true, command == "pause" ? "scans are left out" : "scans are used"};
  }
  if (command == "save_map") return {true, std::filesystem::absolute(run.save_map()).string()};
  if (command == "localize" || command.starts_with("localize ")) {
    run.localize(command.substr(std::min<std::size_t>(command.size(), 9)));
    return {true, "its place in the map is searched for"};
  }
  if (command != "reset") return {false, command + " is not known"};
  recording.log().reset();
  run.reset();
  return {true, "the odometry begins anew with the next scan"};
}

int run_live(CLI::App& command, LiveArguments& arguments) {
  check_source(arguments);
  (void)runs::config_of(arguments.run);
  const process::InterruptGuard interrupt;
  arguments.run.given = recorded_options(command);
  arguments.live.stopped = [&] { return interrupt.interrupted(); };
  live::CommandQueue commands;
  Ends ends = ends_of(arguments, commands);
  std::function<void()> work = [] {};
  std::optional<live::HealthPublisher> publisher;
  std::function<void()> tell_health = [] {};
  arguments.live.idle = [&] {
    work();
    tell_health();
  };
  live::LiveRecording recording(std::move(ends.stream), arguments.live);
  if (ends.messages) {
    (void)runs::add_run_topics(*ends.messages);
    publisher.emplace(ends.messages);
    tell_health = [&] { publisher->tell(recording.figures()); };
  }
  std::function<void(const std::string&, const Estimate&, const Odometry&)> answered;
#ifdef SUREFOOT_HAS_LIVE_PAGE
  std::optional<LiveViewers> viewers;
  if (arguments.page) {
    viewers.emplace(*arguments.page, arguments.run.input.filename().string(), commands, recording);
    fmt::print(stderr, "page: {}\n", viewers->address());
    answered = std::bind_front(&LiveViewers::answered, &*viewers);
  }
#endif
  // Whoever still waits for an answer is told before the server that waits for it ends.
  const std::shared_ptr<void> at_end(nullptr, [&](void*) { commands.close(); });

  const bool quiet = arguments.run.quiet;
  Clock::time_point told = Clock::now();
  const auto say = [&](const std::string& text) {
    if (!quiet) fmt::print(stderr, "{}\n", text);
  };
  const auto progress = [&](std::size_t, double) {
    [[maybe_unused]] const double latency_ms = recording.done();
#ifdef SUREFOOT_HAS_LIVE_PAGE
    if (viewers) viewers->used(latency_ms);
#endif
    work();
    tell_health();
    constexpr auto kPeriod = std::chrono::seconds(10);
    if (quiet || Clock::now() - told < kPeriod) return;
    told = Clock::now();
    say(live::state_text(recording.figures()));
  };
  const auto started = [&](const std::filesystem::path& folder, runs::RunControl& run) {
    work = [&] {
      commands.work([&](const std::string& one) { return execute(one, recording, run); });
    };
    const std::filesystem::path log = folder / runs::kLiveLogFile;
    recording.log().open(log);
    arguments.run.given.emplace_back("like", std::filesystem::absolute(log).string());
  };
  // Ctrl-C ends the stream, not the run: what was received is used.
  const runs::RunOutcome outcome = runs::run_odometry(
      arguments.run, {say, progress, [] { return false; }, started, answered, ends.messages},
      recording);
  if (!quiet) print_end(recording.figures(), outcome, ends.of_topic);
  if (outcome.poses == 0) {
    throw io::ReadError(fmt::format("{}: none of {} scans could be used; scans.csv in {} says why",
                                    arguments.run.input.string(), outcome.scans(),
                                    outcome.folder.string()));
  }
  return say_if_apart(outcome) ? process::kSomeFailed : process::kDone;
}

void add_source_options(CLI::App& command, LiveArguments& arguments) {
  command_line::OptionGroup group(command, "Source");
  group.add("--udp", arguments.udp, "port that the sensor sends its packets to")
      ->check(CLI::Range(1, 65535));
  group
      .add("--address", arguments.address,
           "address of the interface to listen on (default: all of them)")
      ->needs("--udp");
  group.add("--replay", arguments.replay, "a capture or a bag, played at its own pace, instead")
      ->excludes("--udp");
  group
      .add("--speed", arguments.speed,
           "times that pace; 0: as fast as it is used, nothing is dropped")
      ->check(command_line::number_within(0.0, 1000.0))
      ->needs("--replay")
      ->capture_default_str();
  group
      .add("--queue", arguments.live.queue,
           "scans that may wait; beyond that the oldest is dropped, and told")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  group.add("--record", arguments.record,
            "also write all packets to this capture, from which the run can be repeated; "
            "of a topic all messages, to an MCAP file (ROS 1: a bag)");
  group
      .add("--silence", arguments.live.silence,
           "end after so long without a packet or message [s]; without it Ctrl-C or SIGTERM "
           "ends it")
      ->check(command_line::number_within(0.1, 1e6));
}

}  // namespace

void add_live_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<LiveArguments>();
  CLI::App* command =
      app.add_subcommand("live", "Run on a sensor's packets or a topic's messages as they come");
  add_source_options(*command, *arguments);
#ifdef SUREFOOT_HAS_LIVE_PAGE
  add_page_option(*command, arguments->page);
#endif
#ifdef SUREFOOT_HAS_ROS1
  add_ros1_options(*command, arguments->ros1);
#endif
#ifdef SUREFOOT_HAS_ROS2
  add_ros2_options(*command, arguments->ros2);
#endif
  add_run_options(*command, arguments->run);
  command->callback(
      [command, arguments, &exit_code] { exit_code = run_live(*command, *arguments); });
}

}  // namespace surefoot::app
