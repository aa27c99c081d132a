// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/point_time.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

constexpr std::int64_t kEpochNs = 1630577758569489956;

struct Case {
  const char* driver;
  double least, greatest;
  ScalarType type;
  std::optional<std::int64_t> stamp_ns;
  TimeUnit unit;
  TimeReference reference;
};

class PointTime : public testing::TestWithParam<Case> {};

TEST_P(PointTime, IsFoundOutFromTheValues) {
  const Case& c = GetParam();
  const PointTimeRule rule = decide_point_time({c.least, c.greatest, 10}, c.type, c.stamp_ns, {});
  EXPECT_EQ(rule.unit, c.unit);
  EXPECT_EQ(rule.reference, c.reference);
  EXPECT_TRUE(rule.certain);
  EXPECT_TRUE(rule.unit_certain);
}

using enum ScalarType;
using enum TimeUnit;
constexpr TimeReference kRelative = TimeReference::relative;
constexpr TimeReference kAbsolute = TimeReference::absolute;
INSTANTIATE_TEST_SUITE_P(
    Drivers, PointTime,
    testing::Values(
        Case{"Velodyne", -0.0996, 0.0, f32, kEpochNs, seconds, kRelative},
        Case{"Velodyne, first packet", 0.0, 0.0996, f32, kEpochNs, seconds, kRelative},
        Case{"Velodyne, last returns missing", -0.1, -0.03, f32, kEpochNs, seconds, kRelative},
        Case{"Ouster", 0, 99'900'000, u32, kEpochNs, nanoseconds, kRelative},
        Case{"Ouster, 20 Hz", 0, 49'900'000, u32, std::nullopt, nanoseconds, kRelative},
        Case{"Hesai", 1.6305777585e9, 1.6305777586e9, f64, kEpochNs, seconds, kAbsolute},
        Case{"Hesai, stamp at the end", 1.6305777584e9, 1.6305777585e9, f64, kEpochNs, seconds,
             kAbsolute},
        Case{"RoboSense, no stamp", 1.6305777585e9, 1.6305777586e9, f64, std::nullopt, seconds,
             kAbsolute},
        Case{"Livox PointCloud2", 1.6305777585e18, 1.6305777586e18, f64, kEpochNs, nanoseconds,
             kAbsolute},
        Case{"Livox CustomMsg", 0, 99'950'000, u32, kEpochNs, nanoseconds, kRelative},
        Case{"since power-on", 35.2, 35.3, f64, 35'200'000'000, seconds, kAbsolute},
        Case{"since power-on, no stamp", 35.2, 35.3, f64, std::nullopt, seconds, kAbsolute},
        Case{"nanoseconds since power-on", 1.5e12, 1.5001e12, f64, 1'500'000'000'000, nanoseconds,
             kAbsolute},
        Case{"microseconds since power-on", 1'049'000'052, 1'049'100'004, u64, 1'049'000'050'000,
             microseconds, kAbsolute},
        Case{"milliseconds", 0, 99.9, f32, kEpochNs, milliseconds, kRelative},
        Case{"microseconds", 0, 99'900, u32, kEpochNs, microseconds, kRelative},
        Case{"microseconds, 100 Hz", 0, 9'950, u32, kEpochNs, microseconds, kRelative},
        Case{"epoch microseconds", 1.6305777585e15, 1.6305777586e15, u64, kEpochNs, microseconds,
             kAbsolute},
        Case{"epoch milliseconds", 1.630577758569e12, 1.630577758669e12, f64, kEpochNs,
             milliseconds, kAbsolute},
        Case{"short scan", 2303, 1'306'368, u32, kEpochNs, nanoseconds, kRelative},
        Case{"half a short scan", 0.0, 0.004, f32, kEpochNs, seconds, kRelative},
        Case{"mid-scan stamp", -0.05, 0.05, f32, kEpochNs, seconds, kRelative}),
    [](const auto& of) {
      std::string name;
      for (const char c : std::string(of.param.driver)) {
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      }
      return name;
    });

TEST(PointTimeRules, EqualTimesAreLegalButProveNothing) {
  const PointTimeRule zero = decide_point_time({0, 0, 5}, f32, kEpochNs, {});
  EXPECT_EQ(zero.reference, kRelative);
  EXPECT_FALSE(zero.certain);
  const PointTimeRule epoch = decide_point_time({1.6305777585e9, 1.6305777585e9, 5}, f64, {}, {});
  EXPECT_EQ(epoch.unit, seconds);
  EXPECT_EQ(epoch.reference, kAbsolute);
}

// A recording whose stamps begin at zero: the first scan fits both, a later one decides.
TEST(PointTimeRules, StampNearZeroIsUncertain) {
  EXPECT_FALSE(decide_point_time({0.0, 0.1, 5}, f32, 0, {}).certain);
  EXPECT_FALSE(decide_point_time({0.0, 0.1, 5}, f32, 1'000'000'000, {}).certain);
  const PointTimeRule later = decide_point_time({9.0, 9.1, 5}, f32, 9'000'000'000, {});
  EXPECT_EQ(later.reference, kAbsolute);
  EXPECT_TRUE(later.certain);
}

// A sensor's first packets may be half a second in microseconds, or half a millisecond.
TEST(PointTimeRules, AScanThatMayBeOnePacketIsUncertainOfItsUnit) {
  const PointTimeRule packet = decide_point_time({0, 475'000, 5}, u32, kEpochNs, {});
  EXPECT_EQ(packet.unit, microseconds);
  EXPECT_FALSE(packet.unit_certain);
  const PointTimeRule scan = decide_point_time({0, 99'950'000, 5}, u32, kEpochNs, {});
  EXPECT_TRUE(scan.unit_certain);
  EXPECT_TRUE(knows_better(scan, packet));
  EXPECT_FALSE(knows_better(packet, scan));
  EXPECT_FALSE(decide_point_time({0, 480.0, 5}, f32, kEpochNs, {}).unit_certain);
  EXPECT_FALSE(decide_point_time({0, 0.48, 5}, f32, kEpochNs, {}).unit_certain);
  OpenOptions options;
  options.time_unit = microseconds;
  EXPECT_TRUE(decide_point_time({0, 475'000, 5}, u32, kEpochNs, options).unit_certain);
  const PointTimeRule vague = decide_point_time({0.0, 0.1, 5}, f32, 0, {});
  EXPECT_FALSE(knows_better(vague, decide_point_time({9.0, 9.05, 5}, f32, 9'000'000'000, {})))
      << "the longer one, but relative or absolute nobody knows";
}

TEST(PointTimeRules, TwoScansOfOneLengthConfirmEachOther) {
  const auto rule = [](double least, double greatest, std::int64_t stamp_ns) {
    return decide_point_time({least, greatest, 5}, f64, stamp_ns, {});
  };
  const PointTimeRule slow = rule(0.0, 0.2, kEpochNs);
  EXPECT_TRUE(confirms(slow, slow));
  EXPECT_TRUE(confirms(slow, rule(0.0, 0.19, kEpochNs)));
  EXPECT_FALSE(confirms(slow, rule(0.0, 0.1, kEpochNs))) << "a part of a scan";
  EXPECT_FALSE(confirms(slow, rule(0.0, 200.0, kEpochNs))) << "another unit";
  EXPECT_TRUE(confirms(rule(50.2, 50.3, kEpochNs), rule(50.1, 50.2, kEpochNs)));
  EXPECT_TRUE(confirms(rule(0.0, 0.0, kEpochNs), rule(0.0, 0.0, kEpochNs)));
  const PointTimeRule vague = rule(0.0, 0.1, 0);
  EXPECT_FALSE(confirms(rule(0.1, 0.2, 100'000'000), vague)) << "relative or absolute, both fit";
}

TEST(PointTimeRules, AbsoluteTimesInAFloat32AreCoarse) {
  const auto uptime = [](double since, ScalarType type) {
    const TimeExtents extents{since, since + 0.125, 100};
    const PointTimeRule rule = decide_point_time(extents, type, kEpochNs, {});
    return std::pair(rule.is_too_coarse(), describe_point_time("time", type, rule, extents));
  };
  const auto [day_is_too_coarse, day] = uptime(1e5, f32);
  EXPECT_FALSE(day_is_too_coarse);
  EXPECT_NE(day.find("in steps of 7.81 ms"), std::string::npos) << day;
  const auto [weeks_are_too_coarse, weeks] = uptime(1e6, f32);
  EXPECT_TRUE(weeks_are_too_coarse);
  EXPECT_NE(weeks.find("in steps of 62.5 ms, too coarse"), std::string::npos) << weeks;
  EXPECT_FALSE(uptime(1e6, f64).first);
  EXPECT_EQ(uptime(1e6, f64).second.find("steps"), std::string::npos);
  EXPECT_EQ(uptime(100.0, f32).second.find("steps"), std::string::npos);
  const TimeExtents zeros{0.0, 0.0, 100};
  const PointTimeRule none = decide_point_time(zeros, f32, kEpochNs, {});
  EXPECT_EQ(describe_point_time("time", f32, none, zeros).find("steps"), std::string::npos);
}

TEST(PointTimeRules, UnitsThatAreDefined) {
  const auto unit_of = [](const char* time, ScalarType type, const char* other, const char* more) {
    PointTable table;
    for (const char* name : {time, other, more}) table.columns.push_back({name, type, nullptr, 4});
    return with_defined_unit({}, table, table.columns.front()).time_unit;
  };
  EXPECT_EQ(unit_of("offset_time", u32, "tag", "line"), nanoseconds);
  EXPECT_EQ(unit_of("t", u32, "reflectivity", "range"), nanoseconds);
  EXPECT_EQ(unit_of("time_us", u32, "intensity", "ring"), microseconds);
  EXPECT_EQ(unit_of("timestamp_ns", u32, "intensity", "ring"), nanoseconds);
  EXPECT_EQ(unit_of("t", u32, "intensity", "ring"), automatic);
  EXPECT_EQ(unit_of("t", f32, "reflectivity", "range"), automatic);
  OpenOptions options;
  options.time_unit = microseconds;
  PointTable table;
  for (const char* name : {"offset_time", "tag", "line"}) {
    table.columns.push_back({name, u32, nullptr, 4});
  }
  EXPECT_EQ(with_defined_unit(options, table, table.columns.front()).time_unit, microseconds);
}

TEST(PointTimeRules, NoRuleIsAnErrorThatNamesTheValues) {
  struct Odd {
    double least, greatest;
    ScalarType type;
    std::optional<std::int64_t> stamp;
  };
  for (const Odd& odd : {Odd{0, 7, u32, kEpochNs}, Odd{0, 5000, f32, kEpochNs},
                         Odd{0, 1e12, f64, kEpochNs}, Odd{50.0, 50.001, f64, kEpochNs},
                         Odd{-50.0, -49.9, f64, {}}, Odd{12345, 12345, u32, kEpochNs}}) {
    const std::string message = test::message_of<ReadError>([&] {
      (void)decide_point_time({odd.least, odd.greatest, 5}, odd.type, odd.stamp, {});
    });
    EXPECT_NE(message.find(name_of(odd.type)), std::string::npos) << odd.greatest << message;
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
  }
}

// A LiDAR without a time server under a host's header; or one header that is wrong: another scan
// may know better.
TEST(PointTimeRules, AClockOfItsOwnIsUncertain) {
  const PointTimeRule rule = decide_point_time({50.0, 50.1, 5}, f64, kEpochNs, {});
  EXPECT_EQ(rule.unit, seconds);
  EXPECT_EQ(rule.reference, TimeReference::own_clock);
  EXPECT_FALSE(rule.certain);
}

TEST(PointTimeRules, OptionsOverride) {
  OpenOptions options;
  options.time_unit = microseconds;
  options.time_reference = kAbsolute;
  const PointTimeRule rule = decide_point_time({0, 7, 5}, u32, kEpochNs, options);
  EXPECT_EQ(rule.unit, microseconds);
  EXPECT_EQ(rule.reference, kAbsolute);
}

TEST(ToNanoseconds, Exact) {
  EXPECT_EQ(to_nanoseconds(std::uint32_t{4'000'000'000U}, 1), 4'000'000'000);
  EXPECT_EQ(to_nanoseconds(0.1F, 1'000'000'000), 100'000'001);  // the float is 0.100000001490...
  EXPECT_EQ(to_nanoseconds(-0.25, 1'000'000'000), -250'000'000);
  // 2^-22 s is the step of a double at 1.6e9 s.
  EXPECT_EQ(to_nanoseconds(1630577758.0 + 0x1p-22, 1'000'000'000), 1630577758000000238);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300, 1e10,
                           std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(to_nanoseconds(bad, 1'000'000'000), std::nullopt) << bad;
  }
  EXPECT_EQ(to_nanoseconds(std::numeric_limits<std::uint64_t>::max(), 1), std::nullopt);
  EXPECT_EQ(to_nanoseconds(std::numeric_limits<std::int64_t>::max(), 1000), std::nullopt);
}

}  // namespace
}  // namespace surefoot::io
