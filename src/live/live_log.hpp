// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What became of every scan of a live run, a line each: what `surefoot run --like` repeats.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <vector>

namespace surefoot::live {

class LiveLog {
 public:
  void used(std::int64_t stamp_ns, const std::string& scan, double latency_ms);
  void dropped(std::int64_t stamp_ns, const std::string& scan);
  void paused(std::int64_t stamp_ns, const std::string& scan);
  /// The odometry begins anew with the next scan that is used.
  void reset();

  /// Lines go there from now on, and those that were kept so far. Throws std::runtime_error.
  void open(const std::filesystem::path& file);

 private:
  void add(const std::string& line);

  std::mutex mutex_;
  std::string kept_;
  std::ofstream file_;
};

/// Stamps of scans.
struct UsedScans {
  std::vector<std::int64_t> used;
  std::vector<std::int64_t> reset_before;  ///< those with which the odometry began anew
};
/// What a log says was used. Throws io::ReadError naming file and line.
[[nodiscard]] UsedScans used_scans(const std::filesystem::path& log);

}  // namespace surefoot::live
