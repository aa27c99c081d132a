// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <string>

namespace surefoot::test {

/// That port of this machine.
[[nodiscard]] sockaddr_in loopback(std::uint16_t port);

/// Sends datagrams to a port of this machine that nobody else had a moment ago.
class DatagramSender {
 public:
  DatagramSender();
  ~DatagramSender();
  DatagramSender(const DatagramSender&) = delete;
  DatagramSender& operator=(const DatagramSender&) = delete;

  [[nodiscard]] std::string port() const { return std::to_string(port_); }
  void send(const std::string& payload) const;
  /// From another port from now on: the sensor, or what it hangs on, was switched off and on.
  void reconnect();
  /// Until somebody listens there.
  [[nodiscard]] bool wait_for_listener() const;
  /// Bytes that lie there and were not received yet, with the system's own.
  [[nodiscard]] std::size_t waiting() const;

 private:
  int socket_;
  std::uint16_t port_ = 0;
};

}  // namespace surefoot::test
