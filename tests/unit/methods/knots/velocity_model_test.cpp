// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/velocity_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "methods/knots/sweep_bend.hpp"
#include "support/dense_algebra.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

constexpr double kStep = 0.0125;  // [s]
constexpr std::size_t kKnots = 10;
constexpr std::int64_t kSweepNs = 100'000'000;

/// Covariances of knots that are known exactly.
BandedSystem::Covariance no_covariance() {
  BandedSystem certain(kKnots);
  for (std::size_t k = 0; k < kKnots; ++k) certain.add(k, k, 1e30 * Matrix6::Identity());
  EXPECT_TRUE(certain.factorise());
  return certain.covariance();
}

/// A window that goes on from two poses with velocities [m/s, rad/s, map axes] one by one.
KnotWindow window_of(const Pose& first, const std::function<Twist()>& next_velocity,
                     double first_step = kStep) {
  KnotWindow window{{first}, first_step, kStep, 0, kSweepNs};
  while (window.knots.size() < kKnots) {
    const double step = window.knots.size() == 1 ? first_step : kStep;
    window.knots.push_back(displaced(window.knots.back(), step * next_velocity()));
  }
  return window;
}

/// A model that has seen a walk along the sensor's x axis.
VelocityModel walked_model(Random& random, const Config::Knots& config) {
  VelocityModel model(config);
  for (int i = 0; i < 10; ++i) {
    const auto velocity = [&] {
      return Twist((Twist() << 1.0, 0.1, 0.0, 0.0, 0.0, 0.2).finished() + random.twist(0.3, 0.5));
    };
    model.learn(window_of(Pose{}, velocity), no_covariance(), Eigen::Quaterniond::Identity());
  }
  return model;
}

TEST(VelocityModel, PullsTheVelocityToItsMean) {
  Random random(1);
  const VelocityModel model = walked_model(random, Config().knots);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Quaterniond rotation = random.pose(0.0, 3.0).rotation;
    const Twist v = random.twist(2.0, 2.0), m = model.mean(rotation);
    EXPECT_GT(m.norm(), 0.5);
    EXPECT_LT((model.next(v, rotation, 0.0) - v).norm(), 1e-15);
    EXPECT_LT((model.next(v, rotation, 1e9) - m).norm(), 1e-15);
    const double tau = Config().knots.correlation_time;
    EXPECT_LT((model.next(v, rotation, tau) - (m + (v - m) / std::exp(1.0))).norm(), 1e-14);
    // Two half steps are one.
    const Twist half = model.next(v, rotation, 0.5 * kStep);
    EXPECT_LT((model.next(half, rotation, 0.5 * kStep) - model.next(v, rotation, kStep)).norm(),
              1e-14);
  }
}

TEST(VelocityModel, BeforeItLearntItExpectsNoMotion) {
  const VelocityModel model(Config().knots);
  EXPECT_EQ(model.mean(so3_exp({0.3, 0.2, 0.1})), Twist::Zero());
}

TEST(VelocityModel, TheMeanIsTheSensors) {
  Random random(2);
  VelocityModel model(Config().knots);
  Twist in_map;
  in_map << 0.7, -0.2, 0.1, 0.0, 0.0, 0.0;
  const Pose start{so3_exp({0.1, -0.2, 1.3}), {4.0, 5.0, 6.0}};
  model.learn(window_of(start, [&] { return in_map; }), no_covariance(), start.rotation);
  EXPECT_LT((model.mean(start.rotation) - in_map).norm(), 1e-12);
  // Turned, the sensor is expected to walk the other way.
  const Eigen::Quaterniond turn = so3_exp({0.0, 0.0, 2.0});
  Twist turned;
  turned << turn * in_map.head<3>(), turn * in_map.tail<3>();
  EXPECT_LT((model.mean(turn * start.rotation) - turned).norm(), 1e-12);
}

