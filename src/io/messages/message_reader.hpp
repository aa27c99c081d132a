// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "io/bags/message_source.hpp"
#include "sensors/bytes.hpp"

namespace surefoot::io {

/// The values of a serialised message, one after the other.
///
/// ROS 1: packed, little-endian. CDR (OMG DDS-XTypes 1.3, 7.4): four bytes say byte order and
/// version, and every number is aligned, counted from after them: in XCDR1 to its size, in XCDR2 to
/// 4 at most. XCDR2 also has the size of a sequence of structures before it, and where it is
/// "delimited" that of every structure. Whatever follows the last value is ignored: writers pad.
class MessageReader {
 public:
  /// Throws ReadError where the encoding is not known.
  MessageReader(MessageEncoding encoding, std::span<const std::byte> bytes);
  /// Packed little-endian values: a ROS 1 message, a record of MCAP.
  [[nodiscard]] static MessageReader packed(std::span<const std::byte> bytes) {
    return {MessageEncoding::ros1, bytes};
  }

  /// Every reading function throws ReadError naming `what` where the message ends before.
  template <typename T>
  [[nodiscard]] T number(const char* what) {
    align(sizeof(T));
    return load<T>(take(sizeof(T), what).data(), swapped_);
  }
  /// Without the NUL that CDR puts at the end.
  [[nodiscard]] std::string_view string(const char* what);
  /// The length of a sequence. Throws also where fewer than `least` bytes are there for each.
  [[nodiscard]] std::uint32_t count(const char* what, std::size_t least);
  /// The length of a sequence of structures.
  [[nodiscard]] std::uint32_t structures(const char* what, std::size_t least);
  [[nodiscard]] std::span<const std::byte> take(std::uint64_t size, const char* what);
  /// ROS's time: seconds and nanoseconds [ns].
  [[nodiscard]] std::int64_t time(const char* what);

  void begin_structure();
  [[nodiscard]] std::span<const std::byte> rest() const { return bytes_.subspan(at_); }
  [[nodiscard]] bool is_cdr() const { return most_aligned_ > 1; }
  [[nodiscard]] bool is_swapped() const { return swapped_; }
  [[nodiscard]] bool is_delimited() const { return delimited_; }

 private:
  void align(std::size_t size);

  std::span<const std::byte> bytes_;  ///< after the encapsulation
  std::size_t at_ = 0;
  std::size_t most_aligned_ = 1;
  bool swapped_ = false;
  bool version2_ = false;
  bool delimited_ = false;
};

/// std_msgs/Header.
struct MessageHeader {
  std::int64_t stamp_ns = 0;
  std::string_view frame;
};
[[nodiscard]] MessageHeader read_header(MessageReader& reader);

}  // namespace surefoot::io
