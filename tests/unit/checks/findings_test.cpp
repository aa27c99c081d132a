// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is told of a recording's scans, and what a run is said to suffer of.
#include "checks/findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "checks/mended_stamps.hpp"
#include "checks/motion_sentences.hpp"

namespace surefoot::checks {
namespace {

constexpr std::int64_t kPeriod = 100'000'000;

/// Sound scans, ten a second.
std::vector<ScanFacts> sound(std::size_t count) {
  std::vector<ScanFacts> scans(count);
  for (std::size_t i = 0; i < count; ++i) {
    ScanFacts& scan = scans[i];
    scan.name = "scan " + std::to_string(i);
    scan.stamp_ns = kPeriod * static_cast<std::int64_t>(i);
    scan.points = scan.returns = 10'000;
    scan.times = io::PointTimes::there;
    scan.last_s = 0.099;
    scan.nearest = 1.0;
    scan.middle = 5.0;
    scan.farthest = 50.0;
    scan.seen_around = 1.0;
    scan.rings = {0, 1, 2, 3};
  }
  return scans;
}

std::vector<Finding> all_of(const std::vector<ScanFacts>& scans,
                            const io::CaptureCounts& counts = {}) {
  return findings_of(scans, figures_of(scans), counts);
}

/// The one finding that begins so; fails where there is none.
Finding found(const std::vector<Finding>& findings, const std::string& begin) {
  const auto it = std::find_if(findings.begin(), findings.end(), [&](const Finding& finding) {
    return finding.what.starts_with(begin);
  });
  EXPECT_NE(it, findings.end()) << begin;
  return it == findings.end() ? Finding{} : *it;
}

TEST(Findings, NothingIsOddAboutASoundRecording) {
  const std::vector<ScanFacts> scans = sound(30);
  EXPECT_TRUE(all_of(scans).empty());
  const Figures figures = figures_of(scans);
  EXPECT_NEAR(figures.rate_hz(), 10.0, 1e-9);
  EXPECT_EQ(figures.rings.size(), 4U);
  EXPECT_EQ(figures.scans, 30U);
}

TEST(Findings, WhatReadingLostSpeaksAgainstTheRecording) {
  const std::vector<ScanFacts> scans = sound(30);
  const auto findings = findings_of(scans, figures_of(scans), {}, {"chunk 3 is damaged", "more"});
  const Finding lost = found(findings, "parts that are lost or damaged");
  EXPECT_TRUE(lost.suffers);
  EXPECT_EQ(lost.detail, "chunk 3 is damaged (and 1 more notes)");
}

TEST(Findings, AShortGapIsOddAndALongOneHurts) {
  std::vector<ScanFacts> scans = sound(50);
  for (std::size_t i = 20; i < scans.size(); ++i) scans[i].stamp_ns += 2 * kPeriod;
  Finding gap = found(all_of(scans), "gaps");
  EXPECT_FALSE(gap.suffers);
  EXPECT_EQ(gap.scans, 1U);
  EXPECT_EQ(gap.first, "scan 20");
  EXPECT_NE(gap.detail.find("0.300 s"), std::string::npos) << gap.detail;
  for (std::size_t i = 20; i < scans.size(); ++i) scans[i].stamp_ns += 10 * kPeriod;
  EXPECT_TRUE(found(all_of(scans), "gaps").suffers);
}

// As a run does, which puts the one where it belongs.
TEST(Findings, OneWildStampIsNoGap) {
  std::vector<ScanFacts> scans = sound(50);
  scans[20].stamp_ns += 3600 * 10 * kPeriod;
  mend_stamps(scans, {});
  ASSERT_TRUE(scans[20].mended_ns.has_value());
  EXPECT_NEAR(static_cast<double>(*scans[20].mended_ns), 20.0 * kPeriod, 0.2 * kPeriod);
  const auto findings = all_of(scans);
  EXPECT_EQ(found(findings, "stamps that are too late").scans, 1U);
  for (const Finding& finding : findings) EXPECT_FALSE(finding.suffers) << finding.what;
}

TEST(Findings, OneStampThatGoesBackIsAMishapManyHurt) {
  std::vector<ScanFacts> scans = sound(50);
  scans[10].stamp_ns = scans[8].stamp_ns;
  Finding back = found(all_of(scans), "stamps that go back");
  EXPECT_FALSE(back.suffers);
  EXPECT_EQ(back.first, "scan 10");
  for (ScanFacts& scan : scans) scan.stamp_ns = 7;
  const Finding still = found(all_of(scans), "stamps that are the last one's again");
  EXPECT_TRUE(still.suffers);
  EXPECT_EQ(still.scans, 49U);
}

// A block of scans once more, and the last one once more under a new stamp.
TEST(Findings, ScansThatAreSentAgainAreTold) {
  ScanLooker looker;
  const auto sent_again = [&](int stamp, float seen) {
    io::ScanItem item;
    item.scan.emplace();
    item.scan->stamp_ns = stamp * kPeriod;
    item.scan->points = {{seen, 1.0F, 0.0F}, {2.0F, seen, 1.0F}};
    return looker.look(item).sent_again;
  };
  for (const int scan : {0, 1, 2, 3}) EXPECT_FALSE(sent_again(scan, 1.0F + float(scan))) << scan;
  for (const int scan : {1, 2, 3}) EXPECT_TRUE(sent_again(scan, 1.0F + float(scan))) << scan;
  EXPECT_FALSE(sent_again(4, 5.0F));
  EXPECT_TRUE(sent_again(5, 5.0F));
  EXPECT_FALSE(sent_again(2, 9.0F)) << "another scan at a stamp that was there";
}

TEST(Findings, StampsThatStandHurtUnlessThePointsHaveAClock) {
  std::vector<ScanFacts> scans = sound(30);
  for (ScanFacts& scan : scans) scan.stamp_ns = kPeriod;
  mend_stamps(scans, {});
  EXPECT_TRUE(found(all_of(scans), "stamps that are the last one's again").suffers);

  scans = sound(30);
  for (ScanFacts& scan : scans) {
    scan.clock = io::PointClock{scan.stamp_ns, scan.stamp_ns};
    scan.stamp_ns = 7 * kPeriod;
  }
  mend_stamps(scans, {});
  const Finding again = found(all_of(scans), "stamps that are the last one's again");
  EXPECT_FALSE(again.suffers);
  EXPECT_NE(again.detail.find("the points' times"), std::string::npos) << again.detail;
  EXPECT_NEAR(figures_of(scans).rate_hz(), 10.0, 1e-9);
}

// Every third is lost: half of the intervals are as long as a sweep.
TEST(Findings, ScansThatAreMissingAllAlongAreGaps) {
  std::vector<ScanFacts> scans = sound(60);
  for (std::size_t i = scans.size(); i-- > 0;) {
    if (i % 3 == 1) scans.erase(scans.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const Finding gaps = found(all_of(scans), "gaps");
  EXPECT_TRUE(gaps.suffers);
  EXPECT_EQ(gaps.scans, 20U);
  EXPECT_NE(gaps.detail.find("about 20 scans missing"), std::string::npos) << gaps.detail;

  scans = sound(60);
  for (ScanFacts& scan : scans) scan.stamp_ns *= 2;  // thinned out
  const auto findings = all_of(scans);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].what, "sweeps with pauses between them");
  EXPECT_FALSE(findings[0].suffers);
  for (ScanFacts& scan : scans) scan.seen_around = 0.3;  // it may rest
  EXPECT_TRUE(all_of(scans).empty());
}

TEST(Findings, StampsThatAreMendedForwardAreNamed) {
  std::vector<ScanFacts> scans = sound(30);
  scans[0].stamp_ns -= 10'000 * kPeriod;
  scans[9].stamp_ns = scans[8].stamp_ns + 10'000;
  mend_stamps(scans, {});
  const std::vector<Finding> findings = all_of(scans);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].what, "stamps that are too early");
  EXPECT_EQ(findings[0].scans, 2U);
  EXPECT_FALSE(findings[0].suffers);
}

