// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A recording in, a run's folder out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/bags/bag_writer.hpp"
#include "runs/map_outcome.hpp"
#include "runs/run_options.hpp"
#include "surefoot/estimate.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::runs {

/// What came of a run.
struct RunOutcome {
  std::map<Status, std::size_t> statuses;
  std::size_t used = 0;              ///< scans
  std::vector<double> milliseconds;  ///< of each of them; the last 100,000
  double length = 0.0;               ///< of the path [m]
  std::size_t unreadable = 0;        ///< scans that could not be read
  std::size_t partial = 0;           ///< scans that were left out for being part of one
  std::size_t segments = 1;          ///< each in a frame of its own
  std::vector<std::string> losses;   ///< what of recording or results is damaged or missing
  std::size_t poses = 0;
  bool interrupted = false;
  std::filesystem::path folder;
  std::optional<MapOutcome> map;  ///< where loops were to be closed
  std::optional<LocalizationOutcome> localization;

  [[nodiscard]] std::size_t scans() const { return used; }
};

/// What may be asked of a run while it goes on, between two scans on its own thread.
class RunControl {
 public:
  virtual ~RunControl() = default;
  /// The odometry begins anew where it was set up to begin, in a segment and a map of its own.
  virtual void reset() = 0;
  /// Writes map.ply as it is now. Throws io::WriteError.
  virtual std::filesystem::path save_map() = 0;
  /// Searches for its place in a saved map from now on, anew if it did before. Empty: in the map
  /// that it has. Throws io::ReadError, std::invalid_argument where it has none.
  virtual void localize(const std::filesystem::path& map) = 0;
};

/// Who is told what goes on while it runs.
struct RunListener {
  std::function<void(const std::string& text)> say;
  std::function<void(std::size_t scans, double share)> progress;
  std::function<bool()> interrupted;  ///< true ends the run in good order
  /// The folder is made, nothing is used yet. May be empty.
  std::function<void(const std::filesystem::path& folder, RunControl& run)> started = {};
  /// A scan was answered; `odometry` has just done it. May be empty.
  std::function<void(const std::string& name, const Estimate& estimate, const Odometry& odometry)>
      answered = {};
  /// Where else the run's messages go, as it runs. May be null.
  std::shared_ptr<io::BagWriter> messages = {};
  /// Told of scans that could not be read, in place of `say`: errors are shown also where notes
  /// are not. May be empty.
  std::function<void(const std::string& text)> complain = {};
};

/// Runs the odometry from the first scan to the last file. Bad input leaves no folder behind.
/// Throws ConfigError, io::ReadError, std::runtime_error for what cannot be written.
[[nodiscard]] RunOutcome run_odometry(const RunOptions& options, const RunListener& listener);
/// The same with scans from elsewhere: of a sensor that is running. `options.input` names them.
[[nodiscard]] RunOutcome run_odometry(const RunOptions& options, const RunListener& listener,
                                      io::Recording& recording);

}  // namespace surefoot::runs
