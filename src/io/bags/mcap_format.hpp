// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// MCAP as its specification has it (mcap.dev/spec): a record is an opcode, the length of its
// content in 64 bits, and the content.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace surefoot::io::mcap {

using namespace std::string_view_literals;
inline constexpr std::string_view kMagic = "\x89MCAP0\r\n"sv;

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0a,
  statistics = 0x0b,
  metadata = 0x0c,
  metadata_index = 0x0d,
  summary_offset = 0x0e,
  data_end = 0x0f,
};

/// Of a message before its data: channel, sequence, two times.
inline constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;

}  // namespace surefoot::io::mcap