// [K16]: by a tenth, unless it is far off.
TEST(VelocityModel, WhoDrivesOffLeavesNoMeanBehind) {
  const Pose start;
  Twist steady = Twist::Zero();
  steady[0] = 1.0;
  for (const double faster : {0.2, 0.6, 1.0, 3.0, 10.0}) {
    VelocityModel model(Config().knots);
    for (int i = 0; i < 30; ++i) {
      model.learn(window_of(start, [&] { return steady; }), no_covariance(), start.rotation);
    }
    Twist next = steady;
    next[0] += faster;
    VelocityModel unsure = model;
    unsure.learn(window_of(start, [&] { return next; }), no_covariance(), start.rotation, false);
    EXPECT_NEAR(unsure.mean(start.rotation)[0], 1.0 + 0.1 * faster, 1e-9) << faster;
    model.learn(window_of(start, [&] { return next; }), no_covariance(), start.rotation);
    const double s = model.fluctuation()[0];
    const double share = std::max(0.1, 1.0 - 16.0 * s * s / (0.5 * faster * faster));
    EXPECT_NEAR(model.mean(start.rotation)[0], 1.0 + share * faster, 1e-9) << faster;
    EXPECT_EQ(share > 0.1, faster >= 1.0) << share << " of " << faster;
    EXPECT_NEAR(model.mean(start.rotation)[2], 0.0, 1e-12);
  }
}

/// The model's terms, linearised numerically: rows W^1/2 e of all knots.
struct Linearised {
  Eigen::MatrixXd J;
  Eigen::VectorXd e;
};

Eigen::VectorXd weighted_deviations(const VelocityModel& model, const KnotWindow& window,
                                    const Eigen::Quaterniond& rotation) {
  const std::size_t terms = window.knots.size() - 2;
  Eigen::VectorXd all(6 * terms);
  for (std::size_t k = 0; k < terms; ++k) {
    const double phi = std::exp(-window.duration(k + 1) / Config().knots.correlation_time);
    const Twist m = model.mean(rotation);
    const Twist e = window.velocity(k + 1) - m - phi * (window.velocity(k) - m);
    all.segment<6>(6 * k) = e.cwiseQuotient(model.fluctuation()) / std::sqrt(1.0 - phi * phi);
  }
  return all;
}

Linearised linearise(const VelocityModel& model, const KnotWindow& window,
                     const Eigen::Quaterniond& rotation) {
  constexpr double kSmall = 1e-6;
  const std::size_t size = 6 * window.knots.size();
  Linearised result{Eigen::MatrixXd(6 * (window.knots.size() - 2), size),
                    weighted_deviations(model, window, rotation)};
  for (std::size_t c = 0; c < size; ++c) {
    const auto moved = [&](double by) {
      KnotWindow other = window;
      Twist twist = Twist::Zero();
      twist[c % 6] = by;
      other.knots[c / 6] = displaced(other.knots[c / 6], twist);
      return weighted_deviations(model, other, rotation);
    };
    result.J.col(c) = (moved(kSmall) - moved(-kSmall)) / (2.0 * kSmall);
  }
  return result;
}

/// Largest deviations of the step and the covariances that add_to leads to from those of the
/// numerical Gauss-Newton system, as shares. A weak prior makes both solvable.
struct Deviation {
  double step, covariance;
};

Deviation deviation(const VelocityModel& model, const KnotWindow& window,
                    const Eigen::Quaterniond& rotation) {
  const Linearised numerical = linearise(model, window, rotation);
  const auto size = numerical.J.cols();
  const Eigen::MatrixXd H =
      numerical.J.transpose() * numerical.J + 1e4 * Eigen::MatrixXd::Identity(size, size);
  const Eigen::VectorXd step = test::solve(H, -numerical.J.transpose() * numerical.e);
  const Eigen::MatrixXd inverse = test::inverse(H);
  BandedSystem system(window.knots.size());
  model.add_to(system, window, rotation);
  for (std::size_t k = 0; k < window.knots.size(); ++k) {
    system.add(k, k, 1e4 * Matrix6::Identity());
  }
  EXPECT_TRUE(system.factorise());
  const auto found = system.solve();
  const auto covariance = system.covariance();
  Deviation worst{0.0, 0.0};
  for (std::size_t i = 0; i < window.knots.size(); ++i) {
    worst.step = std::max(worst.step, (found[i] - step.segment<6>(6 * i)).norm() / step.norm());
    for (std::size_t j = i; j < std::min(i + 3, window.knots.size()); ++j) {
      const Matrix6 block = inverse.block<6, 6>(6 * i, 6 * j);
      const double miss = (covariance(i, j) - block).norm() / inverse.block<6, 6>(0, 0).norm();
      worst.covariance = std::max(worst.covariance, miss);
    }
  }
  return worst;
}

