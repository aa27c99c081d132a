// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_page/page_gate.hpp"

#include <gtest/gtest.h>

namespace surefoot::live_page {
namespace {

namespace http = boost::beast::http;

const PageGate kGate(8017, "secret", {"reset", "pause"});

Request request(http::verb method, const char* target, const char* host = "127.0.0.1:8017") {
  Request made(method, target, 11);
  made.set(http::field::host, host);
  return made;
}

TEST(PageGate, ServesThePageAndItsEvents) {
  EXPECT_EQ(kGate.admit(request(http::verb::get, "/")).what, Admission::What::page);
  EXPECT_EQ(kGate.admit(request(http::verb::get, "/events")).what, Admission::What::events);
  EXPECT_EQ(kGate.admit(request(http::verb::get, "/", "localhost:8017")).what,
            Admission::What::page);
  EXPECT_EQ(kGate.admit(request(http::verb::get, "/..")).status, 404U);
  EXPECT_EQ(kGate.admit(request(http::verb::get, "/events?all")).status, 404U);
  EXPECT_EQ(kGate.admit(request(http::verb::put, "/")).status, 405U);
  EXPECT_EQ(kGate.admit(request(http::verb::get, "/commands/reset")).status, 405U);
}

TEST(PageGate, ANameThatWasMadePointHereIsRefused) {
  for (const char* host : {"evil.example:8017", "127.0.0.1", "127.0.0.1:80", "localhost.evil:8017",
                           "127.0.0.1:8017.evil", "", "192.168.0.1:8017"}) {
    EXPECT_EQ(kGate.admit(request(http::verb::get, "/events", host)).status, 403U) << host;
  }
  Request none(http::verb::get, "/", 11);
  EXPECT_EQ(kGate.admit(none).status, 403U);
  Request two = request(http::verb::get, "/");
  two.insert(http::field::host, "127.0.0.1:8017");
  EXPECT_EQ(kGate.admit(two).status, 403U);
}

TEST(PageGate, AForeignPageIsRefused) {
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:8017", "",
                             "http://127.0.0.1:8018", "127.0.0.1:8017"}) {
    Request asked = request(http::verb::post, "/commands/reset");
    asked.set(kTokenField, "secret");
    asked.insert(http::field::origin, origin);
    EXPECT_EQ(kGate.admit(asked).status, 403U) << origin;
  }
  Request own = request(http::verb::post, "/commands/reset");
  own.set(kTokenField, "secret");
  own.set(http::field::origin, "http://localhost:8017");
  EXPECT_EQ(kGate.admit(own).what, Admission::What::command);
}

TEST(PageGate, ACommandNeedsTheToken) {
  Request asked = request(http::verb::post, "/commands/reset");
  EXPECT_EQ(kGate.admit(asked).status, 403U);
  for (const char* token : {"", "secre", "Secret", "secrets", "terces"}) {
    asked.set(kTokenField, token);
    EXPECT_EQ(kGate.admit(asked).status, 403U) << token;
  }
  asked.set(kTokenField, "secret");
  EXPECT_EQ(kGate.admit(asked).command, "reset");
  asked.target("/commands/shutdown");
  EXPECT_EQ(kGate.admit(asked).status, 404U);
}

}  // namespace
}  // namespace surefoot::live_page
