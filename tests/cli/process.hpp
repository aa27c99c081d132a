// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Runs the built program as a user does, and sees how it ends.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace surefoot::test {

/// How the program ended and what it said.
struct ProcessResult {
  int exit_code = -1;  ///< -1: ended by a signal
  int signal = 0;      ///< SIGALRM: longer than it may take
  std::string output;
  std::string errors;
};
std::ostream& operator<<(std::ostream& out, const ProcessResult& result);

/// What a program finds around it.
struct Surroundings {
  std::string program = {};                    ///< looked for as a shell does; empty: surefoot
  std::string output = "stdout.txt";           ///< file that what it prints goes to
  std::uint64_t most_file_bytes = UINT64_MAX;  ///< that it can write into a file: a full disk
  unsigned most_seconds = 60;                  ///< that it may take
};

/// A started program. Its memory is limited to 2 GiB, so that an allocation by a number found in a
/// file shows, and its time.
class Process {
 public:
  /// Starts `surefoot ARGUMENTS` in `folder`, where its two output streams are kept, too. Throws
  /// std::system_error.
  Process(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
          const Surroundings& surroundings = {});
  void send(int signal) const;
  /// Waits until the program has a handler of its own for this signal, or has ended.
  void wait_until_catching(int signal) const;
  [[nodiscard]] pid_t id() const { return id_; }
  /// Waits for the end; to be called once.
  [[nodiscard]] ProcessResult wait() const;

 private:
  std::filesystem::path folder_;
  std::string output_;
  pid_t id_;
};

[[nodiscard]] ProcessResult run_surefoot(const std::vector<std::string>& arguments,
                                         const std::filesystem::path& folder,
                                         const Surroundings& surroundings = {});

/// A folder of its own for every test, removed with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A whole file's bytes; empty where there is none.
[[nodiscard]] std::string file_content(const std::filesystem::path& file);
/// How many lines it has that are finished.
[[nodiscard]] std::size_t lines_of(const std::filesystem::path& file);
void write_content(const std::filesystem::path& file, const std::string& content);

}  // namespace surefoot::test
