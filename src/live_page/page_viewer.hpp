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
#include "live/live_viewer.hpp"
#include "live_page/page_server.hpp"

namespace surefoot::live_page {

class PageViewer final : public live::LiveViewer {
 public:
  /// Commands go to the queue, which has to be closed before this ends. Throws std::runtime_error.
  PageViewer(std::uint16_t port, const std::string& title, const std::string& version,
             live::CommandQueue& commands, const live::LiveRecording& recording);

  /// Where the page is, with the token that commands need.
  [[nodiscard]] std::string address() const { return server_.address(); }
  void answered(const std::string& name, const Estimate& estimate,
                const Odometry& odometry) override;
  void used(double latency_ms) override;

 private:
  PageServer server_;
  std::optional<PageScan> scan_;
  std::optional<PageCloud> cloud_;
};

}  // namespace surefoot::live_page
