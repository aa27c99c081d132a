// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/picture_mark.hpp"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace surefoot::report {

namespace fs = std::filesystem;

namespace {

std::string_view mark_of(PictureKind kind) {
  switch (kind) {
    case PictureKind::run:
      return "Surefoot's picture of a run";
    case PictureKind::figure:
      return "Surefoot's figure";
    case PictureKind::scene:
      break;
  }
  return "Surefoot's picture of a scene";
}

/// Behind the mark stands no more than this: a comment's end, or a checksum and PNG's last chunk.
constexpr std::size_t kBehind = 16;

std::string big(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>((value >> shift) & 0xffU));
  }
  return bytes;
}

/// Length, type, data, CRC of type and data.
std::string text_chunk(std::string_view mark) {
  using namespace std::string_literals;
  const std::string body = "tEXtComment\0"s.append(mark);
  const uLong crc =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  constexpr std::size_t kType = 4;
  return big(static_cast<std::uint32_t>(body.size() - kType)) + body +
         big(static_cast<std::uint32_t>(crc));
}

bool has_mark(const fs::path& file, std::string_view mark) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(stream.tellg());
  const auto looked_at =
      std::min<std::streamoff>(size, static_cast<std::streamoff>(mark.size() + kBehind));
  if (looked_at <= 0) return false;
  std::string end(static_cast<std::size_t>(looked_at), '\0');
  stream.seekg(size - looked_at).read(end.data(), looked_at);
  return stream && end.find(mark) != std::string::npos;
}

}  // namespace

std::string with_mark(std::string bytes, PageFormat format, PictureKind kind) {
  const std::string_view mark = mark_of(kind);
  constexpr std::size_t kLastChunk = 12;  // IEND, which is empty
  switch (format) {
    case PageFormat::svg:
      return bytes.append("<!-- ").append(mark).append(" -->\n");
    case PageFormat::pdf:
      return bytes.append("%").append(mark).append("\n");
    case PageFormat::png:
      break;
  }
  return bytes.insert(bytes.size() - std::min(kLastChunk, bytes.size()), text_chunk(mark));
}

void write_picture(const fs::path& file, const std::string& bytes) {
  fs::path part = file;
  part += ".surefoot-part";  // as io::kUnfinished: a name that nobody else gives
  std::ofstream stream(part, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  const int error_number = errno;
  std::error_code error;
  if (stream) fs::rename(part, file, error);
  if (stream && !error) return;
  const std::string why = error ? error.message() : std::strerror(error_number);
  fs::remove(part, error);
  throw std::runtime_error(file.string() + ": cannot write the picture: " + why);
}

void require_picture_or_nothing(const fs::path& file, PictureKind kind, bool overwrite) {
  const fs::file_status status = fs::symlink_status(file);
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) {
    throw std::runtime_error(file.string() +
                             ": is there already and is no file; choose another name");
  }
  if (overwrite || has_mark(file, mark_of(kind))) return;
  throw std::runtime_error(
      file.string() +
      ": is there already and is no earlier picture of this kind; choose another "
      "name, or --overwrite");
}

}  // namespace surefoot::report
