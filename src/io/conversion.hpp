// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A recording's scans in another format.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "io/recording.hpp"
#include "io/scan_sink.hpp"

namespace surefoot::io {

struct ConversionRequest {
  std::filesystem::path input;
  std::filesystem::path output;
  OpenOptions reader;
  /// Of a bag; empty: all that scans can be made of, and other messages as they are, where the
  /// output is a bag.
  std::vector<std::string> topics;
  SinkOptions sink{.topic = "", .frame = ""};  ///< empty: the source's, else SinkOptions' own
  std::string format;                          ///< empty: by the output's name
  double begin = 0.0;                          ///< [s] after the first scan's stamp
  double end = std::numeric_limits<double>::infinity();
  std::size_t start = 0;
  std::size_t count = std::numeric_limits<std::size_t>::max();
  std::size_t stride = 1;

  [[nodiscard]] bool begins_with_all() const { return begin == 0 && start == 0; }
  [[nodiscard]] bool ends_with_all() const {
    return end == std::numeric_limits<double>::infinity() &&
           count == std::numeric_limits<std::size_t>::max();
  }
};

/// Who is told what goes on.
struct ConversionListener {
  std::function<void(std::size_t scans, double share)> progress;
  std::function<void(const std::string& text)> complain;  ///< of a scan that is left out
  std::function<bool()> interrupted;                      ///< true ends it, and nothing is kept
};

struct ConversionOutcome {
  std::size_t scans = 0;
  std::size_t points = 0;
  std::size_t unreadable = 0;  ///< scans
  std::size_t messages = 0;    ///< of other topics, copied as they are
  std::size_t topics = 0;      ///< of those
  std::size_t packets = 0;     ///< of a capture, copied as they are
  bool interrupted = false;    ///< nothing is written, whatever was read
  std::vector<std::string> notes;
  std::vector<std::string> losses;  ///< what the source has and the output has not, a line each
};

/// scan_format_names(), and "pcap".
[[nodiscard]] const std::vector<std::string>& conversion_format_names();

/// Throws std::invalid_argument where the output is there and more than an empty folder (of outputs
/// that are folders).
void require_unused(const std::filesystem::path& output, bool is_folder);

/// Throws ReadError, WriteError, std::invalid_argument where the output is there already or has a
/// name that tells no format.
[[nodiscard]] ConversionOutcome convert_recording(const ConversionRequest& request,
                                                  const ConversionListener& listener);

}  // namespace surefoot::io
