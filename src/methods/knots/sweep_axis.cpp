// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/sweep_axis.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "geometry/float_sums.hpp"

namespace surefoot {

namespace {

constexpr std::size_t kSpans = 32;     // of a scan's time: beams go on by less than a quarter turn
constexpr std::size_t kEnough = 4096;  // points will do
constexpr float kSteady = 0.8F;        // an axis that is shorter tells nothing

// One mirrored scan is two changes, two with one between them four.
constexpr int kPans = 5;

bool are_opposite(const Eigen::Vector3f& axis, const Eigen::Vector3f& other) {
  return dot(axis, other) < -kSteady * kSteady;
}

}  // namespace

Eigen::Vector3f sweep_axis(const PreparedScan& scan) {
  std::array<Eigen::Vector3f, kSpans> beams;  // added up
  beams.fill(Eigen::Vector3f::Zero());
  const std::size_t stride = std::max<std::size_t>(scan.taus.size() / kEnough, 1);
  for (std::size_t i = 0; i < scan.taus.size(); i += stride) {
    const auto span = static_cast<std::size_t>(scan.taus[i] * static_cast<float>(kSpans));
    beams[std::min(span, kSpans - 1)] += scan.points[i] / norm(scan.points[i]);
  }
  Eigen::Vector3f turn = Eigen::Vector3f::Zero();
  float all = 0.0F;
  for (std::size_t k = 1; k < kSpans; ++k) {
    const Eigen::Vector3f step = beams[k - 1].cross(beams[k]);
    turn += step;
    all += norm(step);
  }
  return all > 0.0F ? Eigen::Vector3f(turn / all) : turn;
}

bool SweepDirection::is_reversed(const Eigen::Vector3f& axis) {
  changes_ = are_opposite(last_, axis) ? changes_ + 1 : 0;
  to_and_fro_ = to_and_fro_ || changes_ >= kPans;
  last_ = axis;
  return !to_and_fro_ && are_opposite(first_, axis);
}

}  // namespace surefoot
