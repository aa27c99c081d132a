// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/sweep_axis.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

namespace surefoot {
namespace {

constexpr int kPoints = 20000;

/// Sixteen beams, at azimuths that a function of the normalised time tells.
PreparedScan scan_of(const std::function<float(float tau)>& azimuth) {
  PreparedScan scan;
  for (int i = 0; i < kPoints; ++i) {
    const float tau = static_cast<float>(i) / kPoints;
    const float a = azimuth(tau), elevation = 0.035F * static_cast<float>(i % 16) - 0.26F;
    const float range = 3.0F + 2.0F * std::sin(5.0F * a);
    scan.points.push_back(range * Eigen::Vector3f(std::cos(elevation) * std::cos(a),
                                                  std::cos(elevation) * std::sin(a),
                                                  std::sin(elevation)));
    scan.taus.push_back(tau);
  }
  return scan;
}

PreparedScan spinning() {
  return scan_of([](float tau) { return -2.0F * std::numbers::pi_v<float> * tau; });
}

/// A scan that turns about `axis` in a map whose first one turned about `first`.
bool is_reversed(const Eigen::Vector3f& first, const Eigen::Vector3f& axis) {
  SweepDirection direction;
  direction.begin(first);
  return direction.is_reversed(axis);
}

TEST(SweepAxis, ASpinningSensorTurnsAboutItsAxis) {
  EXPECT_LT((sweep_axis(spinning()) + Eigen::Vector3f::UnitZ()).norm(), 0.02F);
}

TEST(SweepAxis, IsThatOfTheSensorHoweverItIsMounted) {
  const Eigen::Matrix3f mount =
      Eigen::AngleAxisf(2.0F, Eigen::Vector3f(1.0F, 2.0F, -0.5F).normalized()).matrix();
  PreparedScan scan = spinning();
  for (Eigen::Vector3f& point : scan.points) point = mount * point;
  EXPECT_LT((sweep_axis(scan) + mount.col(2)).norm(), 0.02F);
}

TEST(SweepAxis, OfHalfATurnIsTheSame) {
  PreparedScan scan;
  const PreparedScan whole = spinning();
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    if (whole.points[i].x() < 0.0F) continue;
    scan.points.push_back(whole.points[i]);
    scan.taus.push_back(whole.taus[i]);
  }
  EXPECT_LT(sweep_axis(scan).z(), -0.8F);
}

TEST(SweepAxis, MirroredOrBackwardsIsOpposite) {
  const Eigen::Vector3f axis = sweep_axis(spinning());
  PreparedScan mirrored = spinning(), backwards = spinning();
  for (Eigen::Vector3f& point : mirrored.points) point.y() = -point.y();
  for (float& tau : backwards.taus) tau = 1.0F - tau;
  EXPECT_TRUE(is_reversed(axis, sweep_axis(mirrored)));
  EXPECT_TRUE(is_reversed(axis, sweep_axis(backwards)));
  EXPECT_FALSE(is_reversed(axis, axis));
}

// Two that are 0.8 long and opposite are enough, and one that is short tells nothing.
TEST(SweepAxis, OnlyWhatTurnsSteadilyIsOpposite) {
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  EXPECT_TRUE(is_reversed(0.81F * up, -0.81F * up));
  EXPECT_FALSE(is_reversed(0.79F * up, -0.79F * up));
  EXPECT_FALSE(is_reversed(up, -0.5F * up));
}

// A scanner on a servo, each swing of which is a scan: nothing is wrong with every second one.
TEST(SweepDirection, OfASensorThatPansToAndFroNothingIsTold) {
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  SweepDirection direction;
  direction.begin(up);
  int reversed = 0;
  for (int i = 0; i < 20; ++i) reversed += direction.is_reversed(i % 2 == 0 ? up : -up) ? 1 : 0;
  EXPECT_EQ(reversed, 2) << "the first two tell what kind of sensor it is";
  direction.begin(-up);
  EXPECT_FALSE(direction.is_reversed(up)) << "the next map is the same sensor's";
}

TEST(SweepDirection, OneScanThatIsMirroredIsNoSwing) {
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  SweepDirection direction;
  direction.begin(up);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(direction.is_reversed(i % 4 == 3 ? -up : up), i % 4 == 3) << i;
  }
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(direction.is_reversed(-up)) << i;
}

TEST(SweepAxis, WithoutTimesOrToAndFroNothingIsTold) {
  PreparedScan untimed = spinning();
  untimed.taus.clear();
  const PreparedScan to_and_fro = scan_of([](float tau) { return 1.5F * std::sin(30.0F * tau); });
  const Eigen::Vector3f axis = sweep_axis(spinning());
  for (const PreparedScan& scan : {untimed, PreparedScan{}, to_and_fro}) {
    EXPECT_LT(sweep_axis(scan).norm(), 0.5F);
    EXPECT_FALSE(is_reversed(axis, sweep_axis(scan)));
    EXPECT_FALSE(is_reversed(sweep_axis(scan), axis));
  }
}

}  // namespace
}  // namespace surefoot
