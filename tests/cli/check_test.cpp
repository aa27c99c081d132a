// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot check: recordings that are fit for a run, and recordings written wrongly.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot::test {
namespace {

constexpr int kCheckedScans = 22;

nlohmann::json check_json(const std::vector<std::string>& arguments, int exit_code,
                          const ScratchFolder& scratch) {
  std::vector<std::string> all = {"check", "--json"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const ProcessResult result = run_surefoot(all, scratch.path());
  EXPECT_EQ(result.exit_code, exit_code) << result;
  return nlohmann::json::parse(result.output, nullptr, false);
}

/// What is said of the finding that begins so; empty where there is none.
std::string detail_of(const nlohmann::json& json, const std::string& begin) {
  for (const auto& finding : json["findings"]) {
    if (finding["what"].get<std::string>().starts_with(begin)) return finding["detail"];
  }
  return {};
}

/// Scans of a trot through a hall, to be written rightly or wrongly.
std::vector<Scan> trot_scans() {
  const Pose start{Eigen::Quaterniond::Identity(), {-2.0, 0.5, 0.5}};
  return take_scans(furnished_hall(), trotting(start, 0.6, 1.4), kCheckedScans);
}

/// Where the trot really was, `late` seconds before the stamps say so.
void write_truth(const std::filesystem::path& file, double late) {
  const Pose start{Eigen::Quaterniond::Identity(), {-2.0, 0.5, 0.5}};
  const MotionFunction motion = trotting(start, 0.6, 1.4);
  Trajectory truth;
  for (int i = 0; i < 120 * kCheckedScans / 10; ++i) {
    truth.push_back({std::int64_t{i} * 10'000'000, motion(0.01 * i + late)});
  }
  io::write_tum(file, truth);
}

TEST(Check, ASoundRecordingIsFit) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", trot_scans());
  write_truth(scratch.path() / "in" / "gt.tum", 0.0);
  const nlohmann::json json = check_json({"in"}, 0, scratch);
  EXPECT_TRUE(json["fit"]) << json;
  EXPECT_EQ(json["motion"]["preferred"], "as they are read") << json["motion"];
  EXPECT_TRUE(json["motion"]["decided"]) << json["motion"];
  EXPECT_EQ(json["motion"]["stamps"]["compared_with"], "gt.tum");
  EXPECT_NEAR(json["figures"]["rate_hz"].get<double>(), 10.0, 1e-9);
  const ProcessResult text = run_surefoot({"check", "in", "--no-motion"}, scratch.path());
  EXPECT_EQ(text.exit_code, 0) << text;
  EXPECT_NE(text.output.find("verdict      fit for a run\n"), std::string::npos) << text;
}

TEST(Check, OfFewScansItIsSaidThatTheMotionIsNotAsked) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(3));
  const ProcessResult text = run_surefoot({"check", "in"}, scratch.path());
  EXPECT_NE(text.output.find("the motion is not asked, of fewer than 10 scans"), std::string::npos)
      << text;
}

TEST(Check, ATruthMayLieBesideABagThatHasNoGyroscope) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", trot_scans());
  std::filesystem::create_directory(scratch.path() / "bag");
  const ProcessResult made = run_surefoot({"convert", "in", "bag/walk.mcap"}, scratch.path());
  ASSERT_EQ(made.exit_code, 0) << made;
  write_truth(scratch.path() / "bag" / "gt.tum", 0.0);
  const nlohmann::json json = check_json({"bag/walk.mcap"}, 0, scratch);
  EXPECT_EQ(json["motion"]["stamps"]["compared_with"], "gt.tum");
}

TEST(Check, ATruthThatCannotBeReadIsRefusedWhateverIsAskedOfIt) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(2));
  const ProcessResult result = run_surefoot({"check", "in", "--truth", "none.tum"}, scratch.path());
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(result.errors.find("none.tum"), std::string::npos) << result;
}

TEST(Check, TimesThatCountBackAreTold) {
  const ScratchFolder scratch;
  std::vector<Scan> scans = trot_scans();
  for (Scan& scan : scans) {
    for (std::int32_t& time : scan.times_ns) time = 100'000'000 - time;  // as ages, positive
    write_pcd_recording(scratch.path() / "in", scans);
  }
  const nlohmann::json json = check_json({"in"}, 1, scratch);
  EXPECT_NE(detail_of(json, "point times that the motion").find("--point-times backward"),
            std::string::npos)
      << json;
  // And as it says, it is well.
  const nlohmann::json mended = check_json({"in", "--point-times", "backward"}, 0, scratch);
  EXPECT_TRUE(mended["fit"]) << mended;
}

