// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_viewers.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "runs/joined_names.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::app {
namespace {

live_page::PageFigures page_figures(const live::LiveFigures& figures) {
  live_page::PageFigures shown;
  shown.used = figures.used;
  shown.dropped = figures.dropped;
  shown.left_out = figures.paused;
  shown.received = figures.received;
  shown.lost = figures.lost;
  shown.paused = figures.is_paused;
  const std::vector<double>& latencies = figures.latencies_ms;
  if (latencies.empty()) return shown;
  shown.latency_p50_ms = quantile(latencies, 0.5);
  shown.latency_p99_ms = quantile(latencies, 0.99);
  shown.latency_max_ms = *std::max_element(latencies.begin(), latencies.end());
  return shown;
}

live_page::PageOptions options_of(std::uint16_t port, const std::string& title,
                                  live::CommandQueue& commands,
                                  const live::LiveRecording& recording) {
  live_page::PageOptions options;
  options.port = port;
  options.token = live_page::make_token();
  options.title = title;
  options.version = SUREFOOT_VERSION;
  options.commands = {"reset", "pause", "resume", "save_map"};
  options.ask = [&commands](const std::string& command) { return commands.ask(command); };
  options.figures = [&recording] { return page_figures(recording.figures()); };
  return options;
}

}  // namespace

void add_page_option(CLI::App& command, std::optional<std::uint16_t>& port) {
  command
      .add_option("--page", port,
                  "show the run in a browser of this machine, at this port (default: 8017; 0: any "
                  "that is free)")
      ->type_name("[PORT]")
      ->expected(0, 1)
      ->default_str("8017")
      ->check(CLI::Range(0, 65535));
}

LiveViewers::LiveViewers(std::uint16_t port, const std::string& title, live::CommandQueue& commands,
                         const live::LiveRecording& recording)
    : server_(options_of(port, title, commands, recording)) {}

void LiveViewers::answered(const std::string& name, const Estimate& estimate,
                           const Odometry& odometry) {
  scan_.emplace();
  scan_->name = name;
  scan_->stamp_ns = estimate.stamp_ns;
  scan_->status = to_string(estimate.status);
  scan_->message = estimate.message;
  scan_->segment = estimate.segment;
  scan_->T_world_lidar = estimate.T_world_lidar;
  scan_->wrong_probability = estimate.wrong_probability;
  scan_->weak = runs::joined_names(estimate.degenerate);
  cloud_.reset();
  if (!estimate.trusted() || !server_.wants_cloud()) return;
  cloud_ = {odometry.deskewed_scan().points, estimate.T_world_lidar, estimate.segment};
}

void LiveViewers::used(double latency_ms) {
  if (!scan_) return;
  scan_->latency_ms = latency_ms;
  server_.tell(std::move(*scan_), std::exchange(cloud_, std::nullopt));
  scan_.reset();
}

}  // namespace surefoot::app
