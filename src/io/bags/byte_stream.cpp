// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/byte_stream.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "io/file_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {

std::uint64_t ByteStream::skip(std::uint64_t count) {
  std::array<std::byte, 16'384> passed;
  std::uint64_t done = 0;
  while (done < count) {
    const auto step =
        static_cast<std::size_t>(std::min<std::uint64_t>(count - done, passed.size()));
    const std::size_t got = read({passed.data(), step});
    done += got;
    if (got < step) break;
  }
  return done;
}

FileStream::FileStream(const std::filesystem::path& file) {
  require_regular_file(file);
  errno = 0;
  file_.reset(std::fopen(file.c_str(), "rb"));
  if (!file_) throw ReadError(std::string("cannot read it: ") + std::strerror(errno));
  std::error_code ignored;
  size_ = std::filesystem::file_size(file, ignored);
  constexpr std::size_t kBuffered = 1 << 18;
  std::setvbuf(file_.get(), nullptr, _IOFBF, kBuffered);
}

std::size_t FileStream::read(std::span<std::byte> to) {
  errno = 0;
  const std::size_t got = std::fread(to.data(), 1, to.size(), file_.get());
  if (got < to.size() && std::ferror(file_.get()) != 0) {
    throw ReadError("cannot read on after " + std::to_string(position_ + got) +
                    " bytes: " + std::strerror(errno));
  }
  position_ += got;
  return got;
}

double FileStream::progress() const {
  return size_ == 0 ? 1.0
                    : std::min(1.0, static_cast<double>(position_) / static_cast<double>(size_));
}

std::size_t MemoryStream::read(std::span<std::byte> to) {
  const std::size_t count = std::min(to.size(), rest_.size());
  std::copy_n(rest_.begin(), count, to.begin());
  rest_ = rest_.subspan(count);
  return count;
}

std::size_t LimitedStream::read(std::span<std::byte> to) {
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(to.size(), left_));
  const std::size_t got = whole_.read(to.first(count));
  left_ -= got;
  return got;
}

std::uint64_t LimitedStream::skip(std::uint64_t count) {
  const std::uint64_t done = whole_.skip(std::min(count, left_));
  left_ -= done;
  return done;
}

std::size_t LookAheadStream::read(std::span<std::byte> to) {
  if (ahead_.empty()) return whole_.read(to);
  const std::size_t kept = std::min(to.size(), ahead_.size() - next_);
  std::copy_n(ahead_.begin() + static_cast<std::ptrdiff_t>(next_), kept, to.begin());
  next_ += kept;
  if (next_ == ahead_.size()) {
    ahead_ = {};
    next_ = 0;
  }
  return kept + (kept < to.size() ? whole_.read(to.subspan(kept)) : 0);
}

std::size_t LookAheadStream::peek(std::size_t offset, std::span<std::byte> to) {
  // What was read goes once it is half of all: moved at every peek, the rest would cost the most.
  if (next_ > ahead_.size() / 2) {
    ahead_.erase(ahead_.begin(), ahead_.begin() + static_cast<std::ptrdiff_t>(next_));
    next_ = 0;
  }
  constexpr std::size_t kStep = 1 << 20;  // grows as bytes come
  const std::size_t first = next_ + offset;
  while (ahead_.size() < first + to.size()) {
    const std::size_t have = ahead_.size();
    const std::size_t step = std::min(kStep, first + to.size() - have);
    ahead_.resize(have + step);
    const std::size_t got = whole_.read(std::span(ahead_).subspan(have));
    ahead_.resize(have + got);
    if (got < step) break;
  }
  const std::size_t there = ahead_.size() > first ? ahead_.size() - first : 0;
  const std::size_t count = std::min(there, to.size());
  std::copy_n(ahead_.begin() + static_cast<std::ptrdiff_t>(std::min(first, ahead_.size())), count,
              to.begin());
  return count;
}

std::size_t ChecksumStream::read(std::span<std::byte> to) {
  const std::size_t got = whole_.read(to);
  crc_ = crc32(to.first(got), crc_);
  size_ += got;
  return got;
}

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before) {
  return libdeflate_crc32(before, bytes.data(), bytes.size());
}

std::span<const std::byte> read_all(ByteStream& stream, std::vector<std::byte>& buffer,
                                    std::size_t most) {
  constexpr std::size_t kStep = 1 << 20;
  std::size_t have = 0;
  while (have < most) {
    const std::size_t upto = std::min(most, std::max(buffer.size(), have + std::max(kStep, have)));
    if (buffer.size() < upto) buffer.resize(upto);
    have += stream.read({buffer.data() + have, upto - have});
    if (have < upto) break;
  }
  return std::span<const std::byte>(buffer).first(have);
}

std::optional<std::span<const std::byte>> read_bytes(ByteStream& stream, std::uint64_t size,
                                                     std::vector<std::byte>& buffer) {
  const std::span<const std::byte> bytes = read_all(stream, buffer, size);
  return bytes.size() == size ? std::optional(bytes) : std::nullopt;
}

}  // namespace surefoot::io
