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
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0a,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

/// Of a message before its data: channel, sequence, two times.
inline constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;

}  // namespace surefoot::io::mcap
