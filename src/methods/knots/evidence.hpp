// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What speaks against the pose that a registration found. Nothing here depends on how much of a
// scene is flat or how dense it is: a figure is held against its own usual, or counted only where
// an answer is possible at all. docs/method.md, "Is it right?".
#pragma once

#include <Eigen/Core>
#include <deque>

#include "methods/knots/view.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot {

/// The views of some of the last second's scans, which a new one is held against.
class LastViews {
 public:
  /// Of a trusted scan; some are kept.
  void add(View view);
  void clear() { views_.clear(); }
  /// Of what a view and these can tell of each other, the share where they contradict: points of
  /// the one that the other's beams went through. 0 if there is nothing to tell.
  [[nodiscard]] double contradiction(const View& view, const Workers& workers = Workers(1)) const;

 private:
  std::deque<View> views_;
  int since_ = 0;  // scans since one was kept
};

/// Figures of a registration that are held against what they usually are.
struct Signs {
  double misfit = 0.0;         ///< KnotRegistration::misfit_of_seen()
  double unseen = 0.0;         ///< KnotRegistration::unseen
  double contradiction = 0.0;  ///< LastViews::contradiction()
  double motion = 0.0;         ///< KnotPrior::surprise()
  double unconverged = 0.0;    ///< 1: the updates did not become small soon
};

/// The logarithm of a ratio, 0 if it is below 1 and 4 at most: no evidence is stronger.
[[nodiscard]] double strength(double ratio);

/// What right registrations of this run usually show: fading means.
class UsualSigns {
 public:
  /// The first five of the evidence.
  [[nodiscard]] Evidence compare(const Signs& signs) const;
  /// `right`: how probably this registration is right; a wrong one must not become usual.
  void learn(const Signs& signs, double right, double rate);

 private:
  // Of a walk over the simulated campus, until there is something of the run's own.
  Signs mean_{
      .misfit = 0.35, .unseen = 0.3, .contradiction = 0.02, .motion = 1.0, .unconverged = 0.05};
  int learnt_ = 0;
};

/// Of two places that a scan fits, the other must disagree so many times more, or it is not known
/// which one it is.
inline constexpr double kClearlyBetter = 1.15;

/// Whether much that a scan sees would be new at one place, and known at another: by the shares
/// that are new.
[[nodiscard]] bool sees_more_new(double at_one, double at_other);

/// How probably this scan, by itself, went wrong.
[[nodiscard]] double hazard(const Evidence& evidence);
/// Likewise, once another place was looked for: that one clearly fits better is half of a proof.
[[nodiscard]] double hazard_beside_rival(const Evidence& evidence);

/// Whether it went wrong more probably than any scan of the mix that the hazard is for: worth a
/// look at other places.
[[nodiscard]] bool is_doubtful(double hazard);

/// Whether a registration found its place soon: `settling` iterations after the kernel had
/// narrowed. Where it slides, along a direction that nothing holds, it may take its time: that
/// direction is named.
[[nodiscard]] bool has_settled(bool converged, int settling, bool slides);

/// What speaks against a registration some time after the last one. What is new to the map comes
/// with the way: n times as much after n periods.
[[nodiscard]] Evidence after_gap(Evidence evidence);

/// What speaks against a registration of one who is lost. That he was lost is known. How well the
/// scan holds the position tells nothing of which place it is; but where it may slide, or where the
/// region to look in is large, only what is held well is believed, and that the rival stays behind
/// does not count: there are places that look alike, and his own may not be in the map.
[[nodiscard]] Evidence evidence_where_lost(Evidence evidence, bool slides, bool large);

/// How probably something went wrong within the last ten scans, the motion over which a pose is
/// held to.
class Verdict {
 public:
  /// Another scan's hazard; returns the probability.
  double add(double hazard);
  void clear() { right_.clear(); }

 private:
  std::deque<double> right_;  // probabilities of the last scans
};

}  // namespace surefoot
