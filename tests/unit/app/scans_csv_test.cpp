// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "scans_csv.hpp"

#include "csv_table.hpp"
#include "quantile.hpp"
#include "scratch.hpp"

namespace surefoot::app {
namespace {

using ScansCsv = Scratch;

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
  const ScanLines lines = read_scans_csv(file);
  EXPECT_EQ(lines.stamps_ns,
            (std::vector<std::int64_t>{1'050'000'000, 1'150'000'001, 1'250'000'000}));
  EXPECT_EQ(lines.statuses, (std::map<std::string, std::size_t>{{"first_scan", 1}, {"ok", 2}}));
  EXPECT_EQ(lines.milliseconds, (std::vector<double>{8.5, 7.5, 9.25}));
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
      (void)read_scans_csv(file);
      ADD_FAILURE() << "taken: " << content;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("scans.csv"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW((void)read_scans_csv(folder_ / "none.csv"), std::runtime_error);
}

TEST(Quantile, IsTheRunsOwnRule) {
  EXPECT_EQ(quantile({}, 0.5), 0.0);
  EXPECT_EQ(quantile({3.0}, 0.99), 3.0);
  EXPECT_EQ(quantile({5.0, 1.0, 4.0, 2.0, 3.0}, 0.5), 3.0);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
}

}  // namespace
}  // namespace surefoot::app
