// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans that are sent again.
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <utility>

#include "unit/io/stamped_recording.hpp"

namespace surefoot::io {
namespace {

using namespace test;  // NOLINT: the recordings of the test support

TEST(StampRepair, WhatWasSentTwiceIsLeftOut) {
  class Twice : public Stamped {
   public:
    Twice() : Stamped(regular(10)) {}
    std::optional<ScanItem> next() override {
      if (again_) return std::exchange(again_, std::nullopt);
      std::optional<ScanItem> item = Stamped::next();
      if (item && item->name == "scan 4") again_ = item;
      return item;
    }
    std::optional<ScanItem> again_;
  };
  const auto recording = repair_stamps(std::make_unique<Twice>(), {});
  std::vector<std::int64_t> stamps;
  while (const auto item = recording->next()) stamps.push_back(item->scan->stamp_ns);
  EXPECT_EQ(stamps, regular(10));
  EXPECT_EQ(recording->notes().size(), 1U);
}

/// Scans of a regular recording by their numbers, some of them once more.
class SentAgain : public Stamped {
 public:
  explicit SentAgain(std::vector<std::size_t> numbers)
      : Stamped(stamps_of(numbers)), numbers_(std::move(numbers)) {}
  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = Stamped::next();
    if (item) item->scan->points.front().z() = static_cast<float>(numbers_[next_++]);
    return item;
  }

 private:
  static std::vector<std::int64_t> stamps_of(const std::vector<std::size_t>& numbers) {
    std::vector<std::int64_t> stamps;
    for (const std::size_t number : numbers) stamps.push_back(regular(number + 1).back());
    return stamps;
  }
  std::vector<std::size_t> numbers_;
  std::size_t next_ = 0;
};

// A player that goes back by twelve scans, and a driver that repeats every one.
TEST(StampRepair, ScansThatAreSentAgainAreLeftOut) {
  std::vector<std::size_t> block, stuttering;
  for (std::size_t i = 0; i < 20; ++i) block.push_back(i);
  for (std::size_t i = 8; i < 30; ++i) block.push_back(i);
  for (std::size_t i = 0; i < 30; ++i) stuttering.insert(stuttering.end(), {i, i > 0 ? i - 1 : i});
  for (const bool at_once : {false, true}) {
    OpenOptions options;
    options.repair_at_once = at_once;
    for (const auto& numbers : {block, stuttering}) {
      const Repaired result = repaired(std::make_unique<SentAgain>(numbers), options);
      EXPECT_EQ(result.stamps, regular(30)) << at_once;
      ASSERT_EQ(result.notes.size(), 1U);
      EXPECT_NE(result.notes[0].find("sent again, first scan "), std::string::npos)
          << result.notes[0];
    }
  }
}

// The same stamps, and what is seen differs: a clock that was set back, as ever.
TEST(StampRepair, OtherScansAtStampsThatWereThereAreNone) {
  std::vector<std::int64_t> stamps = regular(20);
  for (std::size_t i = 12; i < 20; ++i) stamps[i] -= kSecond;
  EXPECT_EQ(repaired(stamps).stamps, regular(20));
}

// A driver that hangs sends the last scan on and on, under new stamps.
TEST(StampRepair, TheSamePointsUnderNewStampsAreLeftOutWhereScansDiffer) {
  class Hanging : public Stamped {
   public:
    explicit Hanging(float from, float to) : Stamped(regular(10)), from_(from), to_(to) {}
    std::optional<ScanItem> next() override {
      std::optional<ScanItem> item = Stamped::next();
      if (!item) return item;
      float& number = item->scan->points.front().z();
      if (number > from_ && number <= to_) number = from_;
      return item;
    }
    float from_, to_;
  };
  const auto stamps = [](float from, float to) {
    const auto recording = repair_stamps(std::make_unique<Hanging>(from, to), {});
    std::vector<std::int64_t> given;
    while (const auto item = recording->next()) given.push_back(item->scan->stamp_ns);
    return given;
  };
  std::vector<std::int64_t> without = regular(10);
  without.erase(without.begin() + 4, without.begin() + 7);
  EXPECT_EQ(stamps(3.0F, 6.0F), without);
  EXPECT_EQ(stamps(0.0F, 9.0F), regular(10));  // all alike: a recording that was made so
}

// A covered sensor's scans are all alike: it was not sent twice.
TEST(StampRepair, ScansWithoutAnyReturnAreKept) {
  class Covered : public Stamped {
   public:
    Covered() : Stamped(regular(10)) {}
    std::optional<ScanItem> next() override {
      std::optional<ScanItem> item = Stamped::next();
      if (!item) return item;
      Eigen::Vector3f& point = item->scan->points.front();
      if (point.z() >= 4.0F && point.z() < 7.0F) point.setZero();
      if (point.z() >= 7.0F) point.setConstant(std::numeric_limits<float>::quiet_NaN());
      return item;
    }
  };
  const Repaired result = repaired(std::make_unique<Covered>(), {});
  EXPECT_EQ(result.stamps, regular(10));
  EXPECT_TRUE(result.notes.empty());
}

}  // namespace
}  // namespace surefoot::io
