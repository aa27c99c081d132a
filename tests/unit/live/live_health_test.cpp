// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/live_health.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace surefoot::live {
namespace {

using Level = io::Diagnostic::Level;

/// Ninety scans whose poses took from 1 to 90 ms.
LiveFigures ninety_scans() {
  LiveFigures figures;
  figures.received = figures.used = 90;
  for (int i = 1; i <= 90; ++i) figures.latencies_ms.push_back(i);
  return figures;
}

std::string value_of(const io::Diagnostic& diagnostic, const std::string& key) {
  const auto found = std::find_if(diagnostic.values.begin(), diagnostic.values.end(),
                                  [&](const auto& value) { return value.first == key; });
  return found == diagnostic.values.end() ? "absent" : found->second;
}

TEST(LiveHealth, TheLineTellsWhatWasUsedAndHowLongItTook) {
  LiveFigures figures = ninety_scans();
  figures.dropped = 3;
  EXPECT_EQ(state_text(figures).find("90 scans, 3 dropped; from last packet to pose 4"), 0U)
      << state_text(figures);
  EXPECT_NE(state_text(figures).find("90.0 ms at most"), std::string::npos) << state_text(figures);
  figures.paused = 2;
  EXPECT_NE(state_text(figures).find("3 dropped, 2 paused; "), std::string::npos);
  EXPECT_EQ(state_text({}), "0 scans, 0 dropped; no scan was used");
}

TEST(LiveHealth, WhatIsLostIsAWarningSilenceAnError) {
  LiveFigures figures = ninety_scans();
  EXPECT_EQ(health_of(figures, 7).level, Level::ok);
  EXPECT_EQ(health_of(figures, 7).stamp_ns, 7);
  EXPECT_EQ(health_of(figures, 7).message, state_text(figures));
  figures.dropped = 1;
  EXPECT_EQ(health_of(figures, 7).level, Level::warn);
  figures.dropped = 0;
  figures.is_paused = true;
  EXPECT_EQ(health_of(figures, 7).level, Level::warn);
  EXPECT_EQ(health_of(figures, 7).message, "paused; " + state_text(figures));
  figures.silent_s = 4.0;
  EXPECT_EQ(health_of(figures, 7).level, Level::error);
  EXPECT_EQ(health_of(figures, 7).message, "no scan for 4 s; " + state_text(figures));
}

TEST(LiveHealth, ItsValuesAreTheFigures) {
  LiveFigures figures = ninety_scans();
  figures.lost = 5;
  const io::Diagnostic diagnostic = health_of(figures, 0);
  EXPECT_EQ(value_of(diagnostic, "scans used"), "90");
  EXPECT_EQ(value_of(diagnostic, "lost before they were received"), "5");
  EXPECT_EQ(value_of(diagnostic, "latency max [ms]"), "90");
  EXPECT_EQ(value_of(health_of({}, 0), "latency max [ms]"), "absent");
}

}  // namespace
}  // namespace surefoot::live