TEST(VelocityModel, TermsOfTranslationsAreExact) {
  Random random(3);
  const VelocityModel model = walked_model(random, Config().knots);
  for (int i = 0; i < 10; ++i) {
    const Pose start = random.pose(10.0, 2.0);
    const auto velocity = [&] { return random.twist(1.0, 0.0); };
    const KnotWindow window = window_of(start, velocity, i % 2 ? kStep : 0.02);
    const Deviation found = deviation(model, window, start.rotation);
    EXPECT_LT(found.step, 1e-6);
    EXPECT_LT(found.covariance, 1e-6);
  }
}

TEST(VelocityModel, TermsOfRotationsAreExactToTheFirstOrderOfASegmentsTurn) {
  // The log's Jacobian is taken to be the identity. It differs by half the turn from knot to knot:
  // 1.25 % at 2 rad/s, which is more than a trot's.
  Random random(4);
  const VelocityModel model = walked_model(random, Config().knots);
  double coarse = 0.0, fine = 0.0;
  for (int i = 0; i < 10; ++i) {
    const Pose start = random.pose(10.0, 2.0);
    for (const double rate : {2.0, 0.2}) {
      const Twist mean = random.twist(1.0, rate);
      const auto velocity = [&] { return Twist(mean + 0.2 * random.twist(1.0, rate)); };
      const Deviation found = deviation(model, window_of(start, velocity), start.rotation);
      double& worst = rate > 1.0 ? coarse : fine;
      worst = std::max({worst, found.step, found.covariance});
    }
  }
  std::printf("velocity terms: within %.4f at 2 rad/s, %.5f at 0.2 rad/s\n", coarse, fine);
  EXPECT_LT(coarse, 0.012);  // measured: 0.0069
  EXPECT_LT(fine, 0.0012);   // measured: 0.00073
}

TEST(VelocityModel, LearnsTheFluctuationOfAKnownProcess) {
  const Twist truth = (Twist() << 0.25, 0.25, 0.1, 0.8, 0.8, 0.3).finished();
  const Twist mean = (Twist() << 0.9, 0.1, 0.0, 0.0, 0.0, 0.0).finished();  // LiDAR frame
  Config::Knots config = Config().knots;
  config.learning_rate = 0.02;  // so that the sample is large: some 700 velocities
  VelocityModel model(config);
  Random random(5);
  const double phi = std::exp(-kStep / config.correlation_time);
  Pose pose;
  Twist fluctuation = Twist::Zero();
  for (int scan = 0; scan < 400; ++scan) {
    const Eigen::Quaterniond rotation = pose.rotation;
    Twist about;
    about << rotation * mean.head<3>(), rotation * mean.tail<3>();
    const KnotWindow window = window_of(pose, [&] {
      for (int i = 0; i < 6; ++i) {
        fluctuation[i] =
            phi * fluctuation[i] + random.normal(truth[i]) * std::sqrt(1.0 - phi * phi);
      }
      return Twist(about + fluctuation);
    });
    model.learn(window, no_covariance(), rotation);
    pose = window.knots[kKnots - 2];
  }
  const Twist learnt = model.fluctuation();
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(learnt[i], truth[i], 0.2 * truth[i]) << "axis " << i;
  const Twist seen = model.mean(Eigen::Quaterniond::Identity());
  EXPECT_LT((seen - mean).head<3>().norm(), 0.1);
}

TEST(VelocityModel, WhatIsTheSameInEveryScanIsNoFluctuation) {
  // Every sweep rolls over and back, whichever way the robot faces, as on a map that is bent along
  // the street; the body itself swings by 0.3 rad/s.
  Random random(7);
  VelocityModel bent(Config().knots), plain(Config().knots);
  SweepBend bend;
  for (int scan = 0; scan < 200; ++scan) {
    const Pose start = random.pose(0.0, 0.0);
    const Eigen::Quaterniond facing = so3_exp({0.0, 0.0, 0.02 * scan});
    std::vector<Twist> swings;
    for (std::size_t k = 0; k + 1 < kKnots; ++k) {
      swings.push_back((Twist() << 0, 0, 0, random.normal(0.3), random.normal(0.3), 0).finished());
    }
    for (const double roll : {0.0, 2.0}) {
      std::size_t k = 0;
      const auto velocity = [&] {
        Twist v = swings[k];
        v.tail<3>() += facing * Eigen::Vector3d(k < kKnots / 2 ? roll : -roll, 0.0, 0.0);
        ++k;
        return v;
      };
      KnotWindow window = window_of({facing, start.translation}, velocity);
      window.begin_ns = scan * kSweepNs;
      window.end_ns = window.begin_ns + kSweepNs;
      if (roll == 0.0) plain.learn(window, no_covariance(), facing);
      if (roll > 0.0) bent.learn(bend.straightened(window), no_covariance(), facing);
      if (roll > 0.0) bend.learn(window);
    }
  }
  EXPECT_NEAR(bent.fluctuation()[3], plain.fluctuation()[3], 0.2 * plain.fluctuation()[3]);
}

