// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A whole recording looked at before it is run: what is odd, whether a run would suffer of it, and
// whether its motion agrees with its times.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checks/findings.hpp"
#include "checks/stamp_lag.hpp"
#include "checks/stretch_motion.hpp"
#include "checks/time_trials.hpp"

namespace surefoot::checks {

struct CheckOptions {
  std::filesystem::path input;
  io::OpenOptions reader;
  bool motion = true;               ///< try the readings of the point times
  std::size_t stretch_scans = 100;  ///< on so many scans
  std::filesystem::path truth;      ///< TUM file, or a bag with poses: what the stamps are told by
  std::string truth_topic;
  int threads = 1;
};

struct CheckListener {
  std::function<void(std::size_t scans, double share)> progress;
  std::function<void(const std::string& text)> say;
  std::function<bool()> interrupted;
};

/// The stretch that the readings were tried on, and what came of it.
struct MotionCheck {
  std::size_t begin = 0;  ///< place of its first scan in the recording
  std::size_t count = 0;
  double turned_deg = 0.0;  ///< by the scans' outlines, roughly: what it was chosen by
  TimeTrials trials;
  std::optional<StretchMotion> moved = {};  ///< nothing where it could not be followed
  std::string reference;                    ///< what the stamps were compared with; empty: nothing
  StampLag lag;
};

struct RecordingCheck {
  std::string description;
  std::vector<std::string> notes;
  std::vector<std::string> layouts;
  std::vector<ScanFacts> scans;
  Figures figures;
  io::CaptureCounts counts;
  std::vector<Finding> findings;
  std::optional<MotionCheck> motion;
  /// What the times are and what the motion says of them, a sentence each.
  std::vector<std::string> time_sentences;
  std::vector<std::string> motion_sentences;

  [[nodiscard]] bool suffers() const;
  /// "fit for a run", or how many things speak against it.
  [[nodiscard]] std::string verdict() const;
};

/// Throws io::ReadError where the recording cannot be opened.
[[nodiscard]] RecordingCheck check_recording(const CheckOptions& options,
                                             const CheckListener& listener);

}  // namespace surefoot::checks
