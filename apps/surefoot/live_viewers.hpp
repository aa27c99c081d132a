// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A live run's page in the browser, told of every scan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "live/command_queue.hpp"
#include "live/live_recording.hpp"
#include "live_page/page_server.hpp"
#include "surefoot/odometry.hpp"

namespace CLI {
class App;
}

namespace surefoot::app {

/// `port` stays empty where no page is wanted.
void add_page_option(CLI::App& command, std::optional<std::uint16_t>& port);

class LiveViewers {
 public:
  /// Commands go to the queue, which has to be closed before this ends. Throws std::runtime_error.
  LiveViewers(std::uint16_t port, const std::string& title, live::CommandQueue& commands,
              const live::LiveRecording& recording);

  /// Where the page is, with the token that commands need.
  [[nodiscard]] std::string address() const { return server_.address(); }
  /// On the run's thread: a scan's answer, and what `odometry` has of it yet.
  void answered(const std::string& name, const Estimate& estimate, const Odometry& odometry);
  /// Its pose is written: it is shown.
  void used(double latency_ms);

 private:
  live_page::PageServer server_;
  std::optional<live_page::PageScan> scan_;
  std::optional<live_page::PageCloud> cloud_;
};

}  // namespace surefoot::app
