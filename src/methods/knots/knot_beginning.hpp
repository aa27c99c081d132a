// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A map's first two scans, of whose motion nothing is known yet. docs/method.md, "The second scan".
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "methods/knots/knot_track.hpp"

namespace surefoot {

/// The first scan of a map, until the second one tells how it moved.
class KnotBeginning {
 public:
  explicit KnotBeginning(const ScanPart& first) : scan_(first.scan), points_(first.points) {}

  /// The second scan: from rest, which finds a walker's velocity, or turning, or from a faster
  /// start, if it fits as well or clearly better there. The track's map is made of the first scan
  /// alone then, as it moved, and ends where that one did.
  [[nodiscard]] RegisteredScan register_second(KnotTrack& track, const ScanPart& second) const;

 private:
  /// How the first scan moved, and the second one's registration on a map of that.
  struct Start {
    ScanTrajectory first;
    KnotEnd end;  // of the first
    VelocityModel model;
    RegisteredScan second;
  };

  [[nodiscard]] ScanPart first() const { return {scan_, points_}; }
  [[nodiscard]] Start start_at(const Twist& velocity, const KnotTrack& track) const;
  [[nodiscard]] Start registered_on(Start start, int rounds, KnotTrack& track,
                                    const ScanPart& second) const;
  [[nodiscard]] std::optional<Start> turned(const Start& start, KnotTrack& track,
                                            const ScanPart& second) const;
  void go_on_from(const Start& start, KnotTrack& track) const;

  PreparedScan scan_;
  std::vector<std::uint32_t> points_;
};

}  // namespace surefoot
