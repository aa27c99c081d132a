// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/followed_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <thread>
#include <utility>

#include "io/recording.hpp"

namespace surefoot::live {
namespace {

/// A capture is asked for byte by byte; each call of the system costs more than these.
constexpr std::size_t kAhead = 256 << 10;
/// Of a file nobody tells that it has grown: looking this often costs nothing, and latency little.
constexpr std::chrono::milliseconds kLookAgain(5);

io::ReadError failed(int error) {
  return io::ReadError(std::string("cannot read it: ") + std::strerror(error));
}

}  // namespace

FollowedFile::FollowedFile(const std::filesystem::path& file, std::function<bool()> goes_on,
                           std::uint64_t may_change)
    : goes_on_(std::move(goes_on)),
      // A named pipe is opened at once, whether or not somebody writes to it yet.
      file_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)),
      may_change_(may_change) {
  if (file_ < 0) throw failed(errno);
  struct stat kind {};
  if (::fstat(file_, &kind) != 0 || !(S_ISREG(kind.st_mode) || S_ISFIFO(kind.st_mode))) {
    ::close(file_);
    throw io::ReadError("it is no file that can grow; expected a file or a pipe");
  }
  is_pipe_ = S_ISFIFO(kind.st_mode);
}

FollowedFile::~FollowedFile() { ::close(file_); }

std::size_t FollowedFile::read(std::span<std::byte> to) {
  std::size_t done = take_ahead(to);
  while (done < to.size()) {
    const std::span<std::byte> rest = to.subspan(done);
    const bool goes_ahead = rest.size() < kAhead && may_read_ahead();
    if (goes_ahead) ahead_.resize(kAhead);
    const std::span<std::byte> into = goes_ahead ? std::span(ahead_) : rest;
    const ssize_t got = ::read(file_, into.data(), into.size());
    if (goes_ahead) {
      ahead_.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
      next_ = 0;
    }
    if (got > 0) {
      position_ += static_cast<std::uint64_t>(got);
      done += goes_ahead ? take_ahead(rest) : static_cast<std::size_t>(got);
      continue;
    }
    if (got < 0 && errno != EAGAIN && errno != EINTR) throw failed(errno);
    // A pipe is at its end where all have closed it that once wrote to it.
    const bool has_ended = got == 0 && is_pipe_ && position_ > 0;
    if (has_ended || !wait()) break;
  }
  return done;
}

std::size_t FollowedFile::take_ahead(std::span<std::byte> to) {
  const std::size_t count = std::min(to.size(), ahead_.size() - next_);
  if (count == 0) return 0;
  std::memcpy(to.data(), ahead_.data() + next_, count);
  next_ += count;
  return count;
}

bool FollowedFile::may_read_ahead() {
  if (is_pipe_ || may_change_ == 0) return true;
  const auto has_enough = [this] { return size_ >= position_ + kAhead + may_change_; };
  struct stat now {};
  if (!has_enough() && ::fstat(file_, &now) == 0) size_ = static_cast<std::uint64_t>(now.st_size);
  return has_enough();
}

bool FollowedFile::wait() {
  if (!goes_on_()) return false;
  if (!is_pipe_) {
    struct stat now {};
    if (::fstat(file_, &now) == 0 && static_cast<std::uint64_t>(now.st_size) < position_) {
      throw io::ReadError("it has become shorter, " + std::to_string(now.st_size) +
                          " bytes, of which " + std::to_string(position_) + " were read");
    }
    std::this_thread::sleep_for(kLookAgain);
    return true;
  }
  pollfd more{file_, POLLIN, 0};
  constexpr int kWaitMs = 50;
  // A pipe that nobody has written to yet is told to be at its end at once, again and again.
  if (::poll(&more, 1, kWaitMs) > 0 && (more.revents & POLLIN) == 0) {
    std::this_thread::sleep_for(kLookAgain);
  }
  return true;
}

}  // namespace surefoot::live
