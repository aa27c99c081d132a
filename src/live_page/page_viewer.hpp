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

struct PageSubject {
  std::uint16_t port = 0;  ///< 0: any that is free
  std::string title;
  std::string version;   ///< of the program
  bool has_map = false;  ///< in which the run's place can be searched for
};

class PageViewer final : public live::LiveViewer {
 public:
  /// Commands go to the queue, which has to be closed before this ends. Throws std::runtime_error.
  PageViewer(PageSubject subject, live::CommandQueue& commands,
             const live::LiveRecording& recording);

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
