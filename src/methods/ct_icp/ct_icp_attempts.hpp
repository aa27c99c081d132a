// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "methods/ct_icp/ct_icp.hpp"

namespace surefoot {

/// How far a scan's frame is from the one before.
struct CtIcpChange {
  double distance = 0.0;              ///< [m] within the scan
  double ego_orientation = 0.0;       ///< [deg] within the scan
  double relative_orientation = 0.0;  ///< [deg] from the last end to this one
};
[[nodiscard]] CtIcpChange change_of(const CtIcpFrame& previous, const CtIcpFrame& frame);

/// Whether a scan turned more than a robust profile allows.
[[nodiscard]] bool turns_fast(const CtIcpChange& change, const CtIcpParameters& config);

/// Whether a registration is good enough: `robust_level` of its parameters counts with
/// ct_icp.robust_registration only.
[[nodiscard]] bool is_plausible(const CtIcpResult& result, const CtIcpChange& change,
                                int robust_level, const CtIcpParameters& config);

/// The parameters of one attempt at a scan, and the cells of its grid sampling [m]: as configured,
/// and every level more patient and more tolerant.
struct CtIcpEffort {
  CtIcpParameters config;
  double sample_voxel_size;
  int level = 0;

  void increase();
};
/// `starting`: one of the first ct_icp.init_num_frames scans.
[[nodiscard]] CtIcpEffort first_effort(const CtIcpParameters& config, bool starting, int level);

/// What a robust profile remembers of the scans before.
class CtIcpCaution {
 public:
  explicit CtIcpCaution(const CtIcpParameters& config) : config_(config) {}

  /// The level that the next scan begins with.
  [[nodiscard]] int level() const { return level_; }
  /// Takes note of a scan; whether it may enter the map.
  [[nodiscard]] bool admit(const CtIcpResult& result, const CtIcpChange& change, int attempts);

 private:
  const CtIcpParameters& config_;
  int level_ = 0;
  int failures_ = 0;  // scans in succession that used up all attempts
};

}  // namespace surefoot