TEST(Findings, StampsThatComeAndGo) {
  std::vector<ScanFacts> scans = sound(60);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].stamp_ns += static_cast<std::int64_t>(i * 37 % 80) * 1'000'000;
  }
  // As they are stored no run can use them; as a run mends them it can.
  EXPECT_TRUE(found(all_of(scans), "sweeps that begin before the last one has ended").suffers);
  mend_stamps(scans, {});
  const std::vector<Finding> findings = all_of(scans);
  ASSERT_EQ(findings.size(), 1U) << findings[1].what << findings[1].detail;
  EXPECT_EQ(findings[0].what, "stamps that come and go");
  EXPECT_FALSE(findings[0].suffers);
}

TEST(Findings, UnreadableScansHurtAndAreNamed) {
  std::vector<ScanFacts> scans = sound(20);
  scans[3].error = "scan 3: cut short";
  const Finding finding = found(all_of(scans), "scans that cannot be read");
  EXPECT_TRUE(finding.suffers);
  EXPECT_EQ(finding.first, "scan 3: cut short");
  EXPECT_EQ(figures_of(scans).unreadable, 1U);
}

// A short capture that begins and ends within a sweep.
TEST(Findings, PartsOfSweepsAtTheEndsTellNothingOfTheRate) {
  std::vector<ScanFacts> scans = sound(3);
  scans[0].stamp_ns += kPeriod - kPeriod / 5;  // its last fifth
  scans[0].last_s /= 5.0;
  EXPECT_NEAR(figures_of(scans).rate_hz(), 10.0, 1e-9);
  EXPECT_TRUE(all_of(scans).empty());
  scans.pop_back();
  EXPECT_TRUE(all_of(scans).empty()) << "of two nothing is said of how long sweeps last";
}

