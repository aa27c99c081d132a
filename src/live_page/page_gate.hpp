// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which requests to a live run's page are answered.
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::live_page {

using Request = boost::beast::http::request<boost::beast::http::string_body>;

inline constexpr const char* kTokenField = "X-Surefoot-Token";

/// What to do with a request.
struct Admission {
  enum class What { page, events, command, refused };
  What what = What::refused;
  std::string command;  ///< its name
  unsigned status = 200;
  std::string text;  ///< why it is refused
};

/// The page is this machine's: a name that a foreign server has made point here (DNS rebinding)
/// stands in `Host`, a foreign page in `Origin`, and both are refused. What changes the run's state
/// is done for who knows the token.
class PageGate {
 public:
  PageGate(std::uint16_t port, std::string token, std::vector<std::string> commands);

  [[nodiscard]] Admission admit(const Request& request) const;

 private:
  [[nodiscard]] bool is_ours(std::string_view host) const;
  [[nodiscard]] Admission admit_command(const Request& request, std::string_view name) const;

  std::string port_;
  std::string token_;
  std::vector<std::string> commands_;
};

}  // namespace surefoot::live_page
