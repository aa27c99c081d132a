// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a live run's packets come from: a socket, or a capture played at its own pace.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "io/packets/udp_datagram.hpp"

namespace surefoot::live {

struct Arrival {
  io::UdpDatagram datagram;     ///< valid until the next is asked for
  std::int64_t arrival_ns = 0;  ///< by the clock that stamps are made with, since 1970
  std::chrono::steady_clock::time_point received;  ///< for latencies
};

enum class Received {
  something,
  nothing,  ///< for now: ask again
  end       ///< nothing will come any more
};

class DatagramSource {
 public:
  virtual ~DatagramSource() = default;

  /// Waits a tenth of a second at most, or asks several times in that what ask() gave.
  [[nodiscard]] virtual Received receive(Arrival& arrival) = 0;
  /// Whom to ask whether it is worth waiting, before each receive().
  virtual void ask(const std::function<bool()>& /*go_on*/) {}
  /// Datagrams that came but were lost before they could be received.
  [[nodiscard]] virtual std::uint64_t overflowed() const { return 0; }
  /// Whether it waits for a slow receiver instead of losing anything.
  [[nodiscard]] virtual bool patient() const { return false; }
  /// "UDP port 2368".
  [[nodiscard]] virtual std::string name() const = 0;
  /// Why it ended before its time; empty: it did not.
  [[nodiscard]] virtual std::string ended_early() const { return {}; }
};

/// How long what the kernel stamped has waited in the socket, as the system's clock tells it, which
/// may have been set in between: a second at most, and never less than no time.
[[nodiscard]] std::chrono::nanoseconds waited(std::int64_t stamped_ns, std::int64_t now_ns);

/// @param address of the interface to listen on; "": all. Port 0: any that is free. Throws
/// std::runtime_error naming port and reason.
[[nodiscard]] std::unique_ptr<DatagramSource> listen_udp(const std::string& address,
                                                         std::uint16_t port);

/// @param speed times the capture's own; 0: as fast as it is taken. Throws io::ReadError.
[[nodiscard]] std::unique_ptr<DatagramSource> replay_capture(const std::filesystem::path& file,
                                                             double speed);

/// A capture that is still written to, or a pipe that one comes through: all that is there, as fast
/// as it is taken, then what comes. Throws io::ReadError.
[[nodiscard]] std::unique_ptr<DatagramSource> follow_capture(const std::filesystem::path& file);

}  // namespace surefoot::live
