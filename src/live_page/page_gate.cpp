// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_page/page_gate.hpp"

#include <algorithm>
#include <utility>

namespace surefoot::live_page {
namespace {

namespace http = boost::beast::http;

constexpr std::string_view kCommands = "/commands/";

Admission refused(unsigned status, std::string text) {
  return {Admission::What::refused, {}, status, std::move(text)};
}

/// In a time that does not tell how much of it is right.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0;
}

std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }

}  // namespace

PageGate::PageGate(std::uint16_t port, std::string token, std::vector<std::string> commands)
    : port_(std::to_string(port)), token_(std::move(token)), commands_(std::move(commands)) {}

bool PageGate::is_ours(std::string_view host) const {
  return host == "127.0.0.1:" + port_ || host == "localhost:" + port_;
}

Admission PageGate::admit(const Request& request) const {
  if (request.count(http::field::host) != 1 || !is_ours(view(request[http::field::host]))) {
    return refused(403, "Host is not this machine's name for itself");
  }
  if (request.count(http::field::origin) > 0) {
    std::string_view origin = view(request[http::field::origin]);
    constexpr std::string_view kScheme = "http://";
    const bool has_scheme = origin.starts_with(kScheme);
    if (has_scheme) origin.remove_prefix(kScheme.size());
    if (request.count(http::field::origin) > 1 || !has_scheme || !is_ours(origin)) {
      return refused(403, "Origin is another page");
    }
  }
  const std::string_view target = view(request.target());
  const bool gets = request.method() == http::verb::get;
  if (target == "/" || target == "/events") {
    if (!gets) return refused(405, "only GET is understood here");
    return {target == "/" ? Admission::What::page : Admission::What::events, {}, 200, {}};
  }
  if (!target.starts_with(kCommands)) return refused(404, "there is / and /events");
  if (request.method() != http::verb::post) return refused(405, "only POST is understood here");
  return admit_command(request, target.substr(kCommands.size()));
}

Admission PageGate::admit_command(const Request& request, std::string_view name) const {
  if (request.count(kTokenField) != 1 || !same(view(request[kTokenField]), token_)) {
    return refused(403, "the token is missing or wrong: it stands in the address that was printed");
  }
  if (std::find(commands_.begin(), commands_.end(), name) == commands_.end()) {
    return refused(404, "there is no such command");
  }
  return {Admission::What::command, std::string(name), 200, {}};
}

}  // namespace surefoot::live_page
