// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/input_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "io/decimal_time.hpp"
#include "runs/length_unit.hpp"
#include "runs/output_folder.hpp"
#include "runs/run_truth.hpp"

namespace surefoot::runs {

namespace {

std::string no_scan_text(const RunOptions& options) {
  const std::string input = options.input.string();
  if (options.like.empty()) {
    return fmt::format("{}: no scans after the first {}", input, options.start);
  }
  return fmt::format(
      "{}: none of the {} scans that {} names is there; expected the recording of that run, "
      "read with its options",
      input, options.only_stamps.size(), options.like.string());
}

/// A recording of which no scan can be read leaves nothing behind, and an earlier run where it is.
/// Of many the first ones tell.
void refuse_unreadable(const RunOptions& options, const std::string& error) {
  if (options.is_live) return;
  constexpr int kToldBy = 100;
  const std::unique_ptr<io::Recording> again = io::open_recording(options.input, options.reader);
  again->skip(options.start);
  int unreadable = 0;
  for (auto item = again->next(); item; item = again->next()) {
    if (item->scan || ++unreadable == kToldBy) return;
  }
  throw io::ReadError(fmt::format("{}: none of {} scans can be read, the first: {}",
                                  options.input.string(), unreadable, error));
}

}  // namespace

void refuse_run_folder(const std::filesystem::path& input) {
  if (!is_run_folder(input)) return;
  throw io::ReadError(input.string() +
                      ": is the folder of a run; expected a recording (its run.yaml names one: "
                      "--config repeats that run)");
}

void check_first_scan(const RunOptions& options, const std::optional<io::ScanItem>& first) {
  if (!first) throw io::ReadError(no_scan_text(options));
  if (first->scan) {
    refuse_other_units(*first->scan, options.input.string() + ": " + first->name);
  } else {
    refuse_unreadable(options, first->error);
  }
}

void refuse_past_truth(const RunOptions& options, const std::optional<io::ScanItem>& first,
                       RunScans& scans) {
  if (options.truth.empty() || !first || !first->scan) return;
  constexpr std::int64_t kLongestScan = 1'000'000'000;  // whose stamp may be its end
  constexpr std::size_t kLookedAt = 5;
  const Trajectory truth = read_truth_poses(options.truth);
  if (truth.empty()) return;
  const auto is_past = [&](const io::ScanItem& one) {
    return !one.scan || std::all_of(truth.begin(), truth.end(), [&](const StampedPose& pose) {
      return pose.stamp_ns < one.scan->stamp_ns - kLongestScan;
    });
  };
  const io::ScanItem* one = &*first;
  for (std::size_t i = 0; one != nullptr; ++i) {
    if (!is_past(*one)) return;
    if (i + 1 >= std::min(kLookedAt, options.count)) break;
    one = scans.ahead(i);
  }
  throw io::ReadError(fmt::format(
      "{}: tells of {} to {} s, and the first scan is of {} s: expected a truth with the "
      "recording's stamps",
      options.truth.string(), io::format_seconds(truth.front().stamp_ns),
      io::format_seconds(truth.back().stamp_ns), io::format_seconds(first->scan->stamp_ns)));
}

}  // namespace surefoot::runs
