// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_segments.hpp"

#include <algorithm>
#include <utility>

namespace surefoot {

namespace {

// Scans from one look for home to the next: while nothing else is known, and of who knows where he
// is in another map first and, one more each time, at most.
constexpr int kWhileLost = 2, kFirstPause = 5, kLongestPause = 50;

}  // namespace

KnotSegments::KnotSegments(const Session& session)
    : now_(std::make_unique<KnotFrontEnd>(session)) {}

Estimate KnotSegments::add(const PreparedScan& scan) {
  if (home_ && is_time_to_look()) {
    Estimate home = home_->add(scan);
    if (home.trusted()) {
      now_ = std::move(home_);
      lost_ = false;
      return home;
    }
  }
  Estimate estimate = now_->add(scan);
  if (now_->is_in_vain()) estimate = begin_anew(scan);
  lost_ = !estimate.trusted();
  segments_ = std::max(segments_, estimate.segment + 1);
  return estimate;
}

/// What was found is confirmed by the very next scans.
bool KnotSegments::is_time_to_look() {
  if (home_->is_confirming()) return true;
  if (++waited_ < (lost_ ? kWhileLost : pause_)) return false;
  waited_ = 0;
  if (!lost_) pause_ = std::min(pause_ + 1, kLongestPause);
  return true;
}

/// In a map of its own, from a scan that was lost in the last one.
Estimate KnotSegments::begin_anew(const PreparedScan& scan) {
  auto next = std::make_unique<KnotFrontEnd>(*now_, segments_);
  const bool kept = now_->is_worth_keeping(scan.end_ns);
  if (kept && (!home_ || now_->agreed() >= home_->agreed())) {
    home_ = std::move(now_);
    home_->leave();
  }
  now_ = std::move(next);
  waited_ = 0;
  pause_ = kFirstPause;
  return now_->add(scan);
}

}  // namespace surefoot
