// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <span>
#include <stdexcept>
#include <system_error>

#include "live/datagram_source.hpp"

namespace surefoot::live {
namespace {

constexpr int kWaitMs = 100;
/// Half a second of the fastest sensors; the kernel gives less where net.core.rmem_max says so.
constexpr int kBufferBytes = 16 << 20;

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

class Socket {
 public:
  Socket() : id_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~Socket() {
    if (id_ >= 0) ::close(id_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  [[nodiscard]] int id() const { return id_; }
  [[nodiscard]] bool set(int option, int value) const {
    return ::setsockopt(id_, SOL_SOCKET, option, &value, sizeof(value)) == 0;
  }

 private:
  int id_;
};

class UdpSource final : public DatagramSource {
 public:
  UdpSource(const std::string& address, std::uint16_t port) {
    const auto fail = [&](int error) {
      throw std::runtime_error("UDP port " + std::to_string(port) +
                               (address.empty() ? "" : " of " + address) + ": " +
                               std::generic_category().message(error));
    };
    if (socket_.id() < 0) fail(errno);
    sockaddr_in local{};
    local.sin_family = AF_INET;
    local.sin_port = htons(port);
    local.sin_addr.s_addr = htonl(INADDR_ANY);
    if (!address.empty() && ::inet_pton(AF_INET, address.c_str(), &local.sin_addr) != 1) {
      throw std::runtime_error("'" + address +
                               "' is no address of an interface; expected such as "
                               "192.168.1.100");
    }
    // Larger than rmem_max is the privilege of root; whoever is not gets what there is.
    if (!socket_.set(SO_RCVBUFFORCE, kBufferBytes)) (void)socket_.set(SO_RCVBUF, kBufferBytes);
    if (!socket_.set(SO_TIMESTAMPNS, 1) || !socket_.set(SO_RXQ_OVFL, 1)) fail(errno);
    if (::bind(socket_.id(), reinterpret_cast<sockaddr*>(&local), sizeof(local)) != 0) fail(errno);
    socklen_t size = sizeof(local);
    if (::getsockname(socket_.id(), reinterpret_cast<sockaddr*>(&local), &size) != 0) fail(errno);
    port_ = ntohs(local.sin_port);
  }

  Received receive(Arrival& arrival) override {
    pollfd waiting{socket_.id(), POLLIN, 0};
    if (::poll(&waiting, 1, kWaitMs) <= 0) return Received::nothing;
    sockaddr_in sender{};
    iovec buffer{bytes_.data(), bytes_.size()};
    alignas(cmsghdr) std::array<char, 256> control;
    msghdr message{};
    message.msg_name = &sender;
    message.msg_namelen = sizeof(sender);
    message.msg_iov = &buffer;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t size = ::recvmsg(socket_.id(), &message, MSG_DONTWAIT);
    if (size < 0) return Received::nothing;  // a refusal that came back, or a bad checksum
    stamp(message, arrival);
    arrival.datagram = {io::FrameContent::udp, ntohl(sender.sin_addr.s_addr), port_,
                        std::span(bytes_).first(static_cast<std::size_t>(size))};
    return Received::something;
  }

  std::uint64_t overflowed() const override { return overflowed_; }
  std::string name() const override { return "UDP port " + std::to_string(port_); }

 private:
  /// When the kernel received it: it may have waited in the socket since.
  void stamp(msghdr& message, Arrival& arrival) {
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    arrival.arrival_ns = nanoseconds(now);
    arrival.received = std::chrono::steady_clock::now();
    for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr;
         part = CMSG_NXTHDR(&message, part)) {
      if (part->cmsg_level != SOL_SOCKET) continue;
      if (part->cmsg_type == SCM_TIMESTAMPNS) {
        timespec kernel{};
        std::memcpy(&kernel, CMSG_DATA(part), sizeof(kernel));
        arrival.received -= waited(nanoseconds(kernel), nanoseconds(now));
        arrival.arrival_ns = nanoseconds(kernel);
      } else if (part->cmsg_type == SO_RXQ_OVFL) {
        std::uint32_t count = 0;
        std::memcpy(&count, CMSG_DATA(part), sizeof(count));
        overflowed_ += count - last_count_;  // of 32 bits, which may begin anew
        last_count_ = count;
      }
    }
  }

  Socket socket_;
  std::uint16_t port_ = 0;
  std::array<std::byte, 65'536> bytes_;
  std::uint32_t last_count_ = 0;
  std::uint64_t overflowed_ = 0;
};

}  // namespace

std::chrono::nanoseconds waited(std::int64_t stamped_ns, std::int64_t now_ns) {
  constexpr std::chrono::nanoseconds kNone(0), kMost(std::chrono::seconds(1));
  return std::clamp(std::chrono::nanoseconds(now_ns - stamped_ns), kNone, kMost);
}

std::unique_ptr<DatagramSource> listen_udp(const std::string& address, std::uint16_t port) {
  return std::make_unique<UdpSource>(address, port);
}

}  // namespace surefoot::live
