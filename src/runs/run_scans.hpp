// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "io/recording.hpp"
#include "runs/run_options.hpp"

namespace surefoot::runs {

/// A run's scans, one after the other: of those of a recording the ones that its options ask for.
/// Both outlive it.
class RunScans {
 public:
  RunScans(io::Recording& recording, const RunOptions& options)
      : recording_(&recording), options_(options) {}

  /// The scan that the map begins with. A capture hardly ever begins where a revolution does; the
  /// part of one that it begins with shows the next scan too little, and is left out unless it is
  /// all there is.
  [[nodiscard]] std::optional<io::ScanItem> first();
  [[nodiscard]] std::optional<io::ScanItem> next();
  /// The i-th scan after the one that was given last, whose turn is yet to come; null beyond the
  /// end.
  [[nodiscard]] const io::ScanItem* ahead(std::size_t i);

  /// What is told of a part that was left out; empty if there was none.
  [[nodiscard]] const std::string& left_out() const { return left_out_; }
  /// The share of the scans that so many are.
  [[nodiscard]] double progress(std::size_t done) const;
  [[nodiscard]] const io::Recording& recording() const { return *recording_; }

  /// The same recording once more, from its begin on.
  void begin_again(std::unique_ptr<io::Recording> recording);

 private:
  [[nodiscard]] std::optional<io::ScanItem> read();

  io::Recording* recording_;
  const RunOptions& options_;
  std::unique_ptr<io::Recording> again_;
  std::deque<io::ScanItem> ahead_;
  std::string left_out_;
};

}  // namespace surefoot::runs
