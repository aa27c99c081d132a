// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "live/command_queue.hpp"
#include "live_page/page_gate.hpp"
#include "live_page/page_history.hpp"

namespace surefoot::live_page {

/// What the connections of a server share. All of it on the server's thread.
class SessionHost {
 public:
  virtual ~SessionHost() = default;
  [[nodiscard]] virtual const PageGate& gate() const = 0;
  [[nodiscard]] virtual const std::string& page() const = 0;
  /// What this viewer has yet to be told, as JSON; empty where that is nothing.
  [[nodiscard]] virtual std::string news(Told& told, std::uint64_t& version) const = 0;
  /// Answers later, on this thread.
  virtual void ask(const std::string& command,
                   std::function<void(const live::CommandAnswer&)> answer) = 0;
  virtual void count_session(int more) = 0;
};

/// A connection: one request, and its answer or the stream of news. Lives as long as something is
/// under way for it.
class PageSession : public std::enable_shared_from_this<PageSession> {
 public:
  PageSession(boost::asio::ip::tcp::socket socket, SessionHost& host);
  ~PageSession();
  PageSession(const PageSession&) = delete;
  PageSession& operator=(const PageSession&) = delete;

  void start();
  /// Tells a viewer what is new, unless it still has to take what it was told before.
  void offer();

 private:
  void answer(const Request& request);
  void respond(unsigned status, const char* type, std::string body);
  void execute(const std::string& command);
  void begin_stream();
  void wait_for_end();
  void write(std::string text);
  void close();

  boost::beast::tcp_stream stream_;
  SessionHost& host_;
  boost::beast::flat_buffer buffer_;
  boost::beast::http::request_parser<boost::beast::http::string_body> parser_;
  std::string response_;
  bool watches_ = false;
  bool is_writing_ = false;
  Told told_;
  std::uint64_t version_ = 0;
  std::array<char, 64> ignored_;
};

}  // namespace surefoot::live_page
