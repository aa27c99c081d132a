// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Bits one after the other: what pieces of way keep takes few of them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace surefoot::mapping {

/// Bits, the lowest first.
class BitWriter {
 public:
  void put(std::uint32_t value, int bits) {
    held_ |= static_cast<std::uint64_t>(value) << count_;
    count_ += bits;
    for (; count_ >= 8; count_ -= 8, held_ >>= 8) bytes_.push_back(static_cast<char>(held_ & 0xFF));
  }
  /// Elias' gamma code: small numbers take few bits.
  void put_gamma(std::uint32_t value) {
    const int digits = static_cast<int>(std::bit_width(value + 1));
    put(0, digits - 1);
    put(1, 1);
    put((value + 1) & ((1U << (digits - 1)) - 1U), digits - 1);
  }
  std::string take() {
    if (count_ > 0) bytes_.push_back(static_cast<char>(held_ & 0xFF));
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::uint64_t held_ = 0;
  int count_ = 0;
};

class BitReader {
 public:
  explicit BitReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t get(int bits) {
    while (count_ < bits) {
      if (at_ == bytes_.size()) throw std::invalid_argument("points that are cut short");
      held_ |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_++])) << count_;
      count_ += 8;
    }
    const auto value = static_cast<std::uint32_t>(held_ & ((1ULL << bits) - 1ULL));
    held_ >>= bits;
    count_ -= bits;
    return value;
  }
  std::uint32_t get_gamma() {
    constexpr int kMostDigits = 28;
    int digits = 0;
    while (get(1) == 0) {
      if (++digits > kMostDigits) throw std::invalid_argument("a cube that is too far away");
    }
    return ((1U << digits) | (digits > 0 ? get(digits) : 0U)) - 1U;
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::uint64_t held_ = 0;
  int count_ = 0;
};

}  // namespace surefoot::mapping
