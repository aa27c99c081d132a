// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One scan of a swaying sensor against a map made with the true motion.
#include "methods/knots/knot_registration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/dense_algebra.hpp"
#include "support/random.hpp"
#include "support/synthetic_run.hpp"
#include "unit/methods/knots/swaying_scan.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

TEST(KnotRegistration, AtTheTruthItStays) {
  const KnotWindow truth = window_along(swaying);
  const KnotRegistration found = register_from(truth, prior_at(truth, 0.01));
  EXPECT_TRUE(found.solved);
  EXPECT_TRUE(found.converged);
  EXPECT_LT(found.misfit, 0.25);  // measured: 0.174
  EXPECT_GT(found.matches, 1500);
  const KnotError error = error_of(found.window);
  std::printf("from the truth: %.4f m, %.3f deg, misfit %.3f, %d iterations\n", error.translation,
              error.rotation_deg, found.misfit, found.iterations);
  EXPECT_LT(error.translation, 0.02);  // measured: 0.0135
  EXPECT_LT(error.rotation_deg, 0.7);  // measured: 0.46
}

TEST(KnotRegistration, FromFiveCentimetresAndDegreesOffItConverges) {
  Random random(1);
  const KnotWindow truth = window_along(swaying);
  for (int i = 0; i < 8; ++i) {
    Twist off;
    off << 0.05 * random.unit_vector(), 1.5 * kDegree * random.unit_vector();
    KnotWindow start = truth;
    for (Pose& knot : start.knots) knot = displaced(knot, off);
    const KnotRegistration found = register_from(start, prior_at(start, 0.05));
    EXPECT_TRUE(found.converged);
    const KnotError error = error_of(found.window);
    std::printf("from 5 cm, 1.5 deg off: %.4f m, %.3f deg\n", error.translation,
                error.rotation_deg);
    EXPECT_LT(error.translation, 0.023);  // measured: 0.011 .. 0.015
    EXPECT_LT(error.rotation_deg, 1.0);   // measured: 0.49 .. 0.73
  }
}

TEST(KnotRegistration, TheSwayWithinTheScanIsFound) {
  // Predicted as if the sensor went on without turning.
  const KnotWindow truth = window_along(swaying);
  KnotWindow steady = window_along([](double t) {
    return Pose{swaying(kScanStart).rotation,
                swaying(kScanStart).translation + Eigen::Vector3d(0.8 * (t - kScanStart), 0, 0)};
  });
  steady.knots[0] = truth.knots[0];
  const KnotError predicted = error_of(steady);
  const KnotRegistration found = register_from(steady, prior_at(truth, 0.01));
  const KnotError error = error_of(found.window);
  std::printf("sway: %.3f deg predicted, %.3f deg found; %.4f m\n", predicted.rotation_deg,
              error.rotation_deg, error.translation);
  EXPECT_GT(predicted.rotation_deg, 2.0);
  EXPECT_LT(error.rotation_deg, 0.15 * predicted.rotation_deg);  // measured: 0.46 of 4.49
  EXPECT_LT(error.translation, 0.02);                            // measured: 0.0135
}

