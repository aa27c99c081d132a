// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The report's data, read back by other means than those that wrote them.
#include "report/report_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/base64.hpp"
#include "report/page.hpp"

namespace surefoot::report {
namespace {

using nlohmann::json;

constexpr std::int64_t kStart = 1'700'000'000'050'000'000;  // an epoch time, past what a float has
constexpr std::int64_t kStep = 100'000'000;

/// Sums up bits, six a digit.
std::vector<std::uint8_t> decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = (bits << 6 | unsigned(digits.find(c))) & 0xFFFFU;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  return bytes;
}

template <typename T>
std::vector<T> numbers(const json& text) {
  const auto bytes = decoded(text.get<std::string>());
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

ReportRun three_scans() {
  ReportRun run;
  run.name = "paper";
  run.scans.stamps_ns = {kStart, kStart + kStep, kStart + 2 * kStep};
  run.scans.statuses = {"first_scan", "ok", "rejected"};
  run.scans.messages = {"", "", "</script><b>no points"};
  run.scans.stages = {"horizontal", "vertical"};
  run.scans.degenerate = {"", "z", ""};
  run.scans.columns = {{"ms_total", {1.5F, 2.5F, std::nanf("")}}};
  const Pose turned{from_roll_pitch_yaw({0.1, -0.2, 0.3}), {1, 2, 3}};
  run.poses = {Pose{}, turned, std::nullopt};
  run.map.points = {{-1, 0, 0}, {3, 0, 0}, {1, 0, 8}};
  run.map.intensities = {0, 50, 100};
  run.map.first_seen = {0, 0.1F, 0.2F};
  return run;
}

Report one_run() {
  Report report;
  report.title = "walk";
  report.recordings = {{"walk", {{kStart + kStep, Pose{}}}}};
  report.runs = {three_scans()};
  return report;
}

TEST(Base64, Rfc4648Vectors) {
  const std::vector<std::pair<std::string, std::string>> vectors = {{"", ""},
                                                                    {"f", "Zg=="},
                                                                    {"fo", "Zm8="},
                                                                    {"foo", "Zm9v"},
                                                                    {"foob", "Zm9vYg=="},
                                                                    {"fooba", "Zm9vYmE="},
                                                                    {"foobar", "Zm9vYmFy"}};
  for (const auto& [text, expected] : vectors) {
    EXPECT_EQ(base64_of(std::span<const char>(text.data(), text.size())), expected);
  }
  const std::vector<std::uint8_t> high = {0xFF, 0xFE, 0xFB};
  EXPECT_EQ(base64_of(std::span<const std::uint8_t>(high)), "//77");
}

TEST(ReportJson, TimesStartWithTheRecording) {
  const json data = json::parse(to_json(one_run()));
  const auto times = numbers<float>(data["runs"][0]["scans"]["times"]);
  ASSERT_EQ(times.size(), 3U);
  EXPECT_EQ(times[0], 0.0F);
  EXPECT_FLOAT_EQ(times[2], 0.2F);
  EXPECT_FLOAT_EQ(numbers<float>(data["recordings"][0]["truth"]["times"]).at(0), 0.1F);
}

TEST(ReportJson, TellsWhatWasTakenOffCoordinates) {
  Report report = one_run();
  report.recordings[0].origin = {512'000.0, -5'000.0, 0.0};
  const json data = json::parse(to_json(report));
  EXPECT_EQ(data["recordings"][0]["origin"], (json{512'000.0, -5'000.0, 0.0}));
}

TEST(ReportJson, TimesStartWithTheLeastStampOfAClockThatWasSetBack) {
  Report report = one_run();
  report.runs[0].scans.stamps_ns[1] = kStart - kStep;
  const json data = json::parse(to_json(report));
  const auto times = numbers<float>(data["runs"][0]["scans"]["times"]);
  ASSERT_EQ(times.size(), 3U);
  EXPECT_FLOAT_EQ(times[0], 0.1F);
  EXPECT_EQ(times[1], 0.0F);
}

TEST(ReportJson, PosesInMetresAndDegreesAndNoneForARejectedScan) {
  const json data = json::parse(to_json(one_run()));
  const auto positions = numbers<float>(data["runs"][0]["path"]["positions"]);
  const auto angles = numbers<float>(data["runs"][0]["path"]["angles"]);
  ASSERT_EQ(positions.size(), 9U);
  EXPECT_EQ(positions[4], 2.0F);
  EXPECT_NEAR(angles[3], 0.1 * 180 / 3.14159265, 1e-4);
  EXPECT_NEAR(angles[4], -0.2 * 180 / 3.14159265, 1e-4);
  EXPECT_TRUE(std::isnan(positions[6]) && std::isnan(angles[8]));
}

TEST(ReportJson, LoopsJoinScansAndCorrectedPosesAreOnesOfThem) {
  Report report = one_run();
  EXPECT_TRUE(json::parse(to_json(report))["runs"][0]["corrected"].is_null());
  report.runs[0].loops = {{2, 0, "taken", "yes"}, {1, 0, "free_space", "<no>"}};
  report.runs[0].corrected = {Pose{}, std::nullopt,
                              Pose{Eigen::Quaterniond::Identity(), {4, 5, 6}}};
  const json run = json::parse(to_json(report))["runs"][0];
  ASSERT_EQ(run["loops"].size(), 2U);
  EXPECT_EQ(run["loops"][0]["scan"], 2);
  EXPECT_EQ(run["loops"][0]["place"], 0);
  EXPECT_EQ(run["loops"][1]["verdict"], "free_space");
  EXPECT_EQ(run["loops"][1]["why"], "<no>");
  const auto positions = numbers<float>(run["corrected"]["positions"]);
  ASSERT_EQ(positions.size(), 9U);
  EXPECT_TRUE(std::isnan(positions[3]));
  EXPECT_EQ(positions[8], 6.0F);
  report.runs[0].corrected.pop_back();
  EXPECT_THROW((void)to_json(report), std::invalid_argument);
}

TEST(ReportJson, ScansKeepTheirWords) {
  const json scans = json::parse(to_json(one_run()))["runs"][0]["scans"];
  const auto status = numbers<std::uint32_t>(scans["status"]["numbers"]);
  EXPECT_EQ(scans["status"]["texts"][status.at(2)], "rejected");
  EXPECT_EQ(scans["degenerate"]["texts"][numbers<std::uint32_t>(scans["degenerate"]["numbers"])[1]],
            "z");
  EXPECT_EQ(scans["stages"], (json{"horizontal", "vertical"}));
  EXPECT_EQ(scans["messages"].size(), 1U);
  EXPECT_EQ(scans["messages"]["2"], "</script><b>no points");
  EXPECT_TRUE(std::isnan(numbers<float>(scans["columns"]["ms_total"])[2]));
}

TEST(ReportJson, NothingEndsTheScriptElement) {
  Report report = one_run();
  report.title = "<!-- </script>";
  report.notes = {"bytes \xff that are no UTF-8"};
  const std::string text = to_json(report);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(json::parse(text)["title"], report.title);
}

TEST(ReportJson, MapComesBackWithinAStep) {
  const json map = json::parse(to_json(one_run()))["runs"][0]["map"];
  EXPECT_EQ(map["points"], 3);
  EXPECT_EQ(map["shown"], 3);
  const auto steps = numbers<std::uint16_t>(map["positions"]["values"]);
  const auto points = three_scans().map.points;
  for (std::size_t i = 0; i < 9; ++i) {
    const double low = map["positions"]["low"][i % 3], high = map["positions"]["high"][i % 3];
    EXPECT_NEAR(low + (high - low) * steps.at(i) / 65535.0, points[i / 3][int(i % 3)], 1e-4);
  }
  EXPECT_EQ(numbers<std::uint8_t>(map["intensity"]["values"]),
            (std::vector<std::uint8_t>{0, 128, 255}));
  EXPECT_EQ(numbers<std::uint16_t>(map["first_seen_s"]["values"]).at(2), 65535);
}

TEST(ReportJson, NoMapIsNull) {
  Report report = one_run();
  report.runs[0].map = {};
  EXPECT_TRUE(json::parse(to_json(report))["runs"][0]["map"].is_null());
  report.runs[0].map.points = {Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity())};
  EXPECT_TRUE(json::parse(to_json(report))["runs"][0]["map"].is_null());
}

TEST(ReportJson, MapsTogetherStayWithinTheLimit) {
  Report report = one_run();
  report.runs[0].map = {};
  for (int i = 0; i < 600; ++i) {
    for (int k = 0; k < 600; ++k) report.runs[0].map.points.emplace_back(i, k, 0);
  }
  report.runs.resize(5, report.runs[0]);
  std::size_t shown = 0;
  const json data = json::parse(to_json(report));
  for (const json& run : data["runs"]) {
    shown += run["map"]["shown"].get<std::size_t>();
  }
  EXPECT_LE(shown, kMostMapPoints);
  EXPECT_GT(shown, kMostMapPoints / 2);
}

TEST(ReportJson, RefusesWhatDoesNotBelongTogether) {
  const auto refused = [](auto change) {
    Report report = one_run();
    change(report.runs[0]);
    EXPECT_THROW((void)to_json(report), std::invalid_argument);
  };
  refused([](ReportRun& run) { run.poses.pop_back(); });
  refused([](ReportRun& run) { run.scans.statuses.pop_back(); });
  refused([](ReportRun& run) { run.scans.columns[0].values.push_back(1); });
  refused([](ReportRun& run) { run.map.intensities.pop_back(); });
  refused([](ReportRun& run) { run.recording = 1; });
}

TEST(Page, PutsTitleAndDataInTheirPlaces) {
  EXPECT_EQ(make_page("<t>{{surefoot-report-title}}</t>{{surefoot-report-data}};", "a<b&c", "{1}"),
            "<t>a&lt;b&amp;c</t>{1};");
  EXPECT_THROW((void)make_page("no place", "", ""), std::invalid_argument);
  EXPECT_THROW((void)make_page("{{surefoot-report-data}}{{surefoot-report-data}}", "", ""),
               std::invalid_argument);
}

TEST(Page, TheBundledOneIsWholeOrAbsent) {
  if (page_template().empty()) GTEST_SKIP() << "built without the report's page";
  EXPECT_NO_THROW((void)make_page(page_template(), "title", "{}"));
  EXPECT_EQ(page_template().find("{{script}}"), std::string_view::npos);
}

}  // namespace
}  // namespace surefoot::report
