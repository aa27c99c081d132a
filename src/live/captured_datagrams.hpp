// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The datagrams in a capture, put together where they were sent in fragments.
#pragma once

#include <optional>

#include "io/packets/capture_file.hpp"
#include "live/datagram_source.hpp"

namespace surefoot::live {

class CapturedDatagrams {
 public:
  explicit CapturedDatagrams(io::CaptureFile file) : file_(std::move(file)) {}

  /// With no time of receipt. Nothing at the capture's end.
  [[nodiscard]] std::optional<Arrival> next() {
    while (const std::optional<io::CapturedFrame> frame = file_.next()) {
      io::IpFragment fragment;
      io::UdpDatagram datagram = io::find_udp(file_.link(), frame->bytes, &fragment);
      if (datagram.content == io::FrameContent::fragment) datagram = fragments_.add(fragment);
      if (datagram.content != io::FrameContent::udp) continue;
      return Arrival{datagram, frame->stamp_ns, {}};
    }
    return std::nullopt;
  }
  /// Why it ends before its time; empty: it does not.
  [[nodiscard]] const std::string& cut_short() const { return file_.cut_short(); }

 private:
  io::CaptureFile file_;
  io::FragmentBuffer fragments_;
};

}  // namespace surefoot::live