/// What the registration minimises once its kernel is narrow, written down anew.
double cost(const KnotWindow& window, const KnotPrior& prior, const Config::Knots& config) {
  const VelocityModel model(config);
  double sum = 0.0;
  const KnotPoints& points = scan_points();
  for (std::size_t s = 0; s < window.segments(); ++s) {
    const Twist turn = se3_log(window.knots[s + 1].inverse() * window.knots[s + 2]);
    for (std::size_t i = points.begins[s]; i < points.begins[s + 1]; ++i) {
      const KnotPoints::Point& point = points.points[i];
      const Pose T = window.knots[s + 1] * se3_exp(point.share * turn);
      const Eigen::Vector3d place = T * point.position;
      const Surfel* const surfel = true_map().find(place, place - T.translation, 0);
      for (int d = 0; surfel != nullptr && d < surfel->directions; ++d) {
        const double r = surfel->across(d).dot(place - surfel->mean);
        const double variance = config.noise * config.noise + surfel->variance(d);
        const double share = surfel->directions == 3 ? config.cloud_weight : 1.0;
        // Geman-McClure
        sum += 0.5 * share * config.independence * r * r / (variance + r * r / 9.0);
      }
    }
  }
  for (std::size_t k = 0; k + 2 < window.knots.size(); ++k) {
    const double phi = std::exp(-kStep / config.correlation_time);
    const Twist e = window.velocity(k + 1) - phi * window.velocity(k);
    const Twist s = model.fluctuation();
    sum += 0.5 * e.cwiseQuotient(s).squaredNorm() / (1.0 - phi * phi);
  }
  Eigen::Matrix<double, 12, 1> e;
  e << difference(window.knots[0], prior.means[0]), difference(window.knots[1], prior.means[1]);
  return sum + 0.5 * e.dot(prior.information * e);
}

Twist gradient(KnotWindow window, std::size_t knot, const KnotPrior& prior,
               const Config::Knots& config) {
  constexpr double kSmall = 1e-6;
  Twist result;
  const Pose at = window.knots[knot];
  for (int axis = 0; axis < 6; ++axis) {
    double values[2];
    for (const int side : {0, 1}) {
      Twist by = Twist::Zero();
      by[axis] = side ? kSmall : -kSmall;
      window.knots[knot] = displaced(at, by);
      values[side] = cost(window, prior, config);
    }
    result[axis] = (values[1] - values[0]) / (2.0 * kSmall);
  }
  return result;
}

TEST(KnotRegistration, ItEndsWhereTheCostsGradientVanishes) {
  // For every knot, so the shares of a residual between a segment's two knots are right.
  Config::Knots config = Config().knots;
  config.convergence = 1e-7;
  config.max_iterations = 200;
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  const KnotRegistration found = register_from(truth, prior, config);
  ASSERT_TRUE(found.converged);
  for (std::size_t k = 0; k < truth.knots.size(); ++k) {
    const Twist rest = gradient(found.window, k, prior, config);
    for (const int axis : {0, 2, 3, 5}) {
      KnotWindow away = found.window;
      Twist by = Twist::Zero();
      by[axis] = 1e-3;
      away.knots[k] = displaced(away.knots[k], by);
      const double slope = gradient(away, k, prior, config)[axis];
      EXPECT_LT(std::abs(rest[axis]), 0.05 * std::abs(slope)) << "knot " << k << " axis " << axis;
    }
  }
}

TEST(KnotRegistration, TheMisfitIsWhatTheKernelTakesAway) {
  const Config::Knots config = Config().knots;
  const KnotWindow truth = window_along(swaying);
  const KnotRegistration found = register_from(truth, prior_at(truth, 0.01));
  ASSERT_TRUE(found.converged);
  double sum = 0.0;
  int unseen = 0;
  const KnotPoints& points = scan_points();
  const ScanTrajectory motion = found.window.trajectory();
  for (std::size_t s = 0; s < found.window.segments(); ++s) {
    for (std::size_t i = points.begins[s]; i < points.begins[s + 1]; ++i) {
      const KnotPoints::Point& point = points.points[i];
      const Pose T = motion.at((static_cast<double>(s) + point.share) / kSegments);
      const Eigen::Vector3d place = T * point.position;
      const Surfel* const surfel = true_map().find(place, place - T.translation, 0);
      if (surfel == nullptr) ++unseen;
      for (int d = 0; surfel != nullptr && d < surfel->directions; ++d) {
        const double r = surfel->across(d).dot(place - surfel->mean);
        const double variance = config.noise * config.noise + surfel->variance(d);
        sum += r * r / (9.0 * variance + r * r) / surfel->directions;
      }
    }
  }
  const auto all = static_cast<double>(points.points.size());
  EXPECT_NEAR(found.unseen, unseen / all, 1e-3);
  EXPECT_NEAR(found.misfit, (sum + unseen) / all, 2e-3);  // the last step moved it a little
}

