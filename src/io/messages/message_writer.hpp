// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace surefoot::io {

/// Serialises the values of a message, one after the other: as CDR (XCDR1, little-endian), which is
/// ROS 2's, or packed, which is ROS 1's.
class MessageWriter {
 public:
  enum class Flavour { cdr, ros1 };
  explicit MessageWriter(Flavour flavour = Flavour::cdr) : cdr_(flavour == Flavour::cdr) {
    if (cdr_) bytes_.assign("\0\1\0\0", kEncapsulation);
  }

  template <typename T>
  MessageWriter& number(T value) {
    if (cdr_) {
      while ((bytes_.size() - kEncapsulation) % sizeof(T) != 0) bytes_ += '\0';
    }
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
    return *this;
  }
  /// The length of a sequence.
  MessageWriter& count(std::size_t size) { return number(static_cast<std::uint32_t>(size)); }
  MessageWriter& string(std::string_view text) {
    count(text.size() + (cdr_ ? 1 : 0));
    bytes_ += text;
    if (cdr_) bytes_ += '\0';
    return *this;
  }
  MessageWriter& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  /// Seconds and nanoseconds; seconds round down, also before 1970.
  MessageWriter& time(std::int64_t nanoseconds) {
    constexpr std::int64_t kSecond = 1'000'000'000;
    const std::int64_t rest = (nanoseconds % kSecond + kSecond) % kSecond;
    return number(static_cast<std::int32_t>((nanoseconds - rest) / kSecond))
        .number(static_cast<std::uint32_t>(rest));
  }
  /// std_msgs/Header.
  MessageWriter& header(std::int64_t stamp_ns, std::string_view frame) {
    if (!cdr_) number(std::uint32_t{0});  // its sequence number
    return time(stamp_ns).string(frame);
  }
  [[nodiscard]] bool is_cdr() const { return cdr_; }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  static constexpr std::size_t kEncapsulation = 4;
  std::string bytes_;
  bool cdr_;
};

}  // namespace surefoot::io
