// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "process/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

#include "process/exit_codes.hpp"

namespace surefoot::process {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Only calls that are allowed between fork and exec.
[[noreturn]] void become_child(char* const* arguments, const char* log, pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
  if (getppid() != parent) _exit(kCannotStart);  // it is gone already
  const int input = open("/dev/null", O_RDONLY);
  const int output = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (input < 0 || output < 0 || dup2(input, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 ||
      dup2(output, STDERR_FILENO) < 0) {
    _exit(kCannotStart);
  }
  execv("/proc/self/exe", arguments);
  _exit(kCannotStart);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments,
                           const std::filesystem::path& log)
    : begin_(std::chrono::steady_clock::now()) {
  std::vector<std::string> words{"surefoot"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (id_ == 0) become_child(pointers.data(), log.c_str(), parent);
}

std::optional<ProcessEnd> ChildProcess::poll() {
  int status = 0;
  rusage usage{};
  const pid_t ended = wait4(id_, &status, WNOHANG, &usage);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return std::nullopt;
  if (ended < 0) throw std::system_error(errno, std::generic_category(), "wait4");
  ProcessEnd end;
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  end.processor_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.peak_memory_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024U;  // KiB on Linux
  return end;
}

void ChildProcess::send(int signal) const { kill(id_, signal); }

std::string describe(const ProcessEnd& end) {
  if (end.signal == 0) return fmt::format("ended with exit code {}", end.exit_code);
  const std::string why = end.signal == SIGKILL ? " (out of memory, or killed by hand)" : "";
  return fmt::format("ended by signal {} ({}){}", end.signal, strsignal(end.signal), why);
}

}  // namespace surefoot::process
