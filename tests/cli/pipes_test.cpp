// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Recordings and trajectories that come through a pipe.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "capture.hpp"
#include "io/bags/bag_writer.hpp"
#include "io/messages/point_cloud2_writer.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

/// A folder with a capture and a place for temporary files, in which a shell is asked.
class Pipes : public testing::Test {
 protected:
  Pipes() {
    write_content(folder() / "walk.pcap", pcap_file(vlp16_packets(4)));
    fs::create_directory(folder() / "tmp");
  }
  [[nodiscard]] const fs::path& folder() const { return scratch_.path(); }
  [[nodiscard]] static std::vector<std::string> words(const std::string& line) {
    return {"-c", "export TMPDIR=$PWD/tmp; surefoot() { " SUREFOOT_PROGRAM " \"$@\"; }; " + line};
  }
  [[nodiscard]] static Surroundings in_bash(std::uint64_t most_bytes = UINT64_MAX) {
    return {.program = "bash", .most_file_bytes = most_bytes, .most_seconds = 30};
  }
  [[nodiscard]] ProcessResult shell(const std::string& line) const {
    return run_surefoot(words(line), folder(), in_bash());
  }
  [[nodiscard]] std::string path_of(const std::string& run) const {
    return file_content(folder() / run / "trajectory.tum");
  }

 private:
  ScratchFolder scratch_;
};

TEST_F(Pipes, ARunIsThatOfTheFile) {
  ASSERT_EQ(shell("surefoot run walk.pcap -o whole").exit_code, 0);
  ASSERT_FALSE(path_of("whole").empty());
  ASSERT_EQ(shell("gzip walk.pcap").exit_code, 0);
  const std::string lines[] = {"zcat walk.pcap.gz | surefoot run /dev/stdin -o a",
                               "cat walk.pcap.gz | surefoot run /dev/stdin -o b",
                               "surefoot run <(zcat walk.pcap.gz) -o c",
                               "mkfifo p; zcat walk.pcap.gz >p & surefoot run /dev/stdin <p -o d",
                               "surefoot run walk.pcap.gz -o e"};
  for (const std::string& line : lines) {
    const ProcessResult result = shell(line);
    EXPECT_EQ(result.exit_code, 0) << line << '\n' << result;
    const bool is_pipe = line.find("run walk") == std::string::npos;
    EXPECT_EQ(result.errors.find("is a pipe: its ") != std::string::npos, is_pipe) << result;
    EXPECT_EQ(path_of(line.substr(line.size() - 1)), path_of("whole")) << line;
  }
  EXPECT_TRUE(fs::is_empty(folder() / "tmp"));
}

// Databases are looked for by their names, which a nameless file has none of.
TEST_F(Pipes, BagsOfEveryKind) {
  for (const bool database : {false, true}) {
    const auto bag =
        database ? io::make_sqlite_bag(folder() / "bag") : io::make_ros1_bag(folder() / "bag.bag");
    const std::size_t topic = bag->add_topic("/points", io::point_cloud2_definition());
    for (const Scan& scan : hall_scans(3)) {
      bag->write(topic, scan.stamp_ns, io::format_point_cloud2(scan, "lidar", bag->flavour()));
    }
    bag->finish();
    const ProcessResult result =
        shell(std::string("cat ") + (database ? "bag/*.db3" : "bag.bag") +
              " | surefoot convert /dev/stdin " + (database ? "a.mcap" : "b.mcap"));
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_NE(result.output.find("3 scans"), std::string::npos) << result;
  }
  EXPECT_TRUE(fs::is_empty(folder() / "tmp"));
}

TEST_F(Pipes, WhatIsNoRecordingIsRefusedByItsFirstBytes) {
  for (const char* const line :
       {"surefoot run <(yes)", "yes | surefoot info /dev/stdin", ": | surefoot check /dev/stdin",
        "surefoot eval <(cat walk.pcap) walk.pcap"}) {
    const ProcessResult result = run_surefoot(words(line), folder(), in_bash(10'000'000));
    EXPECT_EQ(result.exit_code, 2) << line << '\n' << result;
    EXPECT_NE(result.errors.find("the pipe"), std::string::npos) << result;
    EXPECT_NE(result.errors.find("/dev/"), std::string::npos) << result;
  }
}

TEST_F(Pipes, AFullDiskIsSaid) {
  const std::string line = "cat walk.pcap | surefoot run /dev/stdin";
  const ProcessResult result = run_surefoot(words(line), folder(), in_bash(100'000));
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(result.errors.find("has no room in"), std::string::npos) << result;
  EXPECT_NE(result.errors.find("TMPDIR"), std::string::npos) << result;
}

/// Whether a process has a file open there that has no name (any longer).
bool holds_a_nameless_file_in(pid_t process, const fs::path& folder) {
  std::error_code ended;
  for (const auto& open :
       fs::directory_iterator("/proc/" + std::to_string(process) + "/fd", ended)) {
    std::error_code ignored;
    const std::string file = fs::read_symlink(open.path(), ignored).string();
    if (file.starts_with(folder.native()) && file.ends_with(" (deleted)")) return true;
  }
  return false;
}

// Nobody can put things away after a SIGKILL.
TEST_F(Pipes, NothingStaysOfAProgramThatIsKilled) {
  const std::string line =
      "exec " SUREFOOT_PROGRAM " run /dev/fd/3 3< <(cat walk.pcap; exec sleep 5)";
  for (const int signal : {SIGINT, SIGKILL}) {
    const Process program(words(line), folder(), in_bash());
    for (int tries = 0; tries < 400 && !holds_a_nameless_file_in(program.id(), folder() / "tmp");
         ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_TRUE(holds_a_nameless_file_in(program.id(), folder() / "tmp"));
    program.send(signal);
    EXPECT_EQ(program.wait().signal, signal);
    EXPECT_TRUE(fs::is_empty(folder() / "tmp"));
  }
}

TEST_F(Pipes, TrajectoriesAreEvaluated) {
  write_content(folder() / "path.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 2 0 1 0 0 0 1\n");
  const ProcessResult result = shell("surefoot eval <(cat path.tum) <(cat path.tum) --csv");
  EXPECT_EQ(result.exit_code, 0) << result;
  const ProcessResult whole = shell("cp path.tum 63; cp path.tum 62; surefoot eval 63 62 --csv");
  EXPECT_EQ(result.output, whole.output);
}

TEST_F(Pipes, TruthsOfACheckAndOfAReport) {
  ASSERT_EQ(shell("surefoot run walk.pcap -o run").exit_code, 0);
  const std::string truth = "run/trajectory.tum";
  const ProcessResult piped = shell("surefoot check walk.pcap --truth <(cat " + truth + ")");
  EXPECT_EQ(piped.output, shell("surefoot check walk.pcap --truth " + truth).output) << piped;
  EXPECT_FALSE(piped.output.empty());
  EXPECT_EQ(piped.errors.find("surefoot:"), std::string::npos) << piped;
  const ProcessResult report = shell("surefoot report run --truth <(cat " + truth + ")");
  EXPECT_EQ(report.exit_code, 0) << report;
  for (const char* const line : {"surefoot report run", "surefoot check walk.pcap"}) {
    const ProcessResult binary = shell(line + std::string(" --truth <(cat walk.pcap)"));
    EXPECT_EQ(binary.exit_code, 2) << binary;
    EXPECT_NE(binary.errors.find("what comes through the pipe is no text"), std::string::npos);
  }
}

}  // namespace
}  // namespace surefoot::test
