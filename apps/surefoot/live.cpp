// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot live: a sensor's packets as they come, or a capture at its own pace; the same files as
// of surefoot run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

#include "commands.hpp"
#include "evaluation/statistics.hpp"
#include "live/live_recording.hpp"
#include "option_checks.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "recorded_options.hpp"
#include "run_options.hpp"
#include "runs/odometry_run.hpp"

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
};

std::string latency_text(const live::LiveFigures& figures) {
  const std::vector<double>& latencies = figures.latencies_ms;
  if (latencies.empty()) return "no scan was used";
  return fmt::format("from last packet to pose {:.1f} ms median, {:.1f} ms p99, {:.1f} ms at most",
                     evaluation::quantile(latencies, 0.5), evaluation::quantile(latencies, 0.99),
                     *std::max_element(latencies.begin(), latencies.end()));
}

std::string state_text(const live::LiveFigures& figures) {
  return fmt::format("{} scans, {} dropped; {}", figures.used, figures.dropped,
                     latency_text(figures));
}

void print_end(const live::LiveFigures& figures, const runs::RunOutcome& outcome) {
  fmt::print("{}\n", state_text(figures));
  fmt::print("{} datagrams, {} of them data; {} lost by the sensor's clock, {} by a full socket\n",
             figures.datagrams, figures.packets.data_packets, figures.packets.lost,
             figures.overflowed);
  for (const auto& [status, count] : outcome.statuses) {
    if (status != Status::ok) fmt::print("  {:5} {}\n", count, to_string(status));
  }
  if (outcome.partial > 0) fmt::print("  {:5} partial, left out\n", outcome.partial);
  fmt::print("results: {}\n", outcome.folder.string());
}

std::unique_ptr<live::DatagramSource> source_of(LiveArguments& arguments) {
  if (!arguments.replay.empty()) {
    arguments.run.input = arguments.replay;
    return live::replay_capture(arguments.replay, arguments.speed);
  }
  arguments.run.is_live = arguments.live.record.empty();
  arguments.run.input = arguments.run.is_live
                            ? std::filesystem::path(fmt::format("udp-{}", arguments.udp))
                            : arguments.live.record;
  return live::listen_udp(arguments.address, arguments.udp);
}

/// An Ouster's packets are not understood without what it says about itself.
std::string metadata_of(const LiveArguments& arguments) {
  std::filesystem::path file = arguments.replay;
  std::ifstream stream(file.replace_extension(".json"), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

int run_live(CLI::App& command, LiveArguments& arguments) {
  if (arguments.replay.empty() == (arguments.udp == 0)) {
    throw std::invalid_argument("live: expected either --udp PORT or --replay CAPTURE");
  }
  (void)runs::config_of(arguments.run);
  const process::InterruptGuard interrupt;
  arguments.run.given = recorded_options(command);
  arguments.run.given.emplace_back("repair-stamps", "false");  // which would wait for two scans
  arguments.live.reader = arguments.run.reader;
  arguments.live.stopped = [&] { return interrupt.interrupted(); };
  if (!arguments.replay.empty()) arguments.live.metadata = metadata_of(arguments);
  live::LiveRecording recording(source_of(arguments), arguments.live);

  const bool quiet = arguments.run.quiet;
  Clock::time_point told = Clock::now();
  const auto say = [&](const std::string& text) {
    if (!quiet) fmt::print(stderr, "{}\n", text);
  };
  const auto progress = [&](std::size_t, double) {
    recording.done();
    constexpr auto kPeriod = std::chrono::seconds(10);
    if (quiet || Clock::now() - told < kPeriod) return;
    told = Clock::now();
    say(state_text(recording.figures()));
  };
  const auto started = [&](const std::filesystem::path& folder) {
    const std::filesystem::path log = folder / live::kLogFile;
    recording.log().open(log);
    arguments.run.given.emplace_back("like", std::filesystem::absolute(log).string());
  };
  // Ctrl-C ends the stream, not the run: what was received is used.
  const runs::RunOutcome outcome =
      runs::run_odometry(arguments.run, {say, progress, [] { return false; }, started}, recording);
  if (!quiet) print_end(recording.figures(), outcome);
  if (outcome.poses == 0) {
    throw io::ReadError(fmt::format("{}: none of {} scans could be used; scans.csv in {} says why",
                                    arguments.run.input.string(), outcome.scans(),
                                    outcome.folder.string()));
  }
  return process::kDone;
}

void add_source_options(CLI::App& command, LiveArguments& arguments) {
  constexpr const char* kGroup = "Source";
  command.add_option("--udp", arguments.udp, "port that the sensor sends its packets to")
      ->check(CLI::Range(1, 65535))
      ->group(kGroup);
  command
      .add_option("--address", arguments.address,
                  "address of the interface to listen on (default: all of them)")
      ->needs("--udp")
      ->group(kGroup);
  command.add_option("--replay", arguments.replay, "a capture, played at its own pace, instead")
      ->excludes("--udp")
      ->group(kGroup);
  command
      .add_option("--speed", arguments.speed,
                  "times that pace; 0: as fast as it is used, nothing is dropped")
      ->check(number_within(0.0, 1000.0))
      ->needs("--replay")
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option("--queue", arguments.live.queue,
                  "scans that may wait; beyond that the oldest is dropped, and told")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option("--record", arguments.live.record,
                  "also write all packets to this capture, from which the run can be repeated")
      ->needs("--udp")
      ->group(kGroup);
  command
      .add_option("--silence", arguments.live.silence,
                  "end after so long without a packet [s]; without it Ctrl-C or SIGTERM ends it")
      ->check(number_within(0.1, 1e6))
      ->group(kGroup);
}

}  // namespace

void add_live_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<LiveArguments>();
  CLI::App* command =
      app.add_subcommand("live", "Run on a sensor's packets as they come, or a capture's");
  add_source_options(*command, *arguments);
  add_run_options(*command, arguments->run);
  command->callback(
      [command, arguments, &exit_code] { exit_code = run_live(*command, *arguments); });
}

}  // namespace surefoot::app
