// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "process/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace surefoot::process {
namespace {

// open() gives out the lowest number that is free. The way of use that the stream has not: reading
// from it, or writing, fails as before.
void take_place(int stream) {
  if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) return;
  (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

#ifdef __GLIBC__
ssize_t write_if_possible(void* /*cookie*/, const char* bytes, size_t size) {
  for (size_t done = 0; done < size;) {
    const ssize_t step = write(STDERR_FILENO, bytes + done, size - done);
    if (step < 0 && errno == EINTR) continue;
    if (step <= 0) break;
    done += static_cast<size_t>(step);
  }
  return static_cast<ssize_t>(size);
}
#endif

}  // namespace

void guard_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) take_place(stream);
  std::signal(SIGPIPE, SIG_IGN);  // to write to such a pipe fails, as elsewhere
  std::signal(SIGXFSZ, SIG_IGN);  // so does what exceeds the limit of a file's size (ulimit -f)
#ifdef __GLIBC__
  std::FILE* const patient =
      fopencookie(nullptr, "w", {nullptr, write_if_possible, nullptr, nullptr});
  if (patient == nullptr) return;
  std::setvbuf(patient, nullptr, _IONBF, 0);
  stderr = patient;
#endif
}

void end_without_reader() {
  std::signal(SIGPIPE, SIG_DFL);
  (void)std::raise(SIGPIPE);
  std::_Exit(128 + SIGPIPE);  // whoever started us has blocked it
}

}  // namespace surefoot::process
