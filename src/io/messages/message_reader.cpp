// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/message_reader.hpp"

#include <algorithm>
#include <string>

#include "io/recording.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kEncapsulation = 4;

// DDS-XTypes 1.3, table 60; the lowest bit says little-endian.
enum Representation : unsigned { kCdr = 0x0, kCdr2 = 0x6, kDelimitedCdr2 = 0x8 };

}  // namespace

MessageReader::MessageReader(MessageEncoding encoding, std::span<const std::byte> bytes)
    : bytes_(bytes) {
  if (encoding == MessageEncoding::ros1) return;
  if (encoding != MessageEncoding::cdr) {
    throw ReadError("the message's encoding is neither cdr nor ros1");
  }
  if (bytes.size() < kEncapsulation) {
    throw ReadError("a message of " + std::to_string(bytes.size()) +
                    " bytes; CDR begins with 4 that say its byte order");
  }
  const unsigned kind =
      std::to_integer<unsigned>(bytes[0]) << 8 | std::to_integer<unsigned>(bytes[1]);
  const unsigned representation = kind & ~1U;
  if (representation != kCdr && representation != kCdr2 && representation != kDelimitedCdr2) {
    throw ReadError("the message's CDR representation is " + std::to_string(kind) +
                    "; expected plain CDR (0, 1), CDR 2 (6, 7) or delimited CDR 2 (8, 9)");
  }
  swapped_ = (kind & 1U) == 0;
  version2_ = representation != kCdr;
  delimited_ = representation == kDelimitedCdr2;
  most_aligned_ = version2_ ? 4 : 8;
  bytes_ = bytes.subspan(kEncapsulation);
}

void MessageReader::align(std::size_t size) {
  const std::size_t unit = std::min(size, most_aligned_);
  at_ = std::min((at_ + unit - 1) / unit * unit, bytes_.size());
}

std::span<const std::byte> MessageReader::take(std::uint64_t size, const char* what) {
  const std::size_t left = bytes_.size() - at_;
  if (size > left) {
    throw ReadError(std::string("the message ends within its ") + what + ": " +
                    std::to_string(size) + " bytes expected, " + std::to_string(left) + " left");
  }
  at_ += static_cast<std::size_t>(size);
  return bytes_.subspan(at_ - static_cast<std::size_t>(size), static_cast<std::size_t>(size));
}

std::string_view MessageReader::string(const char* what) {
  const auto size = number<std::uint32_t>(what);
  const std::span<const std::byte> bytes = take(size, what);
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (is_cdr() && text.ends_with('\0')) text.remove_suffix(1);
  return text;
}

std::uint32_t MessageReader::count(const char* what, std::size_t least) {
  const auto length = number<std::uint32_t>(what);
  if (length > rest().size() / least) {
    throw ReadError(std::to_string(length) + " " + what + " announced in " +
                    std::to_string(rest().size()) + " bytes");
  }
  return length;
}

std::uint32_t MessageReader::structures(const char* what, std::size_t least) {
  if (version2_) (void)number<std::uint32_t>(what);  // its size in bytes
  return count(what, least);
}

void MessageReader::begin_structure() {
  if (delimited_) (void)number<std::uint32_t>("size of a structure");
}

std::int64_t MessageReader::time(const char* what) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  begin_structure();
  const std::int64_t seconds = is_cdr() ? std::int64_t{number<std::int32_t>(what)}
                                        : std::int64_t{number<std::uint32_t>(what)};
  return seconds * kSecond + number<std::uint32_t>(what);
}

MessageHeader read_header(MessageReader& reader) {
  MessageHeader header;
  reader.begin_structure();
  if (!reader.is_cdr()) (void)reader.number<std::uint32_t>("header");  // ROS 1 counts messages
  header.stamp_ns = reader.time("stamp");
  header.frame = reader.string("frame");
  return header;
}

}  // namespace surefoot::io
