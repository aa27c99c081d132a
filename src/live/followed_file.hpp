// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A file that somebody else is still writing, or a pipe: its bytes as they come.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "io/bags/byte_stream.hpp"

namespace surefoot::live {

class FollowedFile final : public io::ByteStream {
 public:
  /// @param goes_on asked several times in a tenth of a second while nothing new is there; where it
  /// says no, the file ends.
  /// @param may_change so many bytes before a file's end its writer may still write anew: they are
  /// read when they are asked for, no sooner. Throws io::ReadError without the file's name.
  FollowedFile(const std::filesystem::path& file, std::function<bool()> goes_on,
               std::uint64_t may_change = 0);
  ~FollowedFile() override;
  FollowedFile(const FollowedFile&) = delete;
  FollowedFile& operator=(const FollowedFile&) = delete;

  /// Waits until all of `to` is there. Throws io::ReadError, also where the file has become shorter
  /// than what was read of it.
  std::size_t read(std::span<std::byte> to) override;

 private:
  [[nodiscard]] bool wait();
  /// Of what was read ahead; returns how much.
  std::size_t take_ahead(std::span<std::byte> to);
  [[nodiscard]] bool may_read_ahead();

  std::function<bool()> goes_on_;
  int file_;
  bool is_pipe_ = false;
  std::uint64_t may_change_;
  std::uint64_t position_ = 0;  ///< of the file's next byte, behind what was read ahead
  std::uint64_t size_ = 0;      ///< of a file, when last looked at
  std::vector<std::byte> ahead_;
  std::size_t next_ = 0;  ///< of those
};

}  // namespace surefoot::live
