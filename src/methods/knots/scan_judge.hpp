// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Whether a registered scan is right. docs/method.md, "Is it right?".
#pragma once

#include <cstdint>
#include <vector>

#include "methods/knots/evidence.hpp"
#include "methods/knots/knot_track.hpp"

namespace surefoot {

/// So many scans must agree before a map, or a place that was found again, is believed.
inline constexpr int kAgree = 3;

/// What is thought of a map's registrations: held against what is usual there, one by one and ten
/// scans together. The evidence, the probability and the weak directions of their estimates are
/// its work.
class ScanJudge {
 public:
  explicit ScanJudge(const Config& config) : config_(config) {}

  /// A map begins, with a scan of that instant.
  void begin(std::int64_t instant_ns);

  /// Weighs what speaks against a registration.
  /// @param seen_again whether the last scan was the same, byte by byte
  void weigh(const KnotTrack& track, const PreparedScan& scan, const View& view, bool seen_again,
             RegisteredScan& registered) const;
  /// Likewise, and says how probably this scan went wrong; where what speaks against it leaves
  /// doubt, whether another place fits better is asked, too.
  [[nodiscard]] double hazard_of(const KnotTrack& track, const ScanPart& thinned, const View& view,
                                 bool seen_again, RegisteredScan& registered) const;
  /// Takes it to those of the last ones: the estimate's wrong_probability. Whether that is a reason
  /// to leave the map, of so many trusted scans.
  [[nodiscard]] bool is_lost(double hazard_now, int agreed, Estimate& estimate);
  /// Takes a scan's hazard to those of the last ones; how probably any of them went wrong.
  [[nodiscard]] double wrong_probability_with(double hazard_now) {
    return verdict_.add(hazard_now);
  }
  /// Who was lost found himself: what spoke against the scans before says no more.
  void forget_verdicts();
  /// Of a scan that is taken for right, as probably as `right`: learns what is usual, and tells in
  /// the estimate what it does not hold.
  void accept(RegisteredScan& registered, double right);

 private:
  [[nodiscard]] static double objection_of(const Estimate& estimate, double hazard_now, int agreed);
  void let_drift(RegisteredScan& registered);
  void name_weakness_of_late(RegisteredScan& registered);

  const Config& config_;
  UsualSigns usual_;
  Verdict verdict_;
  Verdict objections_;        // of the same scans, what speaks for leaving the map
  std::int64_t held_ns_ = 0;  // when a scan last held all directions
  std::vector<DegenerateDirection> weak_of_late_;  // of the last scan that had any
};

}  // namespace surefoot
