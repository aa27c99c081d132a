// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is said of a recording where there is little to say.
#include <gtest/gtest.h>

#include "checks/check_page.hpp"
#include "checks/check_text.hpp"
#include "checks/motion_sentences.hpp"

namespace surefoot::checks {
namespace {

TEST(CheckWords, ASingleScanHasNoRateAndNoInterval) {
  RecordingCheck check;
  check.description = "one file";
  check.figures.scans = 1;
  check.figures.points.median = 5.0;
  const std::string text = to_text(check), page = to_html(check, "name");
  EXPECT_EQ(text.find("Hz"), std::string::npos) << text;
  EXPECT_EQ(text.find("intervals"), std::string::npos) << text;
  EXPECT_NE(page.find("<p>one file: 1 scan, 5 points.</p>"), std::string::npos) << page;
  check.figures.scans = 2;
  check.figures.usual_interval_s = 0.1;
  check.figures.rings = {0, 1};
  EXPECT_NE(to_text(check).find("2 at 10.00 Hz"), std::string::npos);
  EXPECT_NE(to_html(check, "name").find("2 scans at 10.00 Hz, 5 points each, 2 rings."),
            std::string::npos);
}

// Noise: no scan was registered, and none has a blur.
TEST(CheckWords, WhereNoScanWasComparedThereIsNoBlur) {
  MotionCheck motion;
  motion.count = 20;
  motion.trials.trials.resize(2);
  motion.trials.trials[1].reading = TimeReading::backward;
  const auto last_sentence = [&] {
    std::vector<Finding> findings;
    std::vector<std::string> sentences;
    conclude(motion, {}, {}, findings, sentences);
    return sentences.back();
  };
  EXPECT_EQ(last_sentence(), "the motion tells nothing of times: no scan could be compared");
  motion.trials.trials[1].worse = 3;
  EXPECT_NE(last_sentence(), "the motion tells nothing of times: no scan could be compared");
}

}  // namespace
}  // namespace surefoot::checks