TEST(Check, RevolutionsWithoutTimesAreToldHowTheyTurned) {
  const ScratchFolder scratch;
  std::vector<Scan> scans = trot_scans();
  for (Scan& scan : scans) scan.times_ns.clear();
  write_pcd_recording(scratch.path() / "in", scans);
  const nlohmann::json json = check_json({"in"}, 1, scratch);
  EXPECT_NE(detail_of(json, "no point times").find("--derive-times azimuth"), std::string::npos)
      << json;
}

TEST(Check, StampsThatNameTheEndAreToldByTheTruth) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", trot_scans());
  write_truth(scratch.path() / "late.tum", 0.1);
  const nlohmann::json json = check_json({"in", "--truth", "late.tum"}, 0, scratch);
  EXPECT_EQ(json["motion"]["stamps"]["compared_with"], "late.tum");
  EXPECT_NEAR(json["motion"]["stamps"]["lag_s"].get<double>(), -0.1, 0.02) << json["motion"];
  EXPECT_NE(detail_of(json, "stamps that name the end").find("--stamp-at end"), std::string::npos)
      << json;
}

TEST(Check, DamageIsCountedAndNamed) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", trot_scans());
  write_content(scratch.path() / "in" / scan_name(3), "no scan");
  std::string times = file_content(scratch.path() / "in" / "times.txt");
  times.replace(times.find("1.000000000"), 11, "0.950000000");
  times.replace(times.find("1.100000000"), 11, "0.950000000");
  write_content(scratch.path() / "in" / "times.txt", times);
  const nlohmann::json json = check_json({"in", "--no-motion"}, 1, scratch);
  EXPECT_FALSE(json["fit"]);
  EXPECT_EQ(json["figures"]["unreadable"], 1);
  EXPECT_NE(json["findings"].dump().find(scan_name(3)), std::string::npos);
  EXPECT_FALSE(detail_of(json, "stamps that are the last one's again").empty()) << json;
}

TEST(Check, DrawsAPageThatEscapesNames) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(4));
  std::filesystem::rename(scratch.path() / "in" / scan_name(2),
                          scratch.path() / "in" / "000002<b>\n.pcd");
  write_content(scratch.path() / "in" / "000002<b>\n.pcd", "no scan");
  const ProcessResult result = run_surefoot({"check", "in", "--html", "page.html"}, scratch.path());
  EXPECT_EQ(result.exit_code, 1) << result;
  const std::string lines = "\n" + result.output;
  EXPECT_EQ(lines.find("\n.pcd"), std::string::npos) << result;
  const std::string page = file_content(scratch.path() / "page.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("</html>"), std::string::npos);
}

TEST(Check, APageReplacesNothingButItsOwn) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(4));
  const std::string scan = "in/" + scan_name(0);
  const std::string before = file_content(scratch.path() / scan);
  std::filesystem::create_symlink("/dev/null", scratch.path() / "null");
  const std::string other = "<!doctype html>\n<html lang=\"en\"><head></head></html>\n";
  write_content(scratch.path() / "other.html", other);
  for (const std::string& page : {scan, std::string("null"), std::string("other.html")}) {
    const ProcessResult result =
        run_surefoot({"check", "in", "--no-motion", "--html", page}, scratch.path());
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE(result.errors.find("is there already"), std::string::npos) << result;
  }
  const ProcessResult nowhere =
      run_surefoot({"check", "in", "--no-motion", "--html", "nowhere/page.html"}, scratch.path());
  EXPECT_EQ(nowhere.exit_code, 2) << nowhere;
  EXPECT_EQ(nowhere.output, "") << "said before the work";
  EXPECT_NE(nowhere.errors.find("there is no folder"), std::string::npos) << nowhere;
  EXPECT_TRUE(file_content(scratch.path() / scan) == before);
  EXPECT_EQ(file_content(scratch.path() / "other.html"), other);
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path() / "null"));
  for (int i = 0; i < 2; ++i) {
    const ProcessResult result =
        run_surefoot({"check", "in", "--no-motion", "--html", "page.html"}, scratch.path());
    EXPECT_NE(result.exit_code, 2) << result;
  }
}

TEST(Check, RefusesWhatIsNoRecording) {
  const ScratchFolder scratch;
  const ProcessResult result = run_surefoot({"check", "nothing"}, scratch.path());
  EXPECT_EQ(result.exit_code, 2) << result;
}

}  // namespace
}  // namespace surefoot::test
