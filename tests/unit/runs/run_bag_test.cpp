// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_bag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace surefoot::runs {
namespace {

/// What listeners hear, by topic.
class Listeners final : public io::BagWriter {
 public:
  std::size_t add_topic(const std::string& name, const io::MessageDefinition&) override {
    names_.push_back(name);
    return names_.size() - 1;
  }
  void write(std::size_t topic, std::int64_t, std::string_view message) override {
    heard[names_.at(topic)].emplace_back(message);
  }
  void finish() override {}
  bool is_latched() const override { return true; }

  std::map<std::string, std::vector<std::string>> heard;

 private:
  std::vector<std::string> names_;
};

class RunBagTest : public testing::Test {
 protected:
  /// How often the frames' places in each other were told until after one more scan.
  std::size_t told() {
    Estimate estimate;
    estimate.status = Status::ok;
    bag_.add("scan", estimate, odometry_);
    return listeners_->heard["/tf_static"].size();
  }

  std::shared_ptr<Listeners> listeners_ = std::make_shared<Listeners>();
  RunBag bag_{listeners_, std::nullopt};
  Odometry odometry_;
};

TEST_F(RunBagTest, OdomIsTheMapWhereThereIsNoOther) {
  EXPECT_EQ(told(), 1U);
  EXPECT_EQ(told(), 1U);
}

TEST_F(RunBagTest, OdomInAMapIsToldWhenItIsKnownAndWhenItMoves) {
  bag_.place(std::nullopt);
  EXPECT_EQ(told(), 0U);
  Pose there;
  there.translation.x() = 3.0;
  bag_.place(there);
  EXPECT_EQ(told(), 1U);
  bag_.place(there);
  EXPECT_EQ(told(), 1U);
  there.translation.x() = 3.1;
  bag_.place(there);
  EXPECT_EQ(told(), 2U);
  bag_.place(std::nullopt);  // lost: the last one stands
  EXPECT_EQ(told(), 2U);
}

TEST_F(RunBagTest, TheMapIsToldOnceASecondAlsoWhereTheClockWasSetBack) {
  const auto told_at = [&](double seconds) {
    Estimate estimate;
    estimate.status = Status::ok;
    estimate.stamp_ns = std::llround(1e9 * seconds);
    bag_.add("scan", estimate, odometry_);
    return listeners_->heard["/surefoot/local_map"].size();
  };
  EXPECT_EQ(told_at(100.0), 1U);
  EXPECT_EQ(told_at(100.9), 1U);
  EXPECT_EQ(told_at(101.0), 2U);
  EXPECT_EQ(told_at(50.0), 3U);
  EXPECT_EQ(told_at(50.9), 3U);
  EXPECT_EQ(told_at(51.1), 4U);
}

/// Six hours of ten scans a second.
TEST_F(RunBagTest, ThePathIsBoundedInSizeAndInWhatIsSentOfIt) {
  constexpr std::size_t kScans = 216'000;
  constexpr std::size_t kPoseBytes = 100;  // at most, with its header
  std::size_t before = 0, late = 0, last = 0;
  for (std::size_t i = 1; i <= kScans; ++i) {
    (void)told();
    listeners_->heard["/surefoot/odometry"].clear();
    listeners_->heard["/tf"].clear();
    listeners_->heard["/surefoot/scan"].clear();
    listeners_->heard["/surefoot/local_map"].clear();
    listeners_->heard["/diagnostics"].clear();
    for (const std::string& path : listeners_->heard["/surefoot/path"]) {
      ASSERT_LE(path.size(), 4096 * kPoseBytes) << i;
      (i <= kScans / 2 ? before : late) += path.size();
      last = i;
    }
    listeners_->heard["/surefoot/path"].clear();
    ASSERT_LE(i - last, 4096U / 50U) << "not told of it for long";
  }
  EXPECT_GT(late, 0U);
  EXPECT_LT(before, kScans / 2 * 51 * kPoseBytes);
  EXPECT_LT(late, kScans / 2 * 51 * kPoseBytes);
}

}  // namespace
}  // namespace surefoot::runs
