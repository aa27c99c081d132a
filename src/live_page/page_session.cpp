// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_page/page_session.hpp"

#include <boost/asio/write.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/status.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

namespace surefoot::live_page {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using Error = boost::beast::error_code;

constexpr std::size_t kMostHeader = 8192;  // [bytes]
constexpr int kMostUnsent = 1 << 16;       // [bytes]
constexpr std::size_t kMostBody = 1024;    // [bytes]
constexpr std::chrono::seconds kLongestRequest(10);
constexpr std::chrono::seconds kLongestWrite(30);

constexpr const char* kText = "text/plain; charset=utf-8";

/// Not HTTP, or more of it than anything here takes.
bool is_malformed(const Error& error) {
  const Error end = http::error::end_of_stream;
  return error.category() == end.category() && error != end;
}

std::string head(unsigned status, const std::string& type) {
  const boost::beast::string_view reason = http::obsolete_reason(http::int_to_status(status));
  return "HTTP/1.1 " + std::to_string(status) + " " + std::string(reason.data(), reason.size()) +
         "\r\nContent-Type: " + type +
         "\r\nCache-Control: no-store"
         "\r\nX-Content-Type-Options: nosniff"
         "\r\nReferrer-Policy: no-referrer"
         "\r\nCross-Origin-Resource-Policy: same-origin"
         "\r\nContent-Security-Policy: frame-ancestors 'none'"
         "\r\nConnection: close\r\n";
}

}  // namespace

PageSession::PageSession(asio::ip::tcp::socket socket, SessionHost& host)
    : stream_(std::move(socket)), host_(host) {
  // What the system keeps for a slow viewer is old when it is taken.
  Error ignored;
  stream_.socket().set_option(asio::socket_base::send_buffer_size(kMostUnsent), ignored);
  parser_.header_limit(kMostHeader);
  parser_.body_limit(kMostBody);
  host_.count_session(1);
}

PageSession::~PageSession() { host_.count_session(-1); }

void PageSession::start() {
  stream_.expires_after(kLongestRequest);
  http::async_read(stream_, buffer_, parser_,
                   [self = shared_from_this()](const Error& error, std::size_t) {
                     if (!error) return self->answer(self->parser_.get());
                     if (is_malformed(error)) {
                       self->respond(400, kText, "this is no request that is understood\n");
                     }
                   });
}

void PageSession::answer(const Request& request) {
  const Admission admission = host_.gate().admit(request);
  switch (admission.what) {
    case Admission::What::page:
      return respond(200, "text/html; charset=utf-8", host_.page());
    case Admission::What::events:
      return begin_stream();
    case Admission::What::command:
      return execute(admission.command);
    case Admission::What::refused:
      return respond(admission.status, kText, admission.text + "\n");
  }
}

void PageSession::execute(const std::string& command) {
  host_.ask(command, [self = shared_from_this()](const live::CommandAnswer& answer) {
    constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
    const nlohmann::ordered_json json = {{"done", answer.done}, {"text", answer.text}};
    self->respond(answer.done ? 200 : 409, "application/json", json.dump(-1, ' ', false, kReplace));
  });
}

void PageSession::respond(unsigned status, const char* type, std::string body) {
  response_ = head(status, type) + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" +
              std::move(body);
  stream_.expires_after(kLongestWrite);
  asio::async_write(stream_, asio::buffer(response_),
                    [self = shared_from_this()](const Error&, std::size_t) { self->close(); });
}

void PageSession::begin_stream() {
  watches_ = true;
  stream_.expires_never();
  wait_for_end();
  write(head(200, "text/event-stream") + "\r\n");
}

/// A viewer says nothing; that it has gone is heard here.
void PageSession::wait_for_end() {
  stream_.async_read_some(asio::buffer(ignored_),
                          [self = shared_from_this()](const Error& error, std::size_t) {
                            if (error) return self->close();
                            self->wait_for_end();
                          });
}

void PageSession::offer() {
  if (!watches_ || is_writing_) return;
  const std::string news = host_.news(told_, version_);
  if (!news.empty()) write("data: " + news + "\n\n");
}

void PageSession::write(std::string text) {
  response_ = std::move(text);
  is_writing_ = true;
  stream_.expires_after(kLongestWrite);  // of this; the reading goes on as long as it will
  asio::async_write(stream_, asio::buffer(response_),
                    [self = shared_from_this()](const Error& error, std::size_t) {
                      self->is_writing_ = false;
                      self->response_ = {};
                      if (error) self->close();
                    });
}

void PageSession::close() {
  watches_ = false;
  Error ignored;
  stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
  stream_.close();
}

}  // namespace surefoot::live_page