TEST(Findings, StampsThatAllStandTellNothingOfHowLongSweepsMayLast) {
  std::vector<ScanFacts> scans = sound(5);
  for (ScanFacts& scan : scans) scan.stamp_ns = 0;
  for (const Finding& finding : all_of(scans)) {
    EXPECT_EQ(finding.what.find("sweeps that last longer"), std::string::npos) << finding.what;
  }
}

TEST(Findings, SweepsThatOverlapTellOfAWrongUnit) {
  std::vector<ScanFacts> scans = sound(20);
  for (ScanFacts& scan : scans) scan.last_s = 0.9;
  const Finding finding = found(all_of(scans), "sweeps that last longer");
  EXPECT_TRUE(finding.suffers);
  EXPECT_NE(finding.detail.find("--time-unit"), std::string::npos);
}

TEST(Findings, PointsWithoutTimesRingsOrReturns) {
  std::vector<ScanFacts> scans = sound(20);
  for (ScanFacts& scan : scans) scan.times = io::PointTimes::none;
  EXPECT_TRUE(found(all_of(scans), "no point times").suffers);
  scans = sound(20);
  scans[5].returns = 3;
  EXPECT_TRUE(found(all_of(scans), "scans with hardly a return").suffers);
  scans = sound(20);
  scans[5].returns = 3000;
  scans[6].rings = {2};
  EXPECT_FALSE(found(all_of(scans), "scans with less than half of the usual").suffers);
  EXPECT_EQ(found(all_of(scans), "scans with less than half of the rings").first, "scan 6");
  scans = sound(20);
  for (ScanFacts& scan : scans) scan.not_finite = 5'000;
  EXPECT_NE(found(all_of(scans), "points that are NaN").detail.find("50.0 %"), std::string::npos);
}

TEST(Findings, ALidarThatScansOnePlaneIsNone) {
  ScanLooker looker;
  io::ScanItem item;
  item.scan.emplace();
  for (int i = 0; i < 300; ++i) {
    item.scan->points.emplace_back(5.0F + 0.01F * static_cast<float>(i), 2.0F, 0.1F);
  }
  EXPECT_TRUE(looker.look(item).at_one_height);
  item.scan->points.back().z() = 0.2F;
  EXPECT_FALSE(looker.look(item).at_one_height);
  std::vector<ScanFacts> scans = sound(20);
  for (std::size_t i = 0; i < 9; ++i) scans[i].at_one_height = true;
  EXPECT_FALSE(found(all_of(scans), "points at one height").suffers);
  for (ScanFacts& scan : scans) scan.at_one_height = true;
  EXPECT_TRUE(found(all_of(scans), "points at one height").suffers);
}

