// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/pcd_reader.hpp"

#include <lzf.h>

#include <limits>
#include <string>

#include "io/ascii_values.hpp"
#include "io/files/pcd_header.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

static_assert(std::endian::native == std::endian::little, "PCD data are little-endian");

using Bytes = std::span<const std::byte>;

bool is_padding(const PcdField& field) { return field.name == "_"; }

// Points of a sweep do not compress beyond this (LZF could make 88 bytes of one): clouds that are
// nearly all NaN come nearest. Small files may, they take little all the same.
constexpr std::size_t kLargestRatio = 32;
constexpr std::size_t kSmall = 64 << 20;

void check_room(const PcdHeader& header, std::size_t room, const char* of) {
  if (header.points > room / header.point_step) {
    throw ReadError("PCD: " + std::to_string(header.points) + " points of " +
                    std::to_string(header.point_step) + " bytes do not fit the " +
                    std::to_string(room) + " bytes of " + of);
  }
}

void read_binary(const PcdHeader& header, Bytes data, PointTable& table) {
  check_room(header, data.size(), "data");
  for (const PcdField& field : header.fields) {
    if (!is_padding(field)) {
      const std::byte* first = header.points > 0 ? data.data() + field.offset : nullptr;
      table.columns.push_back(
          {field.name, field.type, first, header.point_step, false, field.count});
    }
  }
}

std::vector<std::byte> decompress(const PcdHeader& header, Bytes data) {
  if (data.size() < 8) {
    throw ReadError("PCD: " + std::to_string(data.size()) +
                    " bytes of data; expected two sizes of 4 bytes first");
  }
  const auto compressed = load<std::uint32_t>(data.data(), false);
  const auto uncompressed = load<std::uint32_t>(data.data() + 4, false);
  const std::size_t room = data.size() - 8;
  if (compressed > room) {
    throw ReadError("PCD: compressed size " + std::to_string(compressed) + ", uncompressed size " +
                    std::to_string(uncompressed) + ", but " + std::to_string(room) +
                    " bytes follow");
  }
  if (uncompressed > kSmall && uncompressed / kLargestRatio > compressed) {
    throw ReadError("PCD: " + std::to_string(compressed) + " bytes that become " +
                    std::to_string(uncompressed) + "; expected at most " +
                    std::to_string(kLargestRatio) + " times as many");
  }
  check_room(header, uncompressed, "uncompressed data");
  std::vector<std::byte> plain(uncompressed);
  if (uncompressed > 0 &&
      lzf_decompress(data.data() + 8, compressed, plain.data(), uncompressed) != uncompressed) {
    throw ReadError("PCD: the " + std::to_string(compressed) +
                    " bytes of compressed data are not LZF of " + std::to_string(uncompressed) +
                    " bytes");
  }
  return plain;
}

// Fields one after the other, each for all points.
void read_compressed(const PcdHeader& header, Bytes data, PointTable& table) {
  table.storage = decompress(header, data);
  const std::byte* at = table.storage.data();
  for (const PcdField& field : header.fields) {
    const std::size_t stride = field.count * size_of(field.type);
    if (!is_padding(field)) {
      table.columns.push_back({field.name, field.type, at, stride, false, field.count});
    }
    at += stride * header.points;  // of no points: nullptr stays nullptr
  }
}

// Some writers print a byte as the character that it is, after one space; it may be a space itself.
bool take_raw_byte(std::string_view& line, std::byte* out) {
  if (line.size() < 2 || line[0] != ' ') return false;
  if (line.size() > 2 && line[2] != ' ' && line[2] != '\r') return false;
  *out = static_cast<std::byte>(line[1]);
  line.remove_prefix(2);
  return true;
}

// What is wrong with a line that is not a point's; empty if nothing is.
std::string store_point(const PcdHeader& header, std::string_view line, bool raw_bytes,
                        std::byte* out) {
  for (const PcdField& field : header.fields) {
    for (std::size_t element = 0; element < field.count; ++element) {
      const bool raw = raw_bytes && size_of(field.type) == 1 && take_raw_byte(line, out);
      const std::string_view word = raw ? std::string_view{} : take_word(line);
      const bool stored =
          raw || (is_padding(field) ? !word.empty() : store_number(word, field.type, out));
      if (!stored) {
        return "field " + in_quotes(field.name) + " is " + in_quotes(word) + "; expected a " +
               name_of(field.type);
      }
      out += size_of(field.type);
    }
  }
  const std::string_view extra = take_word(line);
  return extra.empty() ? "" : in_quotes(extra) + " after the last field";
}

void read_ascii_point(const PcdHeader& header, std::string_view line, std::size_t line_number,
                      std::byte* out) {
  const std::string wrong = store_point(header, line, false, out);
  if (wrong.empty() || store_point(header, line, true, out).empty()) return;
  throw ReadError("PCD line " + std::to_string(line_number) + ": " + wrong);
}

void read_ascii(const PcdHeader& header, Bytes data, PointTable& table) {
  // A value takes two characters at least and eight bytes at most.
  if (header.points > (data.size() + 1) / 2) {
    throw ReadError("PCD: " + std::to_string(header.points) + " points do not fit the " +
                    std::to_string(data.size()) + " bytes of data");
  }
  LineReader lines(text_of(data));
  std::string_view line;
  std::size_t point = 0;
  while (point < header.points && lines.next(line)) {
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) {
      continue;
    }
    table.storage.resize((point + 1) * header.point_step);
    read_ascii_point(header, line, header.lines + lines.line_number(),
                     table.storage.data() + point * header.point_step);
    ++point;
  }
  if (point != header.points) {
    throw ReadError("PCD: " + std::to_string(point) + " points in the file; the header says " +
                    std::to_string(header.points));
  }
  read_binary(header, table.storage, table);
}

// Coordinates of a byte each are none, and would become twelve times as large here.
void check_coordinates(const PcdHeader& header) {
  for (const PcdField& field : header.fields) {
    const bool coordinate = field.name == "x" || field.name == "y" || field.name == "z";
    if (coordinate && size_of(field.type) < 2) {
      throw ReadError("PCD: field " + field.name + " is " + name_of(field.type) +
                      "; expected coordinates of 2, 4 or 8 bytes");
    }
  }
}

}  // namespace

PointTable parse_pcd(std::span<const std::byte> file) {
  const PcdHeader header = parse_pcd_header(text_of(file));
  check_coordinates(header);
  const Bytes data = file.subspan(header.data_offset);
  PointTable table;
  table.size = header.points;
  switch (header.data) {
    case PcdData::ascii:
      table.format = "PCD ascii";
      read_ascii(header, data, table);
      break;
    case PcdData::binary:
      table.format = "PCD binary";
      read_binary(header, data, table);
      break;
    case PcdData::binary_compressed:
      table.format = "PCD binary_compressed";
      read_compressed(header, data, table);
      break;
  }
  return table;
}

}  // namespace surefoot::io
