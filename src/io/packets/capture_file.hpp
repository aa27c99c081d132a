// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "io/bags/byte_stream.hpp"
#include "io/packets/udp_datagram.hpp"

namespace surefoot::io {

struct CapturedFrame {
  std::int64_t stamp_ns = 0;         ///< the capturing machine's clock
  std::uint32_t length = 0;          ///< on the wire, of which the capture may have less [bytes]
  std::span<const std::byte> bytes;  ///< valid until the next frame is read
};

/// A packet capture (pcap or pcapng), also compressed, read from front to back through libpcap.
class CaptureFile {
 public:
  /// Throws ReadError where it is no capture, or of a link layer that is not known.
  explicit CaptureFile(const std::filesystem::path& file);
  /// Takes the open file over, for captures in memory. Throws as above.
  explicit CaptureFile(std::FILE* file);
  /// Of bytes that come as they come: no more of them are asked for than the next frame needs.
  explicit CaptureFile(std::unique_ptr<ByteStream> bytes);

  /// The next frame, or nothing at the end or where the file is cut short: see cut_short().
  [[nodiscard]] std::optional<CapturedFrame> next();
  [[nodiscard]] LinkLayer link() const { return link_; }
  /// libpcap's own of it, a pcap_t, for who writes another capture like it.
  [[nodiscard]] void* handle() const { return handle_.get(); }
  /// What libpcap said where the capture ends before its time; empty: it does not.
  [[nodiscard]] const std::string& cut_short() const { return cut_short_; }
  /// Share of the file that was read, 0..1.
  [[nodiscard]] double progress() const;

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  struct Unpacked;
  struct Forget {
    void operator()(Unpacked* unpacked) const;
  };
  void open(std::FILE* file);
  void fail();

  std::unique_ptr<Unpacked, Forget> unpacked_;  ///< what libpcap reads from; null: the file itself
  std::unique_ptr<void, Close> handle_;         ///< a pcap_t, which nobody outside has to know
  LinkLayer link_ = LinkLayer::ethernet;
  std::string cut_short_;
  double size_ = 0.0;
};

}  // namespace surefoot::io
