// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot compare: tables that equal the files, nothing done twice, nothing taken along by what
// fails, nothing ranked that stopped early.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "compare_fixture.hpp"

namespace surefoot::test {
namespace {

constexpr std::size_t kThinFrom = 5;  // of the recording that one method loses

TEST_F(Compare, TablesFilesAndFiguresOfTwoByTwo) {
  const ProcessResult printed =
      compare({"left", "right", "--methods", "paper,paper+deskew.mode=none", "-o", "out"});
  ASSERT_EQ(printed.exit_code, 0) << printed;
  EXPECT_NE(printed.errors.find("4/4  right, paper+deskew.mode=none"), std::string::npos)
      << printed;
  const json all = results("out");
  ASSERT_TRUE(all.is_object()) << printed;
  const std::string markdown = content("out/tables.md"), csv = content("out/tables.csv"),
                    latex = content("out/tables.tex");
  EXPECT_EQ(printed.output.substr(0, markdown.size()), markdown);
  for (const char* sequence : {"left", "right"}) {
    for (const char* method : {"paper", "paper+deskew.mode=none"}) {
      const json one = result(all, sequence, method);
      EXPECT_EQ(one["outcome"], "whole") << one;
      const json rmse = cell(all, 0, sequence, "RMSE (m)", method);
      EXPECT_EQ(rmse["value"], one["evaluation"]["errors"]["ape_translation"]["rmse"]);
      EXPECT_LT(rmse["value"].get<double>(), 0.2);
      const std::string text = rmse["text"];
      const bool best = rmse["place"] == 1;
      EXPECT_NE(markdown.find(best ? "**" + text + "**" : "<u>" + text + "</u>"),
                std::string::npos);
      EXPECT_NE(latex.find((best ? "\\textbf{" : "\\underline{") + text + "}"), std::string::npos);
      EXPECT_NE(csv.find(std::string("Absolute pose error (APE),") + sequence + ",RMSE (m)," +
                         method + "," + rmse["value"].dump() + "," + text + ","),
                std::string::npos)
          << csv;
      EXPECT_GT(one["peak_memory_bytes"], 1'000'000);
      const std::string folder = "out/" + one["runs"][0]["folder"].get<std::string>();
      EXPECT_FALSE(content(folder + "/trajectory.tum").empty());
      EXPECT_FALSE(content(folder + "/map.ply").empty());
    }
  }
#ifdef SUREFOOT_HAS_PICTURES
  for (const char* figure :
       {"trajectories_3d", "trajectories_side", "trajectories_top", "errors_over_time"}) {
    const std::string name = std::string("out/figures/") + figure;
    EXPECT_NE(content(name + ".svg").find("<svg"), std::string::npos);
    EXPECT_EQ(content(name + ".pdf").substr(0, 4), "%PDF");
    EXPECT_EQ(content(name + ".png").substr(1, 3), "PNG");
  }
#endif
}

TEST_F(Compare, TheFiguresAreThoseOfEval) {
  ASSERT_EQ(compare({"left", "-o", "out", "--no-figures"}).exit_code, 0);
  const ProcessResult eval =
      run_surefoot({"eval", "left/gt.tum", "out/runs/left/paper/1/trajectory.tum", "--json",
                    "--delta", "0.5", "--delta-unit", "m", "--all-pairs", "--pairs-from-reference"},
                   scratch_.path());
  ASSERT_EQ(eval.exit_code, 0) << eval;
  json expected = json::parse(eval.output)[0];
  expected["estimate"] = "paper";
  EXPECT_EQ(result(results("out"), "left", "paper")["evaluation"], expected);
  EXPECT_FALSE(fs::exists(scratch_.path() / "out/figures"));
}

/// An earlier comparison's may go; what is somebody else's is told before all the work.
TEST_F(Compare, WritesOverNothingThatNoComparisonHasLeft) {
  const std::vector<std::string> command = {"left", "--methods", "icp",
                                            "-o",   "out",       "--no-figures"};
  fs::create_directories(scratch_.path() / "out/figures");
  for (const char* name : {"out/tables.md", "out/compare.json", "out/figures/ablation.png"}) {
    write_content(scratch_.path() / name, "{\"mine\": 1}");
    const ProcessResult refused = compare(command);
    EXPECT_EQ(refused.exit_code, 2) << refused;
    EXPECT_NE(refused.errors.find("which no comparison has left"), std::string::npos) << refused;
    EXPECT_EQ(content(name), "{\"mine\": 1}");
    EXPECT_FALSE(fs::exists(scratch_.path() / "out/runs"));
    fs::remove(scratch_.path() / name);
  }
  write_content(scratch_.path() / "out/tables.md", "mine");
  std::vector<std::string> over = command;
  over.emplace_back("--overwrite");
  EXPECT_EQ(compare(over).exit_code, 0);
  EXPECT_NE(content("out/tables.md"), "mine");
  EXPECT_EQ(compare(command).exit_code, 0) << "its own";
}

TEST_F(Compare, WhatIsDoneIsNotDoneAgain) {
  const std::vector<std::string> command = {"left", "--methods", "paper",
                                            "-o",   "out",       "--no-figures"};
  ASSERT_EQ(compare(command).exit_code, 0);
  const std::string first = content("out/compare.json");
  const auto before = times("out/runs");
  const ProcessResult again = compare(command);
  EXPECT_EQ(again.exit_code, 0) << again;
  EXPECT_NE(again.errors.find("1 done before"), std::string::npos) << again;
  EXPECT_EQ(times("out/runs"), before);
  EXPECT_EQ(content("out/compare.json"), first);
  for (const char* file : {"trajectory.tum", "scans.csv"}) {
    fs::remove(scratch_.path() / "out/runs/left/paper/1" / file);
    const ProcessResult gone = compare(command);
    EXPECT_EQ(gone.exit_code, 0) << gone;
    EXPECT_NE(gone.errors.find("0 done before"), std::string::npos) << file << '\n' << gone;
  }
  // Another parameter, a changed recording: done anew.
  const ProcessResult other =
      compare({"left", "-o", "out", "--no-figures", "--set", "map.radius=50"});
  EXPECT_NE(other.errors.find("0 done before"), std::string::npos) << other;
  EXPECT_NE(times("out/runs"), before);
  const fs::path scan = scratch_.path() / "left" / scan_name(3);
  fs::last_write_time(scan, fs::last_write_time(scan) + std::chrono::seconds(5));
  const ProcessResult touched =
      compare({"left", "-o", "out", "--no-figures", "--set", "map.radius=50"});
  EXPECT_NE(touched.errors.find("0 done before"), std::string::npos) << touched;
}

// A second recording that is far longer than the test waits for.
TEST_F(Compare, CtrlCKeepsWhatIsDone) {
  const fs::path endless = scratch_.path() / "very_long";
  write_pcd_recording(endless, hall_scans(1));
  for (std::size_t i = 1; i < 20'000; ++i) {
    fs::create_hard_link(endless / scan_name(0), endless / scan_name(i));
  }
  fs::remove(endless / "times.txt");
  fs::copy_file(scratch_.path() / "left/gt.tum", endless / "gt.tum");
  const std::vector<std::string> rest = {"--methods", "paper", "--delta",         "0.5",
                                         "-o",        "out",   "--pass=--rate=10"};
  std::vector<std::string> both = {"compare", "left", "very_long"}, left = {"compare", "left"};
  both.insert(both.end(), rest.begin(), rest.end());
  left.insert(left.end(), rest.begin(), rest.end());
  const Process process(both, scratch_.path());
  const fs::path running = scratch_.path() / "out/runs/very_long/paper/1";
  for (int i = 0; i < 3000 && file_content(running / "scans.csv").size() < 2000; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  process.send(SIGINT);
  const ProcessResult stopped = process.wait();
  EXPECT_EQ(stopped.exit_code, 130) << stopped;
  EXPECT_NE(stopped.errors.find("1 of 2 runs"), std::string::npos) << stopped;
  EXPECT_NE(stopped.errors.find("the same command again goes on"), std::string::npos) << stopped;
  EXPECT_FALSE(fs::exists(running / "compare_run.json"));
  EXPECT_FALSE(fs::exists(scratch_.path() / "out/compare.json"));
  EXPECT_EQ(content("out/runs/very_long/paper/1/trajectory.tum").back(), '\n');
  const ProcessResult again = run_surefoot(left, scratch_.path());
  EXPECT_NE(again.errors.find("1 done before"), std::string::npos) << again;
}

TEST_F(Compare, AFailureTakesNothingAlong) {
  fs::create_directory(scratch_.path() / "broken");
  write_content(scratch_.path() / "broken" / scan_name(0), "no point cloud");
  fs::copy_file(scratch_.path() / "left/gt.tum", scratch_.path() / "broken/gt.tum");
  fs::copy(scratch_.path() / "left", scratch_.path() / "no_truth");
  fs::remove(scratch_.path() / "no_truth/gt.tum");
  const ProcessResult printed =
      compare({"broken", "no_truth", "left", "--methods", "paper", "-o", "out"});
  EXPECT_EQ(printed.exit_code, 1) << printed;
  const json all = results("out");
  for (const char* recording : {"broken", "no_truth"}) {
    const json failed = result(all, recording, "paper");
    EXPECT_EQ(failed["outcome"], "failed");
    EXPECT_EQ(failed["ranked"], false);
    EXPECT_EQ(cell(all, 0, recording, "Maximum (m)", "paper")["text"], "failed");
  }
  EXPECT_EQ(result(all, "broken", "paper")["runs"][0]["exit_code"], 2);
  EXPECT_NE(printed.output.find("broken, paper: ended with exit code 2"), std::string::npos);
  EXPECT_NE(printed.output.find("no_truth, paper:"), std::string::npos) << printed;
  EXPECT_NE(printed.output.find("gt.tum"), std::string::npos) << printed;
  EXPECT_EQ(result(all, "left", "paper")["outcome"], "whole");
  // Failures are kept, too, unless they are to be tried again.
  EXPECT_NE(
      compare({"broken", "left", "--methods", "paper", "-o", "out"}).errors.find("2 done before"),
      std::string::npos);
  EXPECT_NE(compare({"broken", "left", "--methods", "paper", "-o", "out", "--retry-failed"})
                .errors.find("1 done before"),
            std::string::npos);
}

// One method refuses the thin scans at the end: its error over the rest is no error of the run.
TEST_F(Compare, WhatStopsEarlyIsNotRanked) {
  write_bend_recording(scratch_.path() / "thin", 0.6, kScans, kThinFrom);
  const std::string choosy = "paper+preprocess.min_points=2000";
  const ProcessResult printed =
      compare({"thin", "--methods", choosy + ",paper", "-o", "out", "--no-figures"});
  EXPECT_EQ(printed.exit_code, 0) << printed;
  const json all = results("out");
  const json stopped = result(all, "thin", choosy);
  EXPECT_EQ(stopped["outcome"], "stopped") << printed;
  EXPECT_EQ(stopped["outcome_text"], "stopped at 36 %");
  EXPECT_EQ(stopped["runs"][0]["statuses"]["rejected"], kScans - kThinFrom);
  EXPECT_EQ(cell(all, 0, "thin", "Maximum (m)", choosy)["text"], "stopped at 36 %");
  for (const char* figure : {"Maximum (m)", "Mean (m)", "RMSE (m)", "std (m)"}) {
    EXPECT_TRUE(cell(all, 0, "thin", figure, choosy)["value"].is_null());
    EXPECT_EQ(cell(all, 0, "thin", figure, "paper")["place"], 1);
  }
  EXPECT_TRUE(cell(all, 2, "thin", "Time a scan, median (ms)", choosy)["place"].is_null());
}

TEST_F(Compare, SideBySideEqualsOneAfterTheOther) {
  const std::vector<std::string> command = {"left",     "right", "--methods",    "paper,paper-cv",
                                            "--repeat", "2",     "--no-figures", "-o"};
  std::vector<std::string> alone = command, together = command;
  alone.push_back("alone");
  together.insert(together.end(), {"together", "-j", "2"});
  const ProcessResult one = compare(alone), two = compare(together);
  EXPECT_EQ(one.exit_code, 0) << one;
  EXPECT_EQ(two.exit_code, 0) << two;
  EXPECT_EQ(errors_of(results("alone")), errors_of(results("together")));
  EXPECT_EQ(result(results("alone"), "left", "paper")["repeats_agree"], true);
  EXPECT_NE(one.output.find("2 repeats each: all trajectories are the same"), std::string::npos);
  EXPECT_EQ(one.output.find("shared the machine"), std::string::npos) << one;
  EXPECT_NE(two.output.find("2 runs shared the machine"), std::string::npos) << two;
}

TEST_F(Compare, RepeatsThatDifferAreTold) {
  const std::vector<std::string> command = {"left", "--repeat", "2", "-o", "out", "--no-figures"};
  ASSERT_EQ(compare(command).exit_code, 0);
  const fs::path second = scratch_.path() / "out/runs/left/paper/2/trajectory.tum";
  write_content(second, file_content(second) + "# changed\n");
  const ProcessResult printed = compare(command);
  EXPECT_EQ(printed.exit_code, 1) << printed;
  EXPECT_NE(printed.output.find("left, paper: THE REPEATS' TRAJECTORIES DIFFER"), std::string::npos)
      << printed;
  EXPECT_EQ(result(results("out"), "left", "paper")["repeats_agree"], false);
}

// What compare says itself would be another thing in the run than in compare.json.
TEST_F(Compare, WhatComparisonsSayThemselvesIsNotPassed) {
  for (const char* flag :
       {"--set=map.radius=50", "--set", "--config=x.yaml", "--method=icp", "--count=5", "--start=1",
        "--stride=2", "--threads=2", "-o", "-oelsewhere", "--output=elsewhere", "--no-map", "-q"}) {
    const ProcessResult refused =
        compare({"left", "-o", "out", std::string("--pass=") + flag, "--no-figures"});
    EXPECT_EQ(refused.exit_code, 2) << refused;
    EXPECT_NE(refused.errors.find(std::string("--pass=") + flag), std::string::npos) << refused;
    EXPECT_FALSE(fs::exists(scratch_.path() / "out")) << refused;
  }
}

TEST_F(Compare, ASuiteIsAFolderOfRecordings) {
  const ProcessResult printed = compare({"--suite", ".", "-o", "out", "--no-figures", "-q"});
  EXPECT_EQ(printed.exit_code, 0) << printed;
  EXPECT_TRUE(printed.errors.empty()) << printed;
  EXPECT_EQ(results("out")["recordings"].size(), 2U);
}

TEST_F(Compare, SeedsOfASceneAreSummedUp) {
  for (const char* seed : {"left", "right"}) {
    const json scene = {{"scene", {{"name", "hall"}}},
                        {"robot", {{"name", "glide"}}},
                        {"lidar", {{"name", "vlp16"}}},
                        {"seed", seed},
                        {"scans", 12},
                        {"gait_scale", 1.0},
                        {"mount", "none"},
                        {"rays_per_beam", 1},
                        {"dual_return", false},
                        {"robot_body_in_view", false}};
    write_content(scratch_.path() / seed / "scene.json", scene.dump());
    fs::create_directory(scratch_.path() / (std::string("suite_of_") + seed));
    fs::rename(scratch_.path() / seed,
               scratch_.path() / (std::string("suite_of_") + seed) / "hall-glide");
  }
  const ProcessResult printed =
      compare({"--methods", "paper,paper+deskew.mode=none", "-o", "out", "--no-figures", "--suite",
               "suite_of_left", "suite_of_right"});
  ASSERT_EQ(printed.exit_code, 0) << printed;
  const json all = results("out");
  ASSERT_EQ(all["scenes"].size(), 1U) << printed;
  EXPECT_EQ(all["scenes"][0]["recordings"],
            (json{"suite_of_left-hall-glide", "suite_of_right-hall-glide"}));
  const auto rmse = [&](const char* recording) {
    return result(all, recording, "paper")["evaluation"]["errors"]["ape_translation"]["rmse"]
        .get<double>();
  };
  const double left = rmse("suite_of_left-hall-glide"), right = rmse("suite_of_right-hall-glide");
  const json spread = all["scenes"][0]["results"][0]["ape_rmse_m"];
  EXPECT_DOUBLE_EQ(spread["median"], 0.5 * (left + right));
  EXPECT_EQ(spread["min"], std::min(left, right));
  EXPECT_EQ(spread["max"], std::max(left, right));
  EXPECT_EQ(cell(all, 0, "hall-glide (2 seeds)", "APE, RMSE (m)", "paper")["value"],
            spread["median"]);
  EXPECT_NE(printed.output.find("## Over the seeds of a scene"), std::string::npos) << printed;
}

TEST_F(Compare, ForeignFilesAreNeverRemoved) {
  const fs::path file = scratch_.path() / "out/runs/left/paper/1/thesis.tex";
  fs::create_directories(file.parent_path());
  write_content(file, "years of work");
  const ProcessResult printed = compare({"left", "-o", "out"});
  EXPECT_EQ(printed.exit_code, 2) << printed;
  EXPECT_EQ(file_content(file), "years of work");
}

}  // namespace
}  // namespace surefoot::test
