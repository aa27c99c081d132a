// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/stamps.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "io/decimal_time.hpp"
#include "io/files/scan_files.hpp"
#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

TEST(DecimalSeconds, ExactToTheNanosecond) {
  const auto is = [](const char* text, std::int64_t ns) {
    EXPECT_EQ(parse_decimal_seconds(text), ns) << text;
  };
  is("1630577758.569489956", 1630577758569489956);  // a double would end in ..9956 or not
  is("0", 0);
  is("-0.1", -100'000'000);
  is("+7.", 7'000'000'000);
  is(".5", 500'000'000);
  is("1.036224e-01", 103'622'400);
  is("0.000000e+00", 0);
  is("1e9", 1'000'000'000'000'000'000);
  is("2.5E-9", 3);  // half away from zero
  is("-2.5e-9", -3);
  is("2.4999999999e-9", 2);
  is("0.9999999995", 1'000'000'000);
  is("1e-30", 0);
  is("0.000000000499999", 0);
  is("9223372036.854775", 9223372036854775000);
  is("9e-12", 0);
  is("1e-100", 0);
  is("0e100", 0);
  for (const char* bad : {"",
                          ".",
                          "-",
                          "+",
                          "e5",
                          "1e",
                          "1e+",
                          "1.2.3",
                          "1,5",
                          "nan",
                          "inf",
                          "0x1",
                          "1 ",
                          " 1",
                          "1e400",
                          "0e101",
                          "1e-101",
                          "1e10",
                          "99999999999999999999",
                          "1e99999999999"}) {
    EXPECT_EQ(parse_decimal_seconds(bad), std::nullopt) << bad;
  }
}

TEST(DecimalSeconds, RoundTrip) {
  for (const std::int64_t ns : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{999'999'999},
                                std::int64_t{-1'500'000'000}, std::int64_t{1630577758569489956}}) {
    EXPECT_EQ(parse_decimal_seconds(format_seconds(ns)), ns);
  }
  EXPECT_EQ(format_seconds(-1), "-0.000000001");
  EXPECT_EQ(format_seconds(std::numeric_limits<std::int64_t>::min()), "-9223372036.854775808");
}

TEST(DateTime, KittiLines) {
  // date -u -d '2011-09-26 14:30:14' +%s = 1317047414
  EXPECT_EQ(parse_date_time("2011-09-26 14:30:14.950485851"), 1317047414950485851);
  EXPECT_EQ(parse_date_time("1970-01-01T00:00:00"), 0);
  EXPECT_EQ(parse_date_time("2000-02-29 00:00:00.5"), 951782400500000000);
  EXPECT_EQ(parse_date_time("2016-12-31 23:59:60.5"), 1483228800500000000);  // a leap second
  EXPECT_EQ(parse_date_time("1700-01-01 00:00:00"), -8520336000000000000);
  EXPECT_EQ(parse_date_time("2261-12-31 23:59:59"), 9214646399000000000);
  for (const char* bad :
       {"2011-13-26 14:30:14.9", "2011-02-29 14:30:14", "2011-09-26 24:30:14",
        "2011-09-26 14:60:14", "2011-09-26", "9999-09-26 14:30:14", "2011-09-26 14:30:61",
        "1699-12-31 23:59:59", "2262-01-01 00:00:00", "2011-09-26 14:30:1x", ""}) {
    EXPECT_EQ(parse_date_time(bad), std::nullopt) << bad;
  }
}

TEST(Stamps, SecondsNanosecondsAndDates) {
  using Stamps = std::vector<std::int64_t>;
  EXPECT_EQ(parse_stamps("# a comment\n1.5\r\n\n 2.25 \n"), (Stamps{1500000000, 2250000000}));
  EXPECT_EQ(parse_stamps("1630577758569489956\n1630577759068947077"),
            (Stamps{1630577758569489956, 1630577759068947077}));
  EXPECT_EQ(parse_stamps("0\n100000000\n200000000000\n"), (Stamps{0, 100000000, 200000000000}));
  EXPECT_EQ(parse_stamps("0\n1\n2\n"), (Stamps{0, 1000000000, 2000000000}));
  EXPECT_EQ(parse_stamps("2011-09-26 14:30:14.5\n"), Stamps{1317047414500000000});
  EXPECT_TRUE(parse_stamps("").empty());
}

// Of a computer that has been up for so long they would be nanoseconds, too, but not as close.
TEST(Stamps, WholeMicrosecondsAndMilliseconds) {
  using Stamps = std::vector<std::int64_t>;
  std::string unit;
  EXPECT_EQ(parse_stamps("1630577758569489\n1630577758669489\n", &unit),
            (Stamps{1630577758569489000, 1630577758669489000}));
  EXPECT_EQ(unit, "microseconds");
  EXPECT_EQ(parse_stamps("1630577758569\n1630577758669\n", &unit),
            (Stamps{1630577758569000000, 1630577758669000000}));
  EXPECT_EQ(unit, "milliseconds");
  EXPECT_EQ(parse_stamps("1630577758569\n1630677758569\n", &unit),
            (Stamps{1630577758569, 1630677758569}));
  EXPECT_EQ(unit, "");
  EXPECT_EQ(parse_stamps("1630577758569489\n1630577858569489\n", &unit),
            (Stamps{1630577758569489, 1630577858569489}));
  EXPECT_EQ(unit, "");
}

// Of a simulator whose clock began with the recording. Scans are not hours apart, but numbered.
TEST(Stamps, WholeNumbersNearZero) {
  using Stamps = std::vector<std::int64_t>;
  std::string unit;
  EXPECT_EQ(parse_stamps("0\n100000000\n200000000\n", &unit), (Stamps{0, 100000000, 200000000}));
  EXPECT_EQ(unit, "nanoseconds");
  EXPECT_EQ(parse_stamps("1500000000\n1600000000\n1700000000\n"),
            (Stamps{1500000000, 1600000000, 1700000000}));
  EXPECT_EQ(parse_stamps("0\n100000\n200000\n", &unit), (Stamps{0, 100000000, 200000000}));
  EXPECT_EQ(unit, "microseconds");
  constexpr std::int64_t kSecond = 1'000'000'000;
  EXPECT_EQ(parse_stamps("0\n10\n20\n", &unit), (Stamps{0, 10 * kSecond, 20 * kSecond}));
  EXPECT_EQ(parse_stamps("0\n100000000\n", &unit), (Stamps{0, 100000000 * kSecond}));
  EXPECT_EQ(parse_stamps("1630577758\n1630581358\n1630584958\n", &unit),
            (Stamps{1630577758 * kSecond, 1630581358 * kSecond, 1630584958 * kSecond}));
  // Of a clock that was not set at first.
  EXPECT_EQ(parse_stamps("0\n1600000001\n1600000002\n1600000003\n", &unit).back(),
            1600000003 * kSecond);
  EXPECT_EQ(parse_stamps("0\n1630577758\n1630581358\n1630584958\n", &unit).back(),
            1630584958 * kSecond);
  EXPECT_EQ(unit, "");
  EXPECT_EQ(stamps_from_names({"0.pcd", "100000000.pcd", "200000000.pcd"}, &unit),
            (Stamps{0, 100000000, 200000000}));
  EXPECT_EQ(unit, "nanoseconds");
  EXPECT_EQ(stamps_from_names({"0.pcd", "100000.pcd", "200000.pcd"}), std::nullopt);
}

TEST(Stamps, ErrorsNameTheLine) {
  for (const char* bad : {"1.0\nx\n", "1.0\n2.0 3.0\n", "1.0\nnan\n", "1.0\n99999999999999999999\n",
                          "1.0\n2011-99-26 14:30:14\n"}) {
    const std::string message = test::message_of<ReadError>([&] { (void)parse_stamps(bad); });
    EXPECT_TRUE(message.starts_with("line 2")) << message;
  }
}

TEST(Stamps, FromNames) {
  using Paths = std::vector<std::filesystem::path>;
  using Stamps = std::vector<std::int64_t>;
  EXPECT_EQ(stamps_from_names({"1673400472138016708.pcd", "1673400473138016708.pcd"}),
            (Stamps{1673400472138016708, 1673400473138016708}));
  EXPECT_EQ(stamps_from_names({"1630577758.569489956.pcd"}), Stamps{1630577758569489956});
  EXPECT_EQ(stamps_from_names({"1630577758.pcd"}), Stamps{1630577758000000000});
  EXPECT_EQ(stamps_from_names({"1547131046353776.bin"}), Stamps{1547131046353776000});
  EXPECT_EQ(
      stamps_from_names({"n015-2018-07-24-11-22-45+0800__LIDAR_TOP__1532402927647951.pcd.bin"}),
      Stamps{1532402927647951000});
  EXPECT_EQ(stamps_from_names({"1547131046353.bin", "1547131046453.bin"}),
            (Stamps{1547131046353000000, 1547131046453000000}));
  EXPECT_EQ(stamps_from_names({"1547131046353.bin", "1547231046353.bin"}), std::nullopt)
      << "uptime in nanoseconds";
  EXPECT_EQ(stamps_from_names({"scan__12.bin"}), std::nullopt);
  EXPECT_EQ(stamps_from_names({"9547131046353776.bin"}), std::nullopt);
  for (const Paths& names : {Paths{"000000.pcd"}, Paths{"0000000010.bin"}, Paths{"scan1.pcd"},
                             Paths{"1630577758.5.pcd", "map.pcd"}, Paths{"1.2.3.pcd"}}) {
    EXPECT_EQ(stamps_from_names(names), std::nullopt) << names[0];
  }
}

TEST(Stamps, NamesWithDecimalPointsDoNotCount) {
  EXPECT_TRUE(are_counted({"scan.0001.pcd", "scan.0002.pcd"}));
  EXPECT_TRUE(are_counted({"1.bin.pcd", "2.bin.pcd"}));
  EXPECT_FALSE(are_counted({"1.5.pcd", "2.5.pcd"}));
  EXPECT_FALSE(are_counted({"os1.0_1.5.pcd", "os1.0_1.25.pcd"}));
  EXPECT_TRUE(are_counted({"os1.0_000123.pcd", "os1.0_000124.pcd"}));
  EXPECT_FALSE(are_counted({"a1.pcd", "b2.pcd"}));
}

TEST(NaturalOrder, NumbersCount) {
  std::vector<std::string> names = {"scan10",
                                    "scan9",
                                    "b",
                                    "scan09",
                                    "scan1",
                                    "Scan2",
                                    "a10b2",
                                    "a10b1",
                                    "99999999999999999999999",
                                    "100000000000000000000000"};
  std::sort(names.begin(), names.end(), natural_less);
  EXPECT_EQ(names, (std::vector<std::string>{"99999999999999999999999", "100000000000000000000000",
                                             "Scan2", "a10b1", "a10b2", "b", "scan1", "scan09",
                                             "scan9", "scan10"}));
  EXPECT_FALSE(natural_less("a", "a"));
}

TEST(FrameNumbers, CountFromTheFirstWhereSomeAreMissing) {
  EXPECT_EQ(frame_numbers({"7.pcd", "8.pcd", "12.pcd"}), (std::vector<std::int64_t>{0, 1, 5}));
  EXPECT_EQ(frame_numbers({"scan_0098.ply", "scan_0100.ply", "scan_0101.ply"}),
            (std::vector<std::int64_t>{0, 2, 3}));
  for (const std::vector<std::filesystem::path>& names :
       {std::vector<std::filesystem::path>{"1.pcd", "2.pcd", "3.pcd"},  // no more than the order
        {"10.pcd", "20.pcd", "40.pcd"},                                 // may be milliseconds
        {"1.pcd", "2.pcd", "2.pcd"},
        {"3.pcd", "2.pcd", "5.pcd"},
        {"1.pcd", "2.pcd", "end.pcd"},
        {"1.pcd", "2.pcd", "12345678901.pcd"},
        {"1.pcd"},
        {}}) {
    EXPECT_EQ(frame_numbers(names), std::nullopt);
  }
}

}  // namespace
}  // namespace surefoot::io
