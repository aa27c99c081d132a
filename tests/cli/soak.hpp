// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the long tests of `surefoot live` send and look at.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "datagram_sender.hpp"

namespace surefoot::test {

/// [kB] of a process's memory; 0: it is not there.
[[nodiscard]] std::size_t resident_kb(pid_t id);

/// Datagrams that are no sensor's: random bytes (a quarter as long as a packet), packets cut short,
/// empty ones.
[[nodiscard]] std::vector<std::string> malformed_datagrams(const std::vector<std::string>& packets,
                                                           std::mt19937& random);

/// Sends as fast as is received, so that the system has to drop nothing.
class PatientSender {
 public:
  void send(const std::string& bytes);
  void reconnect() { sender_.reconnect(); }
  [[nodiscard]] std::string port() const { return sender_.port(); }
  [[nodiscard]] bool wait_for_listener() const { return sender_.wait_for_listener(); }
  [[nodiscard]] std::size_t sent() const { return sent_; }

 private:
  DatagramSender sender_;
  std::size_t sent_ = 0;
};

}  // namespace surefoot::test