TEST(VelocityModel, TheMeanOfManyScansFades) {
  VelocityModel model(Config().knots);
  const auto learn = [&](const Twist& velocity) {
    model.learn(window_of(Pose{}, [&] { return velocity; }), no_covariance(),
                Eigen::Quaterniond::Identity());
  };
  for (int scan = 0; scan < 100; ++scan) learn(Twist::Zero());
  const Twist walk = (Twist() << 0.005, 0.0, 0.0, 0.0, 0.0, 0.0).finished();
  for (int scan = 0; scan < 5; ++scan) learn(walk);
  const Eigen::Quaterniond ahead = Eigen::Quaterniond::Identity();
  EXPECT_NEAR(model.mean(ahead).x(), 0.005 * (1.0 - std::pow(0.9, 5)), 1e-9);
}

TEST(VelocityModel, HorizontalAxesShareAndSoDoRollAndPitch) {
  VelocityModel model(Config().knots);
  Random random(6);
  for (int scan = 0; scan < 60; ++scan) {
    const auto velocity = [&] {  // shakes along x and in pitch only
      return Twist((Twist() << random.normal(0.5), 0, 0, 0, random.normal(1.0), 0).finished());
    };
    model.learn(window_of(Pose{}, velocity), no_covariance(), Eigen::Quaterniond::Identity());
  }
  const Twist s = model.fluctuation();
  EXPECT_EQ(s[0], s[1]);
  EXPECT_EQ(s[3], s[4]);
  EXPECT_GT(s[0], 10.0 * s[2]);
  EXPECT_GT(s[3], 10.0 * s[5]);
}

TEST(VelocityModel, AConstantVelocityLeavesTheFloor) {
  VelocityModel model(Config().knots);
  const Twist velocity = (Twist() << 1.0, 0.2, 0.0, 0.0, 0.0, 0.0).finished();
  for (int scan = 0; scan < 300; ++scan) {
    model.learn(window_of(Pose{}, [&] { return velocity; }), no_covariance(),
                Eigen::Quaterniond::Identity());
  }
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(model.fluctuation()[i], 0.003, 1e-9) << "axis " << i;
}

TEST(VelocityModel, WhatIsNotKnownOfTheKnotsCountsAsFluctuation) {
  // The knots stand, but each is known to 1 mm and 1 mrad only.
  BandedSystem loose(kKnots);
  for (std::size_t k = 0; k < kKnots; ++k) loose.add(k, k, 1e6 * Matrix6::Identity());
  ASSERT_TRUE(loose.factorise());
  VelocityModel model(Config().knots);
  for (int scan = 0; scan < 400; ++scan) {
    model.learn(window_of(Pose{}, [] { return Twist(Twist::Zero()); }), loose.covariance(),
                Eigen::Quaterniond::Identity());
  }
  // e = (k2 - k1) / h - phi (k1 - k0) / h of independent knots, over the process's 1 - phi^2.
  const double phi = std::exp(-kStep / Config().knots.correlation_time);
  const double variance = 1e-6 * (1.0 + (1.0 + phi) * (1.0 + phi) + phi * phi) / (kStep * kStep);
  const double expected = std::sqrt(variance / (1.0 - phi * phi));
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(model.fluctuation()[i], expected, 1e-6 * expected);
}

TEST(VelocityModel, ALooserOneFluctuatesMoreAboutTheSameMean) {
  VelocityModel model(Config().knots);
  model.begin((Twist() << 1.0, 0.2, 0.0, 0.0, 0.0, 0.3).finished(), Eigen::Quaterniond::Identity());
  const VelocityModel looser = model.looser(3.0);
  EXPECT_LT((looser.fluctuation() - 3.0 * model.fluctuation()).norm(), 1e-12);
  EXPECT_EQ(looser.mean(Eigen::Quaterniond::Identity()),
            model.mean(Eigen::Quaterniond::Identity()));
}

}  // namespace
}  // namespace surefoot
