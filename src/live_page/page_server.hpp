// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A live run in a browser of the same machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live/command_queue.hpp"
#include "live_page/page_scan.hpp"

namespace surefoot::live_page {

/// 128 random bits, in hexadecimal.
[[nodiscard]] std::string make_token();

struct PageOptions {
  std::uint16_t port = 0;  ///< 0: any that is free
  std::string token;       ///< whoever changes something has to know it
  std::string title;
  std::string version;                ///< of the program
  std::vector<std::string> commands;  ///< that may be asked for
  /// Both are called on threads of the server.
  std::function<live::CommandAnswer(const std::string& command)> ask;
  std::function<PageFigures()> figures;  ///< once a second
};

/// Serves the page on 127.0.0.1 and tells whoever looks at it what is new, five times a second.
/// What a viewer has not taken yet is not kept for it: its next message is of what is new then, and
/// one that takes nothing for half a minute is let go. Two threads of its own.
class PageServer {
 public:
  /// Throws std::runtime_error naming the port and why it cannot be had.
  explicit PageServer(PageOptions options);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  /// Where the page is, with the token.
  [[nodiscard]] std::string address() const;

  /// Never waits for a viewer, nor for what is done with it: of clouds the newest alone is kept
  /// until then.
  void tell(PageScan scan, std::optional<PageCloud> cloud);
  /// Whether the last cloud was taken: another one would be drawn.
  [[nodiscard]] bool wants_cloud() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot::live_page
