// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_page/page_server.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <chrono>
#include <deque>
#include <mutex>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>

#include "live_page/page_content.hpp"
#include "live_page/page_gate.hpp"
#include "live_page/page_history.hpp"
#include "live_page/page_session.hpp"

namespace surefoot::live_page {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Error = boost::system::error_code;

constexpr std::chrono::milliseconds kPeriod(200);
constexpr int kPeriodsOfFigures = 5;
constexpr std::size_t kMostScansWaiting = 1000;
constexpr int kMostSessions = 32;
constexpr int kMostCommandsWaiting = 8;

nlohmann::ordered_json figures_json(const PageFigures& figures) {
  return {{"used", figures.used},
          {"dropped", figures.dropped},
          {"left_out", figures.left_out},
          {"received", figures.received},
          {"lost", figures.lost},
          {"latency_ms",
           {{"p50", figures.latency_p50_ms},
            {"p99", figures.latency_p99_ms},
            {"max", figures.latency_max_ms}}}};
}

}  // namespace

class PageServer::Impl final : public SessionHost {
 public:
  explicit Impl(PageOptions options);
  ~Impl() override;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] const PageOptions& options() const { return options_; }
  void tell(PageScan scan, std::optional<PageCloud> cloud);
  [[nodiscard]] bool wants_cloud() const;

  const PageGate& gate() const override { return *gate_; }
  const std::string& page() const override { return page_; }
  std::string news(Told& told, std::uint64_t& version) const override;
  void ask(const std::string& command,
           std::function<void(const live::CommandAnswer&)> answer) override;
  void count_session(int more) override { sessions_ += more; }

 private:
  void listen();
  void accept();
  void take(tcp::socket socket);
  void wait();
  void look();
  void take_inbox();
  void run();

  const PageOptions options_;
  const std::string page_;
  int sessions_ = 0;  // outlives what io_ still holds of them
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
  asio::steady_timer timer_{io_};
  std::uint16_t port_ = 0;
  std::optional<PageGate> gate_;
  std::vector<std::weak_ptr<PageSession>> all_;
  int commands_waiting_ = 0;
  PageHistory history_;
  PageFigures figures_;
  std::uint64_t version_ = 1;  ///< of what there is to tell
  int periods_ = 0;
  bool accept_again_ = false;

  mutable std::mutex mutex_;  ///< of what follows
  std::deque<PageScan> scans_;
  std::optional<PageCloud> cloud_;

  asio::thread_pool commands_{1};
  std::thread thread_;
};

PageServer::Impl::Impl(PageOptions options) : options_(std::move(options)), page_(page_content()) {
  listen();
  gate_.emplace(port_, options_.token, options_.commands);
  accept();
  wait();
  thread_ = std::thread([this] { run(); });
}

PageServer::Impl::~Impl() {
  commands_.join();  // what they answer is told no more
  io_.stop();
  thread_.join();
}

void PageServer::Impl::listen() {
  try {
    const tcp::endpoint loopback(asio::ip::address_v4::loopback(), options_.port);
    acceptor_.open(loopback.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(loopback);
    acceptor_.listen();
    port_ = acceptor_.local_endpoint().port();
  } catch (const boost::system::system_error& error) {
    throw std::runtime_error("live: page: port " + std::to_string(options_.port) +
                             " of 127.0.0.1: " + error.code().message());
  }
}

void PageServer::Impl::run() {
  while (!io_.stopped()) {
    try {
      io_.run();
    } catch (const std::exception&) {  // of one connection; the others go on
    }
  }
}

void PageServer::Impl::accept() {
  acceptor_.async_accept([this](const Error& error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    // Where there are no more files to open, the next one fails at once, too: by the timer, then.
    accept_again_ = static_cast<bool>(error);
    if (error) return;
    accept();
    take(std::move(socket));
  });
}

void PageServer::Impl::take(tcp::socket socket) {
  if (sessions_ >= kMostSessions) return;
  const auto session = std::make_shared<PageSession>(std::move(socket), *this);
  all_.push_back(session);
  session->start();
}

void PageServer::Impl::wait() {
  timer_.expires_after(kPeriod);
  timer_.async_wait([this](const Error& error) {
    if (error) return;
    wait();  // first: what is thrown below ends no period
    if (std::exchange(accept_again_, false)) accept();
    look();
  });
}

void PageServer::Impl::look() {
  take_inbox();
  if (periods_++ % kPeriodsOfFigures == 0) {
    figures_ = options_.figures();
    ++version_;
  }
  std::erase_if(all_, [](const auto& session) { return session.expired(); });
  for (const std::weak_ptr<PageSession>& one : all_) {
    if (const std::shared_ptr<PageSession> session = one.lock()) session->offer();
  }
}

void PageServer::Impl::take_inbox() {
  std::deque<PageScan> scans;
  std::optional<PageCloud> cloud;
  {
    const std::lock_guard lock(mutex_);
    scans.swap(scans_);
    cloud.swap(cloud_);
  }
  if (scans.empty()) return;
  for (PageScan& scan : scans) history_.add(std::move(scan));
  if (cloud) history_.add(*cloud);
  ++version_;
}

void PageServer::Impl::tell(PageScan scan, std::optional<PageCloud> cloud) {
  const std::lock_guard lock(mutex_);
  if (scans_.size() >= kMostScansWaiting) scans_.pop_front();
  scans_.push_back(std::move(scan));
  if (cloud) cloud_ = std::move(cloud);
}

bool PageServer::Impl::wants_cloud() const {
  const std::lock_guard lock(mutex_);
  return !cloud_;
}

std::string PageServer::Impl::news(Told& told, std::uint64_t& version) const {
  if (version == version_ && history_.all_told(told)) return {};
  version = version_;
  nlohmann::ordered_json json = history_.news(told);
  json["title"] = options_.title;
  json["version"] = options_.version;
  json["commands"] = options_.commands;
  json["paused"] = figures_.paused;
  json["figures"] = figures_json(figures_);
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// On a thread of its own: the run takes its time, and others want to see it meanwhile.
void PageServer::Impl::ask(const std::string& command,
                           std::function<void(const live::CommandAnswer&)> answer) {
  if (commands_waiting_ >= kMostCommandsWaiting) return answer({false, "too many commands wait"});
  ++commands_waiting_;
  asio::post(commands_, [this, command, answer = std::move(answer)]() mutable {
    asio::post(io_, [this, answer = std::move(answer), said = options_.ask(command)] {
      --commands_waiting_;
      answer(said);
    });
  });
}

std::string make_token() {
  constexpr const char* kDigits = "0123456789abcdef";
  constexpr int kBits = 128;
  std::random_device random;
  std::string token;
  for (int bits = 0; bits < kBits; bits += 32) {
    for (unsigned word = random(), i = 0; i < 8; ++i, word >>= 4) token += kDigits[word & 15];
  }
  return token;
}

PageServer::PageServer(PageOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
PageServer::~PageServer() = default;

std::uint16_t PageServer::port() const { return impl_->port(); }

std::string PageServer::address() const {
  return "http://127.0.0.1:" + std::to_string(port()) + "/#token=" + impl_->options().token;
}

void PageServer::tell(PageScan scan, std::optional<PageCloud> cloud) {
  impl_->tell(std::move(scan), std::move(cloud));
}

bool PageServer::wants_cloud() const { return impl_->wants_cloud(); }

}  // namespace surefoot::live_page
