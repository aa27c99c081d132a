// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "piped_input.hpp"

#include <fmt/format.h>

#include "io/file_kind.hpp"
#include "io/recording.hpp"
#include "process/pipe_file.hpp"

namespace surefoot::app {

namespace {

/// What other programs call the standard input.
void refuse_dash(const std::filesystem::path& input) {
  if (input != "-" || std::filesystem::exists(input)) return;
  throw io::ReadError("-: no such file or folder; what comes through a pipe is /dev/stdin here");
}

}  // namespace

void take_piped_recording(const std::filesystem::path& input, bool quiet) {
  refuse_dash(input);
  const auto bytes = process::make_file_of_pipe(input, [](std::span<const std::byte> begin) {
    if (io::is_recording_begin(begin)) return;
    throw io::ReadError(begin.empty()
                            ? "nothing came through the pipe"
                            : "what comes through the pipe begins as no recording does: expected "
                              "a bag, a capture, PCD, PLY or LAS, compressed or not (KITTI's .bin "
                              "is told by its name alone)");
  });
  if (bytes && !quiet) {
    fmt::print(stderr,
               "note: {} is a pipe: its {:.1f} MB went to a temporary file in {}, which goes "
               "with this program\n",
               input.string(), 1e-6 * static_cast<double>(*bytes),
               std::filesystem::temp_directory_path().string());
  }
}

void take_piped_text(const std::filesystem::path& input) {
  refuse_dash(input);
  (void)process::make_file_of_pipe(input, [](std::span<const std::byte> begin) {
    for (const std::byte byte : begin) {
      if (byte == std::byte{0}) {
        throw io::ReadError("what comes through the pipe is no text; expected a trajectory");
      }
    }
  });
}

}  // namespace surefoot::app
