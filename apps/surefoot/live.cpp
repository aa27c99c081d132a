// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot live: a sensor's packets or a topic's messages as they come, or a capture at its own
// pace; the same files as of surefoot run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "command_line/option_checks.hpp"
#include "command_line/option_group.hpp"
#include "commands.hpp"
#include "io/robots.hpp"
#include "live/live_health.hpp"
#include "live_runs/live_run.hpp"
#include "text/printable.hpp"
#ifdef SUREFOOT_HAS_LIVE_PAGE
#include "live_page/page_viewer.hpp"
#endif
#include "map_outcome.hpp"
#include "process/build_version.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "recorded_options.hpp"
#include "run_options.hpp"
#include "topic_options.hpp"

namespace surefoot::app {

namespace {

struct LiveArguments {
  live_runs::LiveRequest request;
  std::optional<std::uint16_t> page;  ///< port of it; empty: none
};

/// A robot that is named has a topic of its own.
void complete_source(live::LiveSource& source, const std::string& robot) {
  live::TopicRequest& topics = source.topics;
  const bool has_packets = !source.replay.empty() || !source.follow.empty() || source.udp != 0;
  if (topics.network == "ros2" && topics.topic.empty() && !robot.empty() && !has_packets) {
    topics.topic = io::robot_named(robot).topic;
  }
  if (topics.topic.empty() && !has_packets) {
    throw std::invalid_argument(
        topics.network.empty()
            ? "live: expected --udp PORT, --replay FILE or --follow FILE"
            : fmt::format(
                  "live: expected --udp PORT, --replay FILE, --follow FILE or --{}-topic TOPIC",
                  topics.network));
  }
  const bool of_file = !source.replay.empty() || !source.follow.empty();
  const bool is_kept = source.follow.empty() || std::filesystem::is_regular_file(source.follow);
  if (!source.record.empty() && of_file && is_kept) {
    throw std::invalid_argument(fmt::format("live: --record of what --{} reads would be the same",
                                            source.follow.empty() ? "replay" : "follow"));
  }
}

/// A recording cannot be made again.
void require_new_record(const std::filesystem::path& record, bool overwrite) {
  std::error_code ignored;
  if (!overwrite && std::filesystem::is_regular_file(record, ignored)) {
    throw std::invalid_argument(
        fmt::format("live: {} is there already; --overwrite writes over it", record.string()));
  }
}

void print_end(const live_runs::LiveOutcome& outcome) {
  const live::LiveFigures& figures = outcome.figures;
  fmt::print("{}\n", live::state_text(figures));
  if (outcome.of_topic) {
    fmt::print("{} messages, {} unreadable; {} lost on the way\n", figures.received,
               figures.unreadable, figures.lost);
  } else {
    fmt::print(
        "{} datagrams, {} of them data; {} lost by the sensor's clock, {} by a full socket\n",
        figures.received, figures.packets.data_packets, figures.packets.lost, figures.lost);
  }
  for (const auto& [status, count] : outcome.run.statuses) {
    if (status != Status::ok) fmt::print("  {:5} {}\n", count, to_string(status));
  }
  if (outcome.run.partial > 0) fmt::print("  {:5} partial, left out\n", outcome.run.partial);
  print_frames(outcome.run);
  fmt::print("results: {}\n", text::printable(outcome.run.folder.string()));
}

#ifdef SUREFOOT_HAS_LIVE_PAGE
std::unique_ptr<live::LiveViewer> show_page(live_page::PageSubject subject,
                                            live::CommandQueue& commands,
                                            const live::LiveRecording& recording) {
  auto page = std::make_unique<live_page::PageViewer>(std::move(subject), commands, recording);
  fmt::print(stderr, "page: {}\n", page->address());
  return page;
}
#endif

int run_live(CLI::App& command, LiveArguments& arguments) {
  live_runs::LiveRequest& request = arguments.request;
  complete_source(request.source, request.run.reader.robot);
  if (const std::string& topic = request.source.topics.topic; !topic.empty()) {
    request.run.reader.topic = topic;
  }
  require_new_record(request.source.record, request.run.overwrite);
  const process::InterruptGuard interrupt;
  request.run.given = recorded_options(command);
  const bool quiet = request.run.quiet;
  const auto say = [quiet](const std::string& text) {
    if (!quiet) fmt::print(stderr, "{}\n", text);
  };
  live_runs::LiveListener listener{
      .say = say,
      .complain = [](const std::string& text) { fmt::print(stderr, "{}\n", text); },
      .report = [&](const live::LiveFigures& figures) { say(live::state_text(figures)); },
      .interrupted = [&] { return interrupt.interrupted(); }};
#ifdef SUREFOOT_HAS_LIVE_PAGE
  if (arguments.page) {
    const bool has_map = !request.run.localize.empty();
    listener.watch = [port = *arguments.page, has_map](const std::string& title,
                                                       live::CommandQueue& commands,
                                                       const live::LiveRecording& recording) {
      return show_page({port, title, process::build_version(), has_map}, commands, recording);
    };
  }
#endif
  const live_runs::LiveOutcome outcome = live_runs::run_live(request, listener);
  if (!quiet) print_end(outcome);
  if (outcome.run.poses == 0) {
    throw io::ReadError(fmt::format("{}: none of {} scans could be used; scans.csv in {} says why",
                                    outcome.input.string(), outcome.run.scans(),
                                    outcome.run.folder.string()));
  }
  return say_if_apart(outcome.run) ? process::kSomeFailed : process::kDone;
}

void add_source_options(CLI::App& command, LiveArguments& arguments) {
  live::LiveSource& source = arguments.request.source;
  command_line::OptionGroup group(command, "Source");
  group.add("--udp", source.udp, "port that the sensor sends its packets to")
      ->check(CLI::Range(1, 65535));
  group
      .add("--address", source.address,
           "address of the interface to listen on (default: all of them)")
      ->needs("--udp");
  group.add("--replay", source.replay, "a capture or a bag, played at its own pace, instead")
      ->excludes("--udp");
  group
      .add("--speed", source.speed, "times that pace; 0: as fast as it is used, nothing is dropped")
      ->check(command_line::number_within(0.0, 1000.0))
      ->needs("--replay")
      ->capture_default_str();
  group
      .add("--follow", source.follow,
           "a capture, MCAP or ROS 1 bag that is still written to, or a pipe that a capture comes "
           "through: all of it, and what comes; nothing is dropped")
      ->excludes("--udp")
      ->excludes("--replay");
  group
      .add("--queue", arguments.request.live.queue,
           "scans that may wait; beyond that the oldest is dropped, and told")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  group.add("--record", source.record,
            "also write all packets to this capture, from which the run can be repeated; "
            "of a topic all messages, to an MCAP file (ROS 1: a bag)");
  group
      .add("--silence", arguments.request.live.silence,
           "end so long after the last packet or message [s], however long the first is in coming; "
           "without it Ctrl-C or SIGTERM ends it")
      ->check(command_line::number_within(0.1, 1e6));
}

}  // namespace

void add_live_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<LiveArguments>();
  CLI::App* command =
      app.add_subcommand("live", "Run on a sensor's packets or a topic's messages as they come");
  add_source_options(*command, *arguments);
#ifdef SUREFOOT_HAS_LIVE_PAGE
  command
      ->add_option("--page", arguments->page,
                   "show the run in a browser of this machine, at this port (default: 8017; 0: any "
                   "that is free)")
      ->type_name("[PORT]")
      ->expected(0, 1)
      ->default_str("8017")
      ->check(CLI::Range(0, 65535));
#endif
#ifdef SUREFOOT_HAS_ROS1
  add_ros1_options(*command, arguments->request.source.topics);
#endif
#ifdef SUREFOOT_HAS_ROS2
  add_ros2_options(*command, arguments->request.source.topics);
#endif
  add_run_options(*command, arguments->request.run);
  command->callback(
      [command, arguments, &exit_code] { exit_code = run_live(*command, *arguments); });
}

}  // namespace surefoot::app
