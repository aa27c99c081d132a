// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot report: which folders it takes, and what it says about the others.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/decimal_time.hpp"
#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

/// The recording "in" and its run "run".
class ReportCommand : public testing::Test {
 protected:
  void SetUp() override {
    write_pcd_recording(path("in"), hall_scans(6));
    const ProcessResult result = surefoot({"run", "in", "-o", "run", "-q"});
    ASSERT_EQ(result.exit_code, 0) << result;
    if (!fs::exists(path("run/report.html"))) {
      const ProcessResult report = surefoot({"report", "run"});
      EXPECT_EQ(report.exit_code, 2) << report;
      EXPECT_NE(report.errors.find("built without the report's page"), std::string::npos) << report;
      GTEST_SKIP() << "the program is built without the report's page";
    }
  }
  [[nodiscard]] fs::path path(const std::string& name) const { return scratch_.path() / name; }
  [[nodiscard]] ProcessResult surefoot(const std::vector<std::string>& arguments) const {
    return run_surefoot(arguments, scratch_.path());
  }
  /// The data in a page.
  [[nodiscard]] nlohmann::json data_of(const std::string& page) const {
    const std::string html = file_content(path(page));
    const std::string before = "id=\"report-data\">";
    const std::size_t begin = html.find(before) + before.size();
    const nlohmann::json data = nlohmann::json::parse(
        html.substr(begin, html.find("</script>", begin) - begin), nullptr, false);
    EXPECT_FALSE(data.is_discarded()) << page;
    return data;
  }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& named) const {
    const ProcessResult result = surefoot(arguments);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE(result.errors.find(named), std::string::npos) << "not named: " << named << result;
  }
  /// The estimate itself as truth, so that every error is nothing.
  void write_own_truth(const std::string& name, double later = 0.0) const {
    Trajectory truth = io::read_tum(path("run/trajectory.tum"));
    for (std::size_t i = 0; i < truth.size(); ++i) {
      truth[i].stamp_ns += static_cast<std::int64_t>(later * 1e9);
      truth[i].pose.translation.y() += 0.05 * static_cast<double>(i * i);  // no straight line
    }
    io::write_tum(path(name), truth);
  }

  ScratchFolder scratch_;
};

TEST_F(ReportCommand, TheRunsOwnPageHoldsEveryScan) {
  const nlohmann::json data = data_of("run/report.html");
  EXPECT_EQ(data["title"], "in");
  ASSERT_EQ(data["runs"].size(), 1U);
  EXPECT_EQ(data["runs"][0]["scans"]["count"], 6);
  EXPECT_TRUE(data["runs"][0]["evaluation"].is_null());
  EXPECT_FALSE(data["runs"][0]["map"].is_null());
  EXPECT_FALSE(data["runs"][0]["parameters"].empty());
}

TEST_F(ReportCommand, FiguresAreThoseOfEval) {
  write_own_truth("truth.tum");
  const ProcessResult result =
      surefoot({"report", "run", "--truth", "truth.tum", "-o", "page.html", "--title", "<T>"});
  EXPECT_EQ(result.exit_code, 0) << result;
  const nlohmann::json data = data_of("page.html");
  const std::string align = data["runs"][0]["evaluation"]["align"];
  EXPECT_EQ(align, "poses")
      << "the run stands, and what it is from the truth is as far as that goes";
  const ProcessResult eval =
      surefoot({"eval", "truth.tum", "run/trajectory.tum", "--align", align, "--json"});
  EXPECT_EQ(data["runs"][0]["evaluation"]["figures"], nlohmann::json::parse(eval.output)[0]);
  EXPECT_FALSE(data["recordings"][0]["truth"].is_null());
  EXPECT_NE(file_content(path("page.html")).find("<title>&lt;T&gt;"), std::string::npos);
}

TEST_F(ReportCommand, TruthOfAnotherTimeIsToldAndLeftOut) {
  write_own_truth("truth.tum", 1000.0);
  const ProcessResult result =
      surefoot({"report", "run", "--truth", "truth.tum", "-o", "page.html"});
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_NE(result.errors.find("not compared with the truth"), std::string::npos) << result;
  EXPECT_TRUE(data_of("page.html")["runs"][0]["evaluation"].is_null());
}

