// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "process/pipe_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::process {
namespace {

namespace fs = std::filesystem;

// The number of the open file that a path names; nothing where it names one of the disk's.
std::optional<int> descriptor_of(const fs::path& path) {
  std::string_view name = path.native();
  if (name == "/dev/stdin") return STDIN_FILENO;
  constexpr std::string_view kFolders[] = {"/dev/fd/", "/proc/self/fd/"};
  for (const std::string_view folder : kFolders) {
    if (!name.starts_with(folder)) continue;
    name.remove_prefix(folder.size());
    int number = -1;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error == std::errc() && end == name.data() + name.size()) return number;
  }
  return std::nullopt;
}

bool is_pipe(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

/// An open file that closes.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// Never has a name where the file system can do so: a signal between making and unlinking a named
/// one would leave it behind.
int make_nameless_file() {
  const fs::path folder = fs::temp_directory_path();
  const int nameless = open(folder.c_str(), O_TMPFILE | O_RDWR, 0600);
  if (nameless >= 0) return nameless;
  std::string name = (folder / "surefoot_pipe_XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0) {
    throw std::runtime_error(name + ": no temporary file can be made: " + std::strerror(errno));
  }
  (void)unlink(name.c_str());
  return file;
}

std::size_t read_some(int from, std::span<std::byte> to) {
  for (;;) {
    const ssize_t got = read(from, to.data(), to.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) throw std::runtime_error(std::strerror(errno));
  }
}

void write_all(int to, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = write(to, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) {
      throw std::runtime_error("what comes through the pipe has no room in " +
                               fs::temp_directory_path().string() + ": " + std::strerror(errno) +
                               " (TMPDIR names another folder)");
    }
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

std::uint64_t copy(int from, int to, const PipeJudge& judge) {
  std::vector<std::byte> part(1 << 18);
  std::size_t begin = 0;
  while (begin < kJudgedBytes) {  // a pipe gives what there is, be it a byte
    const std::size_t got = read_some(from, std::span(part).subspan(begin));
    begin += got;
    if (got == 0) break;
  }
  judge(std::span(part).first(begin));
  write_all(to, std::span(part).first(begin));
  std::uint64_t bytes = begin;
  while (const std::size_t got = read_some(from, part)) {
    write_all(to, std::span(part).first(got));
    bytes += got;
  }
  return bytes;
}

}  // namespace

std::optional<std::uint64_t> make_file_of_pipe(const fs::path& path, const PipeJudge& judge) {
  const std::optional<int> pipe = descriptor_of(path);
  if (!pipe || !is_pipe(*pipe)) return std::nullopt;
  try {
    const Descriptor file(make_nameless_file());
    const std::uint64_t bytes = copy(*pipe, file.number(), judge);
    if (dup2(file.number(), *pipe) < 0) throw std::runtime_error(std::strerror(errno));
    return bytes;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

}  // namespace surefoot::process
