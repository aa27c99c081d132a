// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A few sweeps of a run as they were measured and as they were deskewed, for the report.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "report/report.hpp"
#include "surefoot/estimate.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::runs {

/// Keeps the sweeps within which the sensor moved most, no two of the same stretch of way.
class DeskewSamples {
 public:
  /// `line`: the scan's in scans.csv. A scan without point times, or one that was not registered,
  /// has nothing to show.
  void add(std::size_t line, const Scan& scan, const Estimate& estimate);

  /// By line.
  [[nodiscard]] std::vector<report::DeskewSample> samples() const;

 private:
  struct Kept {
    double motion = 0.0;  // [m]
    report::DeskewSample sample;
  };
  std::vector<Kept> kept_;  // by line
};

/// One PLY: a point's place in the map frame deskewed (x, y, z) and as measured, its time within
/// the sweep (0 to 1), its sweep. Throws io::WriteError.
void write_deskew_samples(const std::filesystem::path& file,
                          const std::vector<report::DeskewSample>& samples);
/// Throws io::ReadError.
[[nodiscard]] std::vector<report::DeskewSample> read_deskew_samples(
    const std::filesystem::path& file);

}  // namespace surefoot::runs