/// The way after loops is laid on the truth as the run's own is.
TEST_F(ReportCommand, LoopsAndTheWayAfterThemAreShown) {
  EXPECT_TRUE(data_of("run/report.html")["runs"][0]["corrected"].is_null());
  const Trajectory measured = io::read_tum(path("run/trajectory.tum"));
  fs::copy_file(path("run/trajectory.tum"), path("run/trajectory_optimized.tum"));
  std::ofstream(path("run/loops.csv"))
      << "stamp,place_stamp,verdict,why\n"
      << io::format_seconds(measured.back().stamp_ns) << ','
      << io::format_seconds(measured.front().stamp_ns) << ",taken,\"it fits, surely\"\n";
  write_own_truth("truth.tum");
  EXPECT_EQ(surefoot({"report", "run", "-o", "own.html"}).exit_code, 0);
  EXPECT_EQ(surefoot({"report", "run", "--truth", "truth.tum", "-o", "page.html"}).exit_code, 0);
  const nlohmann::json own = data_of("own.html")["runs"][0];
  const nlohmann::json run = data_of("page.html")["runs"][0];
  EXPECT_EQ(run["corrected"]["positions"], run["path"]["positions"]);
  EXPECT_NE(run["corrected"]["positions"], own["corrected"]["positions"]);
  ASSERT_EQ(run["loops"].size(), 1U);
  EXPECT_EQ(run["loops"][0]["scan"], 5);
  EXPECT_EQ(run["loops"][0]["place"], 0);
  EXPECT_EQ(run["loops"][0]["why"], "it fits, surely");
  // Of a map that was gone on with the corrected poses are in that map's frame.
  std::ofstream(path("run/map_loops.csv")) << '\n';
  EXPECT_EQ(surefoot({"report", "run", "-o", "on.html"}).exit_code, 0);
  EXPECT_TRUE(data_of("on.html")["runs"][0]["corrected"].is_null());
}

TEST_F(ReportCommand, SeveralRunsOfOneRecordingHaveNamesOfTheirOwn) {
  fs::copy(path("run"), path("again"));
  const ProcessResult result = surefoot({"report", "run", "again"});
  EXPECT_EQ(result.exit_code, 0) << result;
  const nlohmann::json data = data_of("report.html");
  EXPECT_EQ(data["recordings"].size(), 1U);
  ASSERT_EQ(data["runs"].size(), 2U);
  EXPECT_NE(data["runs"][0]["name"], data["runs"][1]["name"]);
}

TEST_F(ReportCommand, OneBrokenFolderDoesNotTakeTheOthersAlong) {
  fs::create_directory(path("empty"));
  const ProcessResult result = surefoot({"report", "run", "empty"});
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_NE(result.errors.find("empty"), std::string::npos) << result;
  EXPECT_EQ(data_of("report.html")["runs"].size(), 1U);
}

TEST_F(ReportCommand, DoesWithoutMapAndParameters) {
  fs::remove(path("run/map.ply"));
  fs::remove(path("run/run.yaml"));
  const ProcessResult result = surefoot({"report", "run"});
  EXPECT_EQ(result.exit_code, 0) << result;
  const nlohmann::json run = data_of("run/report.html")["runs"][0];
  EXPECT_TRUE(run["map"].is_null());
  EXPECT_EQ(run["notes"].size(), 2U);
}

TEST_F(ReportCommand, OneScanAndNoneThatCouldBeUsed) {
  ASSERT_EQ(surefoot({"run", "in", "-o", "one", "--count", "1"}).exit_code, 0);
  EXPECT_EQ(data_of("one/report.html")["runs"][0]["scans"]["count"], 1);
  const ProcessResult rejected =
      surefoot({"run", "in", "-o", "rejected", "--set", "preprocess.min_range=90"});
  EXPECT_EQ(rejected.exit_code, 2) << rejected;
  const nlohmann::json run = data_of("rejected/report.html")["runs"][0];
  EXPECT_EQ(run["scans"]["status"]["texts"], nlohmann::json({"rejected"}));
}

