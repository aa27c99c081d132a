// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The scans of one topic (or of all of what is no bag) on their way to an output.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "io/conversion.hpp"
#include "io/recording.hpp"
#include "io/scan_sink.hpp"

namespace surefoot::io {

class ConversionLane {
 public:
  ConversionLane(std::unique_ptr<Recording> recording, const ConversionRequest& request)
      : recording_(std::move(recording)), request_(request) {}

  [[nodiscard]] const Recording& recording() const { return *recording_; }
  /// The next scan that is asked for by number, or what stands for one; null at the end.
  [[nodiscard]] const ScanItem* item();
  /// The same is done with.
  void pass();
  /// Whether the item is within the time range, counted from `first_ns`, on the clock `at_ns`.
  [[nodiscard]] bool is_within(std::int64_t first_ns, std::int64_t at_ns);
  /// The item into the output; why it cannot be, or empty.
  [[nodiscard]] std::string add();
  /// The item goes otherwise.
  void count();
  /// Where scans go to: before the first add().
  void set_sink(std::unique_ptr<ScanSink> sink) { sink_ = std::move(sink); }
  [[nodiscard]] ScanSink* sink() { return sink_.get(); }
  [[nodiscard]] std::size_t scans() const { return scans_; }
  [[nodiscard]] std::size_t points() const { return points_; }
  /// A line each.
  [[nodiscard]] std::vector<std::string> losses() const;

 private:
  /// As a run does: a scan of points does not tell any more that it is the part of a revolution
  /// that a capture begins within, unless that is all there is.
  void leave_out_part();

  std::unique_ptr<Recording> recording_;
  const ConversionRequest& request_;
  std::unique_ptr<ScanSink> sink_;
  std::optional<ScanItem> item_;
  std::string left_out_;
  bool begun_ = false, ended_ = false;
  std::size_t scans_ = 0, points_ = 0;
  std::size_t dropped_points_ = 0, dropped_empty_ = 0;
  std::size_t late_in_a_row_ = 0;
  double rounded_by_ = 0.0;  ///< [m]
  std::set<std::string> field_losses_;
};

}  // namespace surefoot::io