TEST(KnotRegistration, TheKernelNarrowsToItsEndBeforeItConverges) {
  Config::Knots config = Config().knots;
  config.max_iterations = 100;
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  for (const double start : {0.1, 0.4, 1.6}) {
    config.kernel_start = start;
    const double steps = std::log(config.kernel_end / start) / std::log(config.kernel_decay);
    const KnotRegistration found = register_from(truth, prior, config);
    EXPECT_TRUE(found.converged);
    EXPECT_GE(found.iterations, 1 + static_cast<int>(std::ceil(steps / 2.0 - 1e-9))) << start;
    EXPECT_LE(found.iterations, 3 + static_cast<int>(std::ceil(steps / 2.0))) << start;
  }
}

/// From the truth nothing moves, and the kernel narrows at twice the pace.
TEST(KnotRegistration, TheKernelWaitsForWhatMoves) {
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  KnotWindow away = truth;
  for (std::size_t k = 2; k < away.knots.size(); ++k) away.knots[k].translation.x() += 0.3;
  const KnotRegistration still = register_from(truth, prior), moved = register_from(away, prior);
  EXPECT_LT((still.window.knots.back().translation - moved.window.knots.back().translation).norm(),
            0.005);
  EXPECT_GT(moved.iterations, still.iterations);
}

TEST(KnotRegistration, ThreadsDoNotChangeABit) {
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  const KnotRegistration one = register_from(truth, prior);
  for (const int threads : {2, 5}) {
    const KnotRegistration many = register_from(truth, prior, Config().knots, threads);
    EXPECT_EQ(one.iterations, many.iterations);
    EXPECT_EQ(one.misfit, many.misfit);
    EXPECT_EQ(one.rigid.H, many.rigid.H);
    for (std::size_t k = 0; k < truth.knots.size(); ++k) {
      EXPECT_EQ(one.window.knots[k].matrix(), many.window.knots[k].matrix());
      EXPECT_EQ(one.covariance(k, k), many.covariance(k, k));
    }
  }
}

TEST(KnotRegistration, IsHopelessWhereItDisagreesMuchAndGetsNoBetter) {
  EXPECT_TRUE(is_hopeless(0.4, 0.4, 0.2));
  EXPECT_FALSE(is_hopeless(0.28, 0.28, 0.2));  // hardly more than the least
  EXPECT_FALSE(is_hopeless(0.4, 0.5, 0.2));    // on its way
}

TEST(KnotRegistration, WithoutAMapThePredictionStays) {
  const SurfelMap empty(Config().knots, 100.0);
  const Config::Knots config = Config().knots;
  KnotWindow start = window_along([](double t) {
    return Pose{Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.45 + 0.0 * t}};
  });
  KnotPoints points = scan_points();
  const KnotPrior prior = prior_at(start, 0.01);
  const VelocityModel model(config);
  const Workers workers(1);
  const KnotRegistration found = register_knots(
      points, {empty, prior, model, config, workers, kNobody}, start, usual_annealing(config));
  EXPECT_TRUE(found.solved);
  EXPECT_EQ(found.matches, 0);
  EXPECT_EQ(found.misfit, 1.0);
  for (std::size_t k = 0; k < start.knots.size(); ++k) {
    EXPECT_LT(difference(found.window.knots[k], start.knots[k]).norm(), 1e-9);
  }
}

TEST(KnotRegistration, WhatIsNotFiniteIsNotSolved) {
  const KnotWindow truth = window_along(swaying);
  KnotPrior unknown_place = prior_at(truth, 0.01), unknown_weight = unknown_place;
  unknown_place.means[1].translation.x() = std::numeric_limits<double>::quiet_NaN();
  unknown_weight.information(7, 7) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(register_from(truth, unknown_place).solved);
  EXPECT_FALSE(register_from(truth, unknown_weight).solved);
}

}  // namespace
}  // namespace surefoot
