// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/animated_png.hpp"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "report/picture_mark.hpp"

namespace surefoot::report {

namespace {

constexpr std::uint32_t kTransparent = 0;

void append_big(std::string& bytes, std::uint32_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>((value >> shift) & 0xffU));
  }
}

/// Length, type, data, CRC of type and data.
void append_chunk(std::string& file, const char* type, const std::string& data) {
  append_big(file, static_cast<std::uint32_t>(data.size()), 4);
  const std::string body = type + data;
  file += body;
  const uLong crc =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  append_big(file, static_cast<std::uint32_t>(crc), 4);
}

std::string compressed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  if (status != Z_OK) throw std::runtime_error("cannot compress a frame of the animation");
  result.resize(size);
  return result;
}

void append_pixel(std::string& row, std::uint32_t argb) {
  for (const int shift : {16, 8, 0, 24}) row.push_back(static_cast<char>((argb >> shift) & 0xffU));
}

std::string header(int width, int height) {
  std::string data;
  append_big(data, static_cast<std::uint32_t>(width), 4);
  append_big(data, static_cast<std::uint32_t>(height), 4);
  // 8 bits a channel, RGBA, deflate, the one set of filters, no interlacing
  return data + std::string("\x08\x06\x00\x00\x00", 5);
}

}  // namespace

AnimatedPng::Frame AnimatedPng::changed_part(const Raster& frame) const {
  const auto changed = [&](int x, int y) {
    const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x);
    return shown_.empty() || frame.argb[i] != shown_[i];
  };
  int left = width_, right = -1, top = height_, bottom = -1;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (!changed(x, y)) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  // Where nothing changes there must be a pixel all the same.
  if (right < 0) left = right = top = bottom = 0;
  Frame part{left, top, right - left + 1, bottom - top + 1, 0, {}};
  std::string rows;
  for (int y = top; y <= bottom; ++y) {
    rows.push_back('\0');  // no filter: flat colours and gaps compress best as they are
    for (int x = left; x <= right; ++x) {
      const std::uint32_t value =
          frame.argb[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(x)];
      append_pixel(rows, changed(x, y) ? value | 0xff000000U : kTransparent);
    }
  }
  part.pixels = compressed(rows);
  return part;
}

void AnimatedPng::add(const Raster& frame, std::uint16_t milliseconds) {
  const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  if (frame.width != width_ || frame.height != height_ || frame.argb.size() != size) {
    throw std::invalid_argument("a frame of the animation has " + std::to_string(frame.width) +
                                " x " + std::to_string(frame.height) + " pixels instead of " +
                                std::to_string(width_) + " x " + std::to_string(height_));
  }
  frames_.push_back(changed_part(frame));
  frames_.back().milliseconds = milliseconds;
  shown_ = frame.argb;
}

void AnimatedPng::save(const std::filesystem::path& path) const {
  std::string bytes = "\x89PNG\r\n\x1a\n";
  append_chunk(bytes, "IHDR", header(width_, height_));
  std::string control;
  append_big(control, static_cast<std::uint32_t>(frames_.size()), 4);
  append_big(control, 0, 4);  // repeat without end
  append_chunk(bytes, "acTL", control);
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Frame& frame = frames_[i];
    std::string place;
    append_big(place, number++, 4);
    for (const int value : {frame.width, frame.height, frame.x, frame.y}) {
      append_big(place, static_cast<std::uint32_t>(value), 4);
    }
    append_big(place, frame.milliseconds, 2);
    append_big(place, 1000, 2);
    place += std::string("\x00\x01", 2);  // leave it there, blend over what is there
    append_chunk(bytes, "fcTL", place);
    if (i == 0) {
      append_chunk(bytes, "IDAT", frame.pixels);
    } else {
      std::string numbered;
      append_big(numbered, number++, 4);
      append_chunk(bytes, "fdAT", numbered + frame.pixels);
    }
  }
  append_chunk(bytes, "IEND", {});
  write_picture(path, with_mark(std::move(bytes), PageFormat::png, PictureKind::scene));
}

}  // namespace surefoot::report