// One scan's equal times do not mean that the recording is deskewed already.
TEST(Findings, OfAFewScansWithoutTimesNothingIsConcluded) {
  std::vector<ScanFacts> scans = sound(30);
  scans[0].times = io::PointTimes::equal;
  MotionCheck motion;
  motion.count = 30;
  motion.trials.trials.resize(2);
  motion.trials.trials[1].reading = TimeReading::none;
  motion.trials.decided = true;
  const auto concluded = [&] {
    std::vector<Finding> findings = all_of(scans);
    std::vector<std::string> sentences;
    conclude(motion, {}, figures_of(scans), findings, sentences);
    return found(findings, "point times that are all equal").detail;
  };
  EXPECT_EQ(concluded().find("deskewed already"), std::string::npos) << concluded();
  for (ScanFacts& scan : scans) scan.times = io::PointTimes::equal;
  EXPECT_NE(concluded().find("deskewed already"), std::string::npos) << concluded();
}

/// Noise moves the estimates of who stands: it is neither a way nor a turn.
TEST(StretchMotion, IsToldFromNoise) {
  EXPECT_FALSE(motion_along({{0, Pose()}}));
  Trajectory path;
  for (int i = 0; i < 100; ++i) {
    Pose pose;
    pose.translation.x() = i % 2 == 0 ? 0.02 : -0.02;
    pose.rotation = Eigen::AngleAxisd(i % 2 == 0 ? 0.01 : -0.01, Eigen::Vector3d::UnitZ());
    path.push_back({i, pose});
  }
  EXPECT_TRUE(motion_along(path)->stood_still());
  for (int i = 0; i < 100; ++i) {
    const auto at = static_cast<std::size_t>(i);
    path[at].pose.rotation = Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d::UnitZ());
  }
  EXPECT_FALSE(motion_along(path)->stood_still());
  EXPECT_TRUE(motion_along(path)->on_the_spot());
  EXPECT_NEAR(motion_along(path)->turned_deg, 9.9 * 180.0 / std::numbers::pi, 1e-6);
  for (int i = 0; i < 100; ++i) path[static_cast<std::size_t>(i)].pose.translation.x() = 0.03 * i;
  EXPECT_FALSE(motion_along(path)->on_the_spot());
  EXPECT_NEAR(motion_along(path)->way_m, 2.97, 0.1);
}

TEST(StretchMotion, IsSaidAsItWas) {
  MotionCheck motion;
  motion.count = 50;
  motion.trials.trials.resize(3);
  const auto said = [&](double reach, double way, double turned) {
    motion.moved = StretchMotion{reach, way, turned};
    std::vector<Finding> findings;
    std::vector<std::string> sentences;
    conclude(motion, {}, figures_of(sound(50)), findings, sentences);
    return sentences;
  };
  EXPECT_EQ(said(0.02, 0.0, 0.0),
            (std::vector<std::string>{
                "scans 0 to 49: the sensor stood still",
                "who stands still tells nothing of times: neither points' nor stamps'"}));
  EXPECT_EQ(said(0.1, 0.1, 359.6).front(),
            "scans 0 to 49, where it turns most: turned by 360 deg on the spot");
  EXPECT_EQ(said(4.0, 12.34, 90.0).front(),
            "scans 0 to 49, where it turns most: 12.3 m, turned by 90 deg");
}

TEST(Findings, LostPacketsAreAShareOfAll) {
  io::CaptureCounts counts;
  counts.data_packets = 1000;
  counts.lost = 10;
  EXPECT_FALSE(found(all_of(sound(20), counts), "lost packets").suffers);
  counts.lost = 500;
  EXPECT_TRUE(found(all_of(sound(20), counts), "lost packets").suffers);
}

TEST(Findings, WhatHurtsComesFirst) {
  std::vector<ScanFacts> scans = sound(20);
  scans[2].zero = 5;
  scans[3].error = "damaged";
  const std::vector<Finding> findings = all_of(scans);
  ASSERT_EQ(findings.size(), 3U);  // and the gap where it is missing
  EXPECT_TRUE(findings[0].suffers);
  EXPECT_FALSE(findings[1].suffers);
  EXPECT_FALSE(findings[2].suffers);
}

}  // namespace
}  // namespace surefoot::checks
