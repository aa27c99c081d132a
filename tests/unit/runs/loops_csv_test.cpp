// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/loops_csv.hpp"

#include <string>
#include <vector>

#include "io/recording.hpp"
#include "runs/csv_table.hpp"
#include "runs/scans_csv.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

using LoopsCsv = test::Scratch;

report::ScanTable scans_at(const std::vector<std::int64_t>& stamps_ns) {
  report::ScanTable scans;
  scans.stamps_ns = stamps_ns;
  return scans;
}

TEST_F(LoopsCsv, PlacesAreTheNearestScans) {
  const auto file = write("loops.csv",
                          "stamp,place_stamp,verdict,likeness,why\n"
                          "3.000000001,0.600000000,taken,0.1,\"it fits, surely\"\n"
                          "99.0,-5.0,free_space,0.2,it does not\n");
  const auto loops = read_loops_csv(file, scans_at({0, kSecond, 2 * kSecond, 3 * kSecond}));
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].scan, 3U);
  EXPECT_EQ(loops[0].place, 1U);
  EXPECT_EQ(loops[0].verdict, "taken");
  EXPECT_EQ(loops[0].why, "it fits, surely");
  EXPECT_EQ(loops[1].scan, 3U);
  EXPECT_EQ(loops[1].place, 0U);
}

TEST_F(LoopsCsv, PlacesAreFoundWhereTheClockWasSetBack) {
  const auto file = write("loops.csv",
                          "stamp,place_stamp,verdict,why\n"
                          "3.0,101.0,taken,\n"
                          "101.0,101.0,taken,\n");
  const auto loops = read_loops_csv(file, scans_at({100 * kSecond, 101 * kSecond, 102 * kSecond,
                                                    3 * kSecond, 4 * kSecond, 101 * kSecond}));
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].scan, 3U);
  EXPECT_EQ(loops[0].place, 1U);
  EXPECT_EQ(loops[1].scan, 5U);
  EXPECT_EQ(loops[1].place, 1U);
}

/// Of a CSV file with a header and one line: how many fields they have.
void expect_full_line(const std::string& text, const std::string& why) {
  const std::size_t end = text.find('\n');
  const std::vector<std::string> head = csv_fields(text.substr(0, end));
  const std::vector<std::string> line = csv_fields(text.substr(end + 1, text.size() - end - 2));
  EXPECT_EQ(line.size(), head.size()) << text;
  EXPECT_EQ(line.back(), why) << text;
}

TEST_F(LoopsCsv, EveryVerdictsSentenceIsOneField) {
  mapping::MapJoin join;
  join.pieces.resize(2);
  join.loops.resize(1);
  join.loops[0].query = 1;
  int verdicts = 0;
  for (;; ++verdicts) {
    const auto verdict = static_cast<mapping::LoopVerdict>(verdicts);
    if (mapping::to_string(verdict) == "?") break;
    join.loops[0].check.verdict = verdict;
    const std::string why(mapping::explain(verdict));
    expect_full_line(loops_csv(join.pieces, join.loops, nullptr), why);
    expect_full_line(join_csv_header() + join_csv(join, 2), why);
  }
  EXPECT_GT(verdicts, 12);
}

TEST_F(LoopsCsv, ABrokenOneIsRefusedByLine) {
  const report::ScanTable scans = scans_at({0});
  const auto broken = write("loops.csv",
                            "stamp,place_stamp,verdict,why\n1.0,2.0,taken,yes\n"
                            "1.0,soon,taken,yes\n");
  const auto said = [&](const std::filesystem::path& file) {
    try {
      (void)read_loops_csv(file, scans);
      return std::string("nothing");
    } catch (const io::ReadError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(said(broken).find("loops.csv: line 3: place_stamp is 'soon'"), std::string::npos)
      << said(broken);
  const auto other = write("other.csv", "stamp,verdict,why\n");
  EXPECT_NE(said(other).find("no column 'place_stamp'"), std::string::npos) << said(other);
}

}  // namespace
}  // namespace surefoot::runs
