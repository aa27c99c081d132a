// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/length_unit.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "io/recording.hpp"

namespace surefoot::runs {
namespace {

/// Walls at 2 .. 40 m, times `scale`.
Scan scan_in_unit(float scale) {
  Scan scan;
  for (int i = 2; i <= 40; ++i) scan.points.emplace_back(scale * float(i), 0.0F, 0.0F);
  return scan;
}

TEST(LengthUnit, MillimetresAreRefused) {
  EXPECT_NO_THROW(refuse_other_units(scan_in_unit(1.0F), "a.pcd"));
  try {
    refuse_other_units(scan_in_unit(1000.0F), "a.pcd");
    ADD_FAILURE() << "taken";
  } catch (const io::ReadError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with("a.pcd: ")) << text;
    EXPECT_NE(text.find("21000 m"), std::string::npos) << text;
    EXPECT_NE(text.find("millimetres"), std::string::npos) << text;
  }
}

TEST(LengthUnit, NoReturnsAndNothingSayNothing) {
  EXPECT_NO_THROW(refuse_other_units({}, "a.pcd"));
  Scan scan = scan_in_unit(1000.0F);
  scan.points.resize(scan.points.size() + 200, Eigen::Vector3f::Zero());
  EXPECT_THROW(refuse_other_units(scan, "a.pcd"), io::ReadError);
  scan.points.assign(5, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_NO_THROW(refuse_other_units(scan, "a.pcd"));
}

}  // namespace
}  // namespace surefoot::runs
