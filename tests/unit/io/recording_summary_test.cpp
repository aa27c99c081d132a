// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "io/recording_summary.hpp"
#include "unit/io/scan_folders.hpp"

namespace surefoot::io {
namespace {

using test::TemporaryFolder;
using test::timed_pcd;

TEST(Summary, SaysWhatIsOdd) {
  const TemporaryFolder folder;
  folder.write("0.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("1.pcd", timed_pcd<float>({0.0F, NAN, 0.0625F}));
  folder.write("2.pcd", "garbage");
  folder.write("3.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("4.pcd", timed_pcd<float>({0.0F, 0.001F}));
  folder.write("times.txt", "10\n10\n10.2\n9\n9.1\n");
  OpenOptions as_it_is;
  as_it_is.repair_stamps = false;
  const RecordingSummary summary = summarise(*open_recording(folder.path(), as_it_is));
  EXPECT_EQ(summary.scans, 4U);
  EXPECT_EQ(summary.unreadable, 1U);
  EXPECT_EQ(summary.points.greatest, 2.0);
  EXPECT_EQ(summary.range_m.least, 1.0);
  EXPECT_EQ(summary.range_m.greatest, 3.0);
  std::string oddities;
  for (const Oddity& oddity : summary.oddities) {
    oddities += oddity.what + " x" + std::to_string(oddity.scans) + "; ";
  }
  for (const char* what : {"unreadable x1", "dropped x1", "equal to the one before x1",
                           "stamp before the one before x1", "shorter than 0.01 s x1"}) {
    EXPECT_NE(oddities.find(what), std::string::npos) << what << " not in " << oddities;
  }
}

TEST(Summary, CountsScansThatAreSentAgain) {
  const TemporaryFolder folder;
  const std::string times = "10\n10.1\n10\n10.1\n10.2\n";
  for (const char* name : {"0.pcd", "1.pcd", "2.pcd", "3.pcd", "4.pcd"}) {
    folder.write(name, timed_pcd<float>({0.0F, 0.0625F}));
  }
  folder.write("times.txt", times);
  OpenOptions as_it_is;
  as_it_is.repair_stamps = false;
  const RecordingSummary summary = summarise(*open_recording(folder.path(), as_it_is));
  const auto found =
      std::find_if(summary.oddities.begin(), summary.oddities.end(),
                   [](const Oddity& oddity) { return oddity.what == "scans that are sent again"; });
  ASSERT_NE(found, summary.oddities.end());
  EXPECT_EQ(found->scans, 2U);
  EXPECT_EQ(found->first, "2.pcd");
}

}  // namespace
}  // namespace surefoot::io
