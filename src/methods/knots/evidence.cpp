// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "methods/knots/verdict_weights.hpp"

namespace surefoot {

namespace {

constexpr int kEvery = 5;           // scans between two views that are kept
constexpr std::size_t kKept = 2;    // so that one is at least so old
constexpr std::size_t kStride = 3;  // of a view's points so many are asked for

// Scans that the values to begin with count as.
constexpr double kBegin = 3.0;

// What is smaller than these is nothing, so that the ratio of two such is no evidence.
constexpr Signs kNothing{
    .misfit = 0.01, .unseen = 0.02, .contradiction = 0.01, .motion = 0.1, .unconverged = 0.1};

constexpr std::array<double Signs::*, 5> kSigns = {
    &Signs::misfit, &Signs::unseen, &Signs::unconverged, &Signs::contradiction, &Signs::motion};

// A sign counts up to so many times the usual (logarithm: 55 times), and no more beyond.
constexpr double kStrongest = 4.0;

// The pose is held against those of so many scans before: Estimate::wrong_probability.
constexpr std::size_t kScans = 10;

/// Counts what beams answer about points.
struct Answers {
  int given = 0;
  int free = 0;

  void count(Beams::Answer answer) {
    given += answer == Beams::Answer::none ? 0 : 1;
    free += answer == Beams::Answer::free ? 1 : 0;
  }
  Answers& operator+=(const Answers& other) {
    given += other.given;
    free += other.free;
    return *this;
  }
};

/// What beams answer about some of a view's points.
Answers answers_about(const std::vector<Eigen::Vector3d>& points, const Beams& beams,
                      const Workers& workers) {
  const std::size_t asked = (points.size() + kStride - 1) / kStride;
  return workers.sum<Answers>(asked, [&](std::size_t begin, std::size_t end) {
    Answers part;
    for (std::size_t i = begin; i < end; ++i) part.count(beams.at(points[i * kStride]));
    return part;
  });
}

}  // namespace

void LastViews::add(View view) {
  if (!views_.empty() && ++since_ < kEvery) return;
  since_ = 0;
  views_.push_back(std::move(view));
  if (views_.size() > kKept) views_.pop_front();
}

double LastViews::contradiction(const View& view, const Workers& workers) const {
  Answers answers;
  for (const View& last : views_) {
    answers += answers_about(view.points, last.beams, workers);
    answers += answers_about(last.points, view.beams, workers);
  }
  return answers.given > 0 ? static_cast<double>(answers.free) / answers.given : 0.0;  // [K25]
}

double strength(double ratio) { return std::clamp(std::log(ratio), 0.0, kStrongest); }

Evidence UsualSigns::compare(const Signs& signs) const {
  const auto ratio = [&](double Signs::*sign) {
    const double now = std::max(signs.*sign, 0.0) + kNothing.*sign;
    return strength(now / (mean_.*sign + kNothing.*sign));  // [K26]
  };
  Evidence evidence;
  evidence.misfit = ratio(&Signs::misfit);
  evidence.unseen = ratio(&Signs::unseen);
  evidence.contradiction = ratio(&Signs::contradiction);
  evidence.motion = ratio(&Signs::motion);
  evidence.unconverged = ratio(&Signs::unconverged);
  return evidence;
}

void UsualSigns::learn(const Signs& signs, double right, double rate) {
  ++learnt_;
  const double weight = right * std::max(rate, 1.0 / (kBegin + learnt_));
  for (double Signs::*sign : kSigns) mean_.*sign += weight * (signs.*sign - mean_.*sign);
}

double hazard(const Evidence& evidence) {
  double sum = kVerdictOffset;
  for (const EvidenceField& field : kEvidenceFields) {
    sum += kVerdictWeights.*field.member * evidence.*field.member;
  }
  return 1.0 / (1.0 + std::exp(-sum));  // [K27]
}

double hazard_beside_rival(const Evidence& evidence) {
  constexpr double kOneOfTwo = 0.5;
  const bool clear = evidence.rival > strength(kClearlyBetter);
  return std::max(hazard(evidence), clear ? kOneOfTwo : 0.0);
}

bool sees_more_new(double at_one, double at_other) {
  constexpr double kNew = 0.02;  // share of the points, more than what is the same
  return at_one >= kClearlyBetter * at_other + kNew;
}

bool is_doubtful(double hazard) { return hazard > kVerdictBase / kScans; }

bool has_settled(bool converged, int settling, bool slides) {
  constexpr int kSoon = 12;
  return converged && (settling <= kSoon || slides);
}

Evidence after_gap(Evidence evidence) {
  evidence.unseen = std::max(evidence.unseen - evidence.gap, 0.0);
  return evidence;
}

Evidence evidence_where_lost(Evidence evidence, bool slides, bool large) {
  if (!large) evidence = after_gap(evidence);
  evidence.gap = 0.0;
  if (!slides && !large) evidence.uncertainty = 0.0;
  if (large) evidence.rival = std::max(evidence.rival, 0.0);
  return evidence;
}

double Verdict::add(double hazard) {
  right_.push_back(1.0 - hazard);
  if (right_.size() > kScans) right_.pop_front();
  double all = 1.0;
  for (const double right : right_) all *= right;
  return 1.0 - all;  // [K28]
}

}  // namespace surefoot
