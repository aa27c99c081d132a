// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/scans_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "io/recording.hpp"
#include "runs/csv_table.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

using ScansCsv = test::Scratch;

constexpr const char* kHeader = "scan,name,stamp,status,message,ms_map,ms_total\n";

TEST(CsvFields, Quotes) {
  EXPECT_EQ(csv_fields("a,,\"b, \"\"c\"\"\",d"),
            (std::vector<std::string>{"a", "", "b, \"c\"", "d"}));
  EXPECT_EQ(csv_fields(""), std::vector<std::string>{""});
}

TEST_F(ScansCsv, IsRead) {
  const auto file = write("scans.csv", std::string(kHeader) +
                                           "0,\"a\",1.050000000,first_scan,\"\",0.1,8.5\n"
                                           "1,\"b\",1.150000001,ok,\"far, \"\"far\"\"\",0.1,7.5\n"
                                           "2,\"c\",1.250000000,ok,\"\",0.1,9.25\n");
  const report::ScanTable scans = read_scans_csv(file);
  EXPECT_EQ(scans.stamps_ns,
            (std::vector<std::int64_t>{1'050'000'000, 1'150'000'001, 1'250'000'000}));
  EXPECT_EQ(count_statuses(scans),
            (std::map<std::string, std::size_t>{{"first_scan", 1}, {"ok", 2}}));
  EXPECT_EQ(scan_milliseconds(scans, file), (std::vector<double>{8.5, 7.5, 9.25}));
  EXPECT_EQ(scans.messages, (std::vector<std::string>{"", "far, \"far\"", ""}));
}

TEST(ScansByStamp, AreFoundInOrderWhereTheClockWasSetBack) {
  report::ScanTable table;
  table.stamps_ns = {100, 110, 120, 5, 15, 110};
  const ScansByStamp scans(table);
  EXPECT_EQ(scans.nearest(100), 0U);
  EXPECT_EQ(scans.nearest(118), 2U);
  EXPECT_EQ(scans.nearest(500), 2U);
  EXPECT_EQ(scans.nearest(6, 3), 3U);
  EXPECT_EQ(scans.nearest(-7), 3U);
  EXPECT_EQ(scans.nearest(110), 1U);
  EXPECT_EQ(scans.nearest(110, 1), 1U);
  EXPECT_EQ(scans.nearest(110, 2), 5U);
  EXPECT_EQ(scans.nearest(111, 6), 5U) << "none is left";
}

TEST(ScansByStamp, MayBeAnyHowFarApart) {
  constexpr std::int64_t kEnd = std::numeric_limits<std::int64_t>::max();
  report::ScanTable table;
  table.stamps_ns = {-kEnd, kEnd - 2};
  const ScansByStamp scans(table);
  EXPECT_EQ(scans.nearest(kEnd - 9), 1U);
  EXPECT_EQ(scans.nearest(9 - kEnd), 0U);
  EXPECT_EQ(scans.nearest(kEnd), 1U);
}

/// Every column's value is different, so that a column in another's place shows.
TEST_F(ScansCsv, WhatIsWrittenIsReadBack) {
  Estimate estimate;
  estimate.status = Status::degenerate;
  estimate.stamp_ns = 1'700'000'000'123'456'789;
  estimate.message = "weak, \"very\"\nweak";
  estimate.T_world_lidar.translation = {1.5, -2.5, 3.5};
  estimate.points = 4;
  estimate.registered_points = 5;
  estimate.converged = true;
  estimate.stages = {{"horizontal", 11, 12, 13.0, 14.0}, {"vertical", 21, 22, 23.0, 24.0}};
  estimate.segment = 6;
  estimate.wrong_probability = 0.125;
  estimate.evidence.misfit = 0.5;
  estimate.evidence.frozen = 0.75;
  estimate.covariance.diagonal() << 1.0, 4.0, 9.0, 16.0, 25.0, 36.0;
  estimate.degenerate = {{Twist::Zero(), 0.25, "forward"}, {Twist::Zero(), 0.5, "up"}};
  const StepTimes times;
  const auto file = write(
      "scans.csv", scans_csv_header() + scans_csv_line({7, "a\nb\r\x01.pcd", estimate, times}));
  const report::ScanTable scans = read_scans_csv(file);
  ASSERT_EQ(scans.size(), 1U);
  EXPECT_EQ(scans.stamps_ns.front(), estimate.stamp_ns);
  EXPECT_EQ(scans.statuses.front(), "degenerate");
  EXPECT_EQ(scans.messages.front(), "weak, \"very\"\\x0aweak");
  EXPECT_EQ(scans.degenerate.front(), "forward up");
  EXPECT_EQ(scans.stages, (std::vector<std::string>{"horizontal", "vertical"}));
  std::map<std::string, float> numbers;
  for (const report::ScanColumn& column : scans.columns) {
    numbers[column.name] = column.values.front();
  }
  const std::map<std::string, float> expected = {{"scan", 7.0F},
                                                 {"x", 1.5F},
                                                 {"y", -2.5F},
                                                 {"z", 3.5F},
                                                 {"points", 4.0F},
                                                 {"registered_points", 5.0F},
                                                 {"converged", 1.0F},
                                                 {"stage1_iterations", 11.0F},
                                                 {"stage1_matches", 12.0F},
                                                 {"stage1_residual_m", 13.0F},
                                                 {"stage2_iterations", 21.0F},
                                                 {"stage2_matches", 22.0F},
                                                 {"stage2_residual_m", 23.0F},
                                                 {"stage2_observability", 24.0F},
                                                 {"sigma_x_m", 1.0F},
                                                 {"sigma_yaw_rad", 6.0F},
                                                 {"ms_total", 0.0F},
                                                 {"segment", 6.0F},
                                                 {"wrong_probability", 0.125F},
                                                 {"evidence_misfit", 0.5F},
                                                 {"evidence_frozen", 0.75F},
                                                 {"least_information", 0.25F}};
  for (const auto& [name, value] : expected) {
    ASSERT_TRUE(numbers.count(name)) << name;
    EXPECT_EQ(numbers[name], value) << name;
  }
  EXPECT_TRUE(std::isnan(numbers.at("stage1_observability"))) << "of the vertical stage alone";
  EXPECT_TRUE(scans_csv_header().starts_with(scans_csv_beginning()));
}

/// A run's first scan is not registered; its stages are those of the scans that were.
TEST_F(ScansCsv, AScanWithoutStagesHasNoNumbersOfThem) {
  Estimate first, second;
  second.stages = StageReport{"registration", 3, 4, 5.0};
  const StepTimes times;
  const auto file = write("scans.csv", scans_csv_header() + scans_csv_line({0, "a", first, times}) +
                                           scans_csv_line({1, "b", second, times}));
  const report::ScanTable scans = read_scans_csv(file);
  EXPECT_EQ(scans.stages, std::vector<std::string>{"registration"});
  for (const report::ScanColumn& column : scans.columns) {
    if (column.name == "stage1_matches") {
      EXPECT_TRUE(std::isnan(column.values[0]));
      EXPECT_EQ(column.values[1], 4.0F);
    }
    if (column.name == "stage2_matches") {
      EXPECT_TRUE(std::isnan(column.values[1]));
    }
  }
}

TEST_F(ScansCsv, AFileNameIsTextWhateverItsBytes) {
  Estimate estimate;
  const auto line = [&](const char* name) { return scans_csv_line({0, name, estimate, {}}); };
  EXPECT_NE(line("\xc3\xa9t\xc3\xa9.pcd").find("\xc3\xa9t\xc3\xa9.pcd"), std::string::npos);
  const std::string escaped = line("\xff\xc3.pcd");
  EXPECT_NE(escaped.find("\\xff\\xc3.pcd"), std::string::npos) << escaped;
  EXPECT_EQ(read_scans_csv(write("scans.csv", scans_csv_header() + escaped)).size(), 1U);
}

/// Far more than is read at once.
TEST_F(ScansCsv, OfADayIsReadRowByRow) {
  constexpr std::size_t kScans = 20'000;
  const std::string message(80, 'm');
  std::string text = kHeader;
  for (std::size_t i = 0; i < kScans; ++i) {
    text += fmt::format("{0},\"a\",{0}.5,ok,\"{1}{0}\",0.1,{0}.25\n", i, message);
  }
  ASSERT_GT(text.size(), 2U << 20U);
  const auto file = write("scans.csv", text + "20000,\"cut");
  const report::ScanTable scans = read_scans_csv(file);
  ASSERT_EQ(scans.size(), kScans);
  const std::vector<double> milliseconds = scan_milliseconds(scans, file);
  for (std::size_t i = 0; i < kScans; ++i) {
    ASSERT_EQ(scans.stamps_ns[i], static_cast<std::int64_t>(i) * 1'000'000'000 + 500'000'000);
    ASSERT_EQ(scans.messages[i], message + std::to_string(i));
    ASSERT_EQ(milliseconds[i], static_cast<double>(i) + 0.25);
  }
  (void)write("scans.csv", text + "20000,\"a\",soon,ok,,0.1,8.5\n");
  try {
    (void)read_scans_csv(file);
    ADD_FAILURE() << "taken";
  } catch (const io::ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("line 20002: stamp is 'soon'"), std::string::npos)
        << error.what();
  }
}

TEST_F(ScansCsv, WhatIsWrongIsNamed) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "cannot be read"},
      {"scan,name\n", "'stamp'"},
      {std::string(kHeader) + "0,\"a\",1.0\n", "line 2"},
      {std::string(kHeader) + "0,\"a\",1.0,ok,\"\",0.1,8.5\n1,\"a\",soon,ok,\"\",0.1,8.5\n",
       "line 3"},
      {std::string(kHeader) + "0,\"a\",1.0,ok,\"\",0.1,quick\n", "'quick'"}};
  for (const auto& [content, named] : cases) {
    const auto file = write("scans.csv", content);
    try {
      (void)scan_milliseconds(read_scans_csv(file), file);
      ADD_FAILURE() << "taken: " << content;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("scans.csv"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW((void)read_scans_csv(folder_ / "none.csv"), std::runtime_error);
}

}  // namespace
}  // namespace surefoot::runs