TEST_F(ReportCommand, NoReportLeavesNone) {
  ASSERT_EQ(surefoot({"run", "in", "-o", "bare", "--no-report", "-q"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("bare/report.html")));
}

TEST_F(ReportCommand, NonsenseIsRefusedByName) {
  fs::create_directory(path("empty"));
  expect_refused({"report", "empty"}, "empty");
  expect_refused({"report", "nowhere"}, "nowhere");
  expect_refused({"report", "run/map.ply"}, "map.ply");
  expect_refused({"report", "run", "--truth", "none.tum"}, "none.tum");
  expect_refused({"report", "run", "--map-points", "0"}, "--map-points");
  expect_refused({"report", "run", "-o", "no/such/folder.html"}, "folder.html");
  for (const char* file : {"scans.csv", "trajectory_kitti.txt", "run.yaml", "map.ply"}) {
    fs::remove_all(path("broken"));
    fs::copy(path("run"), path("broken"));
    write_content(path("broken") / file, "nonsense, of one line\n");
    expect_refused({"report", "broken"}, file);
  }
}

TEST_F(ReportCommand, BrokenTablesNameTheLine) {
  const std::string csv = file_content(path("run/scans.csv"));
  const std::size_t second = csv.find('\n') + 1;
  write_content(path("run/scans.csv"), csv.substr(0, second) + "1,2,3\n");
  expect_refused({"report", "run"}, "line 2: 3 fields");
  write_content(path("run/scans.csv"), csv + csv.substr(second));
  expect_refused({"report", "run"}, "6 poses for the 12 scans");
  const std::size_t fourth = csv.find('\n', csv.find('\n', csv.find('\n', second) + 1) + 1) + 1;
  write_content(path("run/scans.csv"), csv.substr(0, fourth));
  expect_refused({"report", "run"}, "scans.csv: ends after 3 scans, of which trajectory_kitti.txt");
  write_content(path("run/scans.csv"), csv + "6,\"half a li");
  EXPECT_EQ(surefoot({"report", "run"}).exit_code, 0) << "an unfinished last line is left out";
}

TEST_F(ReportCommand, ReadsAComparison) {
  fs::create_directories(path("compared"));
  fs::copy(path("run"), path("compared/runs"));
  write_own_truth("truth.tum");
  const nlohmann::json cell = {{"method", "paper"}, {"text", "0.1"}, {"value", 0.1}, {"place", 1}};
  const auto result = [](const char* method, const char* folder) {
    return nlohmann::json{
        {"method", method}, {"outcome_text", "stopped early"}, {"runs", {{{"folder", folder}}}}};
  };
  const nlohmann::json comparison = {
      {"format", "surefoot-comparison"},
      {"format_version", 1},
      {"notes", {"a note"}},
      {"tables",
       {{{"title", "APE"},
         {"rows", {{{"sequence", "in"}, {"figure", "max"}, {"cells", {cell}}}}}}}},
      {"recordings",
       {{{"name", "in"},
         {"truth", path("truth.tum").string()},
         {"results", {result("paper", "runs"), result("lost", "none")}}}}}};
  write_content(path("compared/compare.json"), comparison.dump());
  const ProcessResult done = surefoot({"report", "compared"});
  EXPECT_EQ(done.exit_code, 0) << done;
  const nlohmann::json data = data_of("compared/report.html");
  ASSERT_EQ(data["runs"].size(), 1U);
  EXPECT_FALSE(data["runs"][0]["evaluation"].is_null());
  EXPECT_EQ(data["tables"][0]["columns"], nlohmann::json({"Sequence", "Figure", "paper"}));
  EXPECT_EQ(data["notes"], nlohmann::json({"a note", "in, lost: stopped early"}));
  write_content(path("compared/compare.json"), "{\"format\": 3");
  expect_refused({"report", "compared"}, "compare.json");
}

}  // namespace
}  // namespace surefoot::test
