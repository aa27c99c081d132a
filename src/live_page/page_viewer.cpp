// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_page/page_viewer.hpp"

#include <algorithm>
#include <utility>

#include "report/joined_names.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::live_page {
namespace {

PageFigures page_figures(const live::LiveFigures& figures) {
  PageFigures shown;
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

PageOptions options_of(PageSubject subject, live::CommandQueue& commands,
                       const live::LiveRecording& recording) {
  PageOptions options;
  options.port = subject.port;
  options.token = make_token();
  options.title = std::move(subject.title);
  options.version = std::move(subject.version);
  options.commands = {"reset", "pause", "resume", "save_map"};
  if (subject.has_map) options.commands.emplace_back("localize");
  options.ask = [&commands](const std::string& command) { return commands.ask(command); };
  options.figures = [&recording] { return page_figures(recording.figures()); };
  return options;
}

}  // namespace

PageViewer::PageViewer(PageSubject subject, live::CommandQueue& commands,
                       const live::LiveRecording& recording)
    : server_(options_of(std::move(subject), commands, recording)) {}

void PageViewer::answered(const std::string& name, const Estimate& estimate,
                          const Odometry& odometry) {
  scan_.emplace();
  scan_->name = name;
  scan_->stamp_ns = estimate.stamp_ns;
  scan_->status = to_string(estimate.status);
  scan_->message = estimate.message;
  scan_->segment = estimate.segment;
  scan_->T_world_lidar = estimate.T_world_lidar;
  scan_->wrong_probability = estimate.wrong_probability;
  scan_->weak = report::joined_names(estimate.degenerate);
  cloud_.reset();
  if (!estimate.trusted() || !server_.wants_cloud()) return;
  cloud_ = {odometry.deskewed_scan().points, estimate.T_world_lidar, estimate.segment};
}

void PageViewer::used(double latency_ms) {
  if (!scan_) return;
  scan_->latency_ms = latency_ms;
  server_.tell(std::move(*scan_), std::exchange(cloud_, std::nullopt));
  scan_.reset();
}

}  // namespace surefoot::live_page
