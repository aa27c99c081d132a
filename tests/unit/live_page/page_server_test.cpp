// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The server from outside: plain sockets, good and bad.
#include "live_page/page_server.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace surefoot::live_page {
namespace {

/// A client of the loopback interface that waits ten seconds at most.
class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{10, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
    connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0;
  }
  ~Client() { ::close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void send(const std::string& bytes) const {
    (void)::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  void end() const { ::shutdown(socket_, SHUT_WR); }
  /// Until the text has come, or nothing more does.
  [[nodiscard]] std::string read_until(const std::string& text) const {
    std::string all;
    std::string part(65536, '\0');
    while (all.find(text) == std::string::npos) {
      const ssize_t size = ::recv(socket_, part.data(), part.size(), 0);
      if (size <= 0) break;
      all.append(part, 0, static_cast<std::size_t>(size));
    }
    return all;
  }
  [[nodiscard]] std::string read_all() const { return read_until("\x01 never"); }
  [[nodiscard]] bool connected() const { return connected_; }

 private:
  int socket_;
  bool connected_ = false;
};

TEST(PageToken, TokensDiffer) {
  const std::string token = make_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_NE(token, make_token());
}

/// Leaves the process, while it lives, no file to open but one.
class OneFileLeft {
 public:
  OneFileLeft() {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    rlimit few = before_;
    few.rlim_cur = 128;
    ::setrlimit(RLIMIT_NOFILE, &few);
    const auto open = [] { return ::open("/dev/null", O_RDONLY | O_CLOEXEC); };
    for (int file = open(); file >= 0; file = open()) taken_.push_back(file);
    ::close(taken_.back());
    taken_.pop_back();
  }
  ~OneFileLeft() {
    for (const int file : taken_) ::close(file);
    ::setrlimit(RLIMIT_NOFILE, &before_);
  }
  OneFileLeft(const OneFileLeft&) = delete;
  OneFileLeft& operator=(const OneFileLeft&) = delete;

 private:
  rlimit before_{};
  std::vector<int> taken_;
};

class PageServerTest : public testing::Test {
 protected:
  PageServerTest() {
    PageOptions options;
    options.token = "secret";
    options.title = "a walk";
    options.commands = {"reset", "pause"};
    options.ask = [this](const std::string& command) {
      ++asked_;
      return live::CommandAnswer{command == "reset", command + " was asked"};
    };
    options.figures = [] { return PageFigures{}; };
    server_.emplace(std::move(options));
  }

  [[nodiscard]] std::string host() const {
    return "Host: 127.0.0.1:" + std::to_string(server_->port()) + "\r\n";
  }
  [[nodiscard]] std::string get(const std::string& target) const {
    const Client client(server_->port());
    client.send("GET " + target + " HTTP/1.1\r\n" + host() + "\r\n");
    return client.read_all();
  }
  [[nodiscard]] std::string post(const std::string& target, const std::string& fields) const {
    const Client client(server_->port());
    client.send("POST " + target + " HTTP/1.1\r\n" + host() + fields + "Content-Length: 0\r\n\r\n");
    return client.read_all();
  }
  void expect_alive() const {
    const std::string page = get("/");
    EXPECT_TRUE(page.starts_with("HTTP/1.1 200 OK\r\n")) << page.substr(0, 200);
    EXPECT_NE(page.find("<main id=\"live\">"), std::string::npos);
  }
  void tell(int i, std::size_t points) {
    PageScan scan;
    scan.name = "scan" + std::to_string(i) + "end";
    scan.stamp_ns = 100'000'000LL * i;
    scan.status = "ok";
    PageCloud cloud;
    for (std::size_t k = 0; k < points; ++k) {
      cloud.points.push_back(
          Eigen::Vector3f(static_cast<float>(i), 0.2F * static_cast<float>(k), 0));
    }
    server_->tell(std::move(scan), std::move(cloud));
  }

  std::optional<PageServer> server_;
  std::atomic<int> asked_{0};
};

TEST_F(PageServerTest, ServesThePage) {
  expect_alive();
  EXPECT_TRUE(get("/nothing").starts_with("HTTP/1.1 404"));
  EXPECT_EQ(server_->address(),
            "http://127.0.0.1:" + std::to_string(server_->port()) + "/#token=secret");
}

TEST_F(PageServerTest, WhoComesWhileNoFileCanBeOpenedIsServedLater) {
  std::optional<OneFileLeft> one_left(std::in_place);
  const Client client(server_->port());  // takes it; the server has none
  ASSERT_TRUE(client.connected());
  client.send("GET / HTTP/1.1\r\n" + host() + "\r\n");
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // it tries at once, in vain
  one_left.reset();
  EXPECT_TRUE(client.read_all().starts_with("HTTP/1.1 200 OK\r\n"));
  expect_alive();
}

TEST_F(PageServerTest, APortThatIsTakenIsSaid) {
  PageOptions options;
  options.port = server_->port();
  try {
    const PageServer other(options);
    FAIL() << "expected an error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(std::to_string(options.port)), std::string::npos);
  }
}

TEST_F(PageServerTest, CommandsAreDoneForWhoHasTheToken) {
  EXPECT_TRUE(post("/commands/reset", "").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(post("/commands/reset", "X-Surefoot-Token: guess\r\n").starts_with("HTTP/1.1 403"));
  EXPECT_EQ(asked_, 0);
  const std::string done = post("/commands/reset", "X-Surefoot-Token: secret\r\n");
  EXPECT_TRUE(done.starts_with("HTTP/1.1 200")) << done;
  EXPECT_NE(done.find(R"({"done":true,"text":"reset was asked"})"), std::string::npos) << done;
  EXPECT_TRUE(post("/commands/pause", "X-Surefoot-Token: secret\r\n").starts_with("HTTP/1.1 409"));
  EXPECT_EQ(asked_, 2);
}

TEST_F(PageServerTest, TellsWhatIsNew) {
  const Client client(server_->port());
  client.send("GET /events HTTP/1.1\r\n" + host() + "\r\n");
  EXPECT_NE(client.read_until("\"scan\":null").find("text/event-stream"), std::string::npos);
  tell(1, 10);
  EXPECT_NE(client.read_until("scan1end").find("data: {"), std::string::npos);
  tell(2, 10);
  EXPECT_NE(client.read_until("scan2end").find("scan2end"), std::string::npos);
}

TEST_F(PageServerTest, MalformedRequestsByTheDozenHaveNoEffect) {
  const std::string token = "X-Surefoot-Token: secret\r\n";
  std::vector<std::string> bad = {
      "",
      "\r\n\r\n",
      "GET\r\n\r\n",
      "GET / HTTP/9.9\r\n\r\n",
      "GET / HTTP/1.1\r\n\r\n",
      "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n",
      "GET / HTTP/1.1\r\n" + host() + host() + "\r\n",
      "GET / HTTP/1.1\r\n" + host() + "Broken\r\n\r\n",
      "GET / HTTP/1.1\nHost 127.0.0.1\n\n",
      "GET /" + std::string(20'000, 'a') + " HTTP/1.1\r\n" + host() + "\r\n",
      "GET / HTTP/1.1\r\n" + host() + "X: " + std::string(100'000, 'a') + "\r\n\r\n",
      "POST /commands/reset HTTP/1.1\r\n" + host() + token + "Content-Length: 99999999999\r\n\r\n",
      "POST /commands/reset HTTP/1.1\r\n" + host() + token + "Content-Length: -1\r\n\r\n",
      "POST /commands/reset HTTP/1.1\r\n" + host() + token + "Content-Length: 5000\r\n\r\n" +
          std::string(5000, 'x'),
      "POST /commands/reset HTTP/1.1\r\n" + host() + token +
          "Transfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\n",
      "POST /commands/reset HTTP/1.1\r\n" + host() + token + "Content-Length: 10\r\n\r\nhalf",
      "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03",
      std::string("GET /\0 HTTP/1.1\r\n\r\n", 19),
      "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
  };
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    std::string bytes(1 + random() % 3000, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    bad.push_back(bytes);
    std::string request = "POST /commands/reset HTTP/1.1\r\n" + host() + "\r\n";
    for (int k = 0; k < 3; ++k) request[random() % request.size()] = static_cast<char>(random());
    bad.push_back(request);
  }
  for (const std::string& bytes : bad) {
    const Client client(server_->port());
    ASSERT_TRUE(client.connected());
    client.send(bytes);
    client.end();
    const std::string answer = client.read_all();
    EXPECT_FALSE(answer.starts_with("HTTP/1.1 200")) << bytes.substr(0, 100);
  }
  EXPECT_EQ(asked_, 0);
  expect_alive();
}

/// It asks for the news and takes none. What is told to it is not kept, and others see what is new.
TEST_F(PageServerTest, AViewerThatNeverReadsHoldsUpNobody) {
  std::vector<std::unique_ptr<Client>> sleepers;
  for (int i = 0; i < 4; ++i) {
    sleepers.push_back(std::make_unique<Client>(server_->port()));
    sleepers.back()->send("GET /events HTTP/1.1\r\n" + host() + "\r\n");
  }
  const Client viewer(server_->port());
  viewer.send("GET /events HTTP/1.1\r\n" + host() + "\r\n");
  for (int i = 0; i < 60; ++i) {
    tell(i, 20'000);
    const std::string name = "scan" + std::to_string(i) + "end";
    ASSERT_NE(viewer.read_until(name).find(name), std::string::npos);
  }
  expect_alive();
}

TEST_F(PageServerTest, ManyThatSayNothingAreNotServedWithoutEnd) {
  std::vector<std::unique_ptr<Client>> many;
  for (int i = 0; i < 200; ++i) many.push_back(std::make_unique<Client>(server_->port()));
  many.clear();
  for (int i = 0; i < 50 && !get("/").starts_with("HTTP/1.1 200"); ++i) usleep(20'000);
  expect_alive();
}

}  // namespace
}  // namespace surefoot::live_page
