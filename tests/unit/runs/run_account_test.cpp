// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_account.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace surefoot::runs {
namespace {

class RunAccountTest : public testing::Test {
 protected:
  RunAccountTest() {
    listener_.say = [this](const std::string& text) { said_.push_back(text); };
  }

  void add(Status status, int segment = 0) {
    io::ScanItem item;
    item.name = "scan " + std::to_string(outcome_.used);
    Estimate estimate;
    estimate.status = status;
    estimate.message = "why";
    estimate.segment = segment;
    account_.add(item, estimate, 1.0);
  }

  std::vector<std::string> said_;
  RunListener listener_;
  RunOutcome outcome_;
  RunAccount account_{listener_, outcome_};
};

TEST_F(RunAccountTest, WhatIsNoMeasurementIsCounted) {
  for (const Status status :
       {Status::first_scan, Status::ok, Status::degenerate, Status::lost, Status::lost,
        Status::rejected, Status::diverged, Status::too_few_matches}) {
    add(status);
  }
  EXPECT_EQ(account_.untrusted(), 5U);
  EXPECT_EQ(outcome_.used, 8U);
  EXPECT_EQ(outcome_.milliseconds.size(), 8U);
}

TEST_F(RunAccountTest, EachTroubleIsSaidOnceAndWhoComesHomeIsTold) {
  for (const Status status : {Status::ok, Status::lost, Status::lost, Status::ok, Status::lost}) {
    add(status);
  }
  add(Status::first_scan, 1);
  add(Status::ok, 1);
  add(Status::ok, 0);
  EXPECT_EQ(said_, (std::vector<std::string>{"scan 1: lost: why", "scan 4: lost: why",
                                             "scan 5: first_scan: why",
                                             "scan 7: came home: it goes on in segment 0"}));
}

TEST_F(RunAccountTest, OfScansThatCannotBeReadTenAreNotedAndAllAreSaid) {
  io::ScanItem item;
  item.error = "bad\x1b";
  for (int i = 0; i < 12; ++i) account_.leave_out(item);
  EXPECT_EQ(outcome_.unreadable, 12U);
  EXPECT_EQ(said_, std::vector<std::string>(12, "left out: bad?"));
  EXPECT_EQ(account_.notes(), std::vector<std::string>(10, "left out: bad?"));
}

}  // namespace
}  // namespace surefoot::runs
