// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot run on every format that is read: the same points give the same trajectory, to the byte.
#include <gtest/gtest.h>

#include <algorithm>

#include "capture.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

constexpr int kWrittenScans = 5;

struct ScanFormat {
  const char* name;
  const char* extension;
  bool point_times;  ///< whether the format holds the points' times
  std::string (*bytes)(const Scan& scan);
};

void PrintTo(const ScanFormat& format, std::ostream* out) { *out << format.name; }

std::string ply(const Scan& scan, io::PlyFlavour flavour) {
  return io::format_ply(scan.points, scan.intensities, flavour);
}

const ScanFormat kFormats[] = {
    {"pcd_ascii", ".pcd", true,
     [](const Scan& scan) { return io::format_pcd(scan, io::PcdData::ascii); }},
    {"pcd_binary", ".pcd", true,
     [](const Scan& scan) { return io::format_pcd(scan, io::PcdData::binary); }},
    {"pcd_compressed", ".pcd", true,
     [](const Scan& scan) { return io::format_pcd(scan, io::PcdData::binary_compressed); }},
    {"ply_ascii", ".ply", false, [](const Scan& scan) { return ply(scan, io::PlyFlavour::ascii); }},
    {"ply_little", ".ply", false,
     [](const Scan& scan) { return ply(scan, io::PlyFlavour::binary); }},
    {"ply_big", ".ply", false, big_endian_ply},
    {"kitti", ".bin", false, kitti_bin},
};

class Format : public testing::TestWithParam<ScanFormat> {};

TEST_P(Format, SameTrajectoryAsBinaryPcd) {
  const ScratchFolder scratch;
  const fs::path input = scratch.path() / "in";
  fs::create_directory(input);
  std::vector<Scan> scans = hall_scans(kWrittenScans);
  std::string times;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (!GetParam().point_times) scans[i].times_ns.clear();
    write_content((input / scan_name(i)).replace_extension(GetParam().extension),
                  GetParam().bytes(scans[i]));
    times += stamp_line(scans[i]);
  }
  write_content(input / "times.txt", times);
  write_pcd_recording(scratch.path() / "pcd", scans);

  const ProcessResult expected = run_surefoot({"run", "pcd", "-o", "expected"}, scratch.path());
  ASSERT_EQ(expected.exit_code, 0) << expected;
  const ProcessResult result = run_surefoot({"run", "in", "-o", "out"}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(file_content(scratch.path() / "out" / "trajectory.tum"),
            file_content(scratch.path() / "expected" / "trajectory.tum"))
      << result;
  EXPECT_EQ(io::read_tum(scratch.path() / "out" / "trajectory.tum").size(), scans.size());
}

INSTANTIATE_TEST_SUITE_P(All, Format, testing::ValuesIn(kFormats),
                         [](const auto& instance) { return std::string(instance.param.name); });

// That equal trajectories are not all equally wrong. The first motion of all is found late: over
// the first scans the path falls 0.12 m back, which the bound allows for.
TEST(Output, AGlideIsFollowed) {
  constexpr int kLongGlide = 15;
  const ScratchFolder scratch;
  const std::vector<Scan> scans = hall_scans(kLongGlide);
  write_pcd_recording(scratch.path() / "in", scans);
  const ProcessResult result = run_surefoot({"run", "in", "-o", "out"}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  const Trajectory found = io::read_tum(scratch.path() / "out" / "trajectory.tum");
  ASSERT_EQ(found.size(), scans.size()) << result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double seconds = 1e-9 * static_cast<double>(scans[i].stamp_ns - scans[0].stamp_ns);
    const Eigen::Vector3d& position = found[i].pose.translation;
    EXPECT_NEAR(position.x(), kGlideSpeed * seconds, 0.15) << "scan " << i;
    EXPECT_NEAR(position.y(), 0.0, 0.03) << "scan " << i;
    EXPECT_NEAR(position.z(), 0.0, 0.03) << "scan " << i;
  }
}

class CaptureFormat : public testing::TestWithParam<const char*> {};

TEST_P(CaptureFormat, StandingSensorStays) {
  const ScratchFolder scratch;
  const std::string name = std::string("walk.") + GetParam();
  std::vector<std::string> packets = vlp16_packets(4);
  packets.pop_back();  // it holds 3 degrees of a fifth revolution, which do not fix a pose
  write_content(scratch.path() / name,
                name == "walk.pcap" ? pcap_file(packets) : pcapng_file(packets));
  const ProcessResult result = run_surefoot({"run", name, "-o", "out"}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  const Trajectory found = io::read_tum(scratch.path() / "out" / "trajectory.tum");
  ASSERT_GE(found.size(), 4U) << result;
  for (const StampedPose& stamped : found) {
    EXPECT_LT(stamped.pose.translation.norm(), 0.02) << result;
  }
}

INSTANTIATE_TEST_SUITE_P(All, CaptureFormat, testing::Values("pcap", "pcapng"),
                         [](const auto& instance) { return std::string(instance.param); });

// What a capture begins with is hardly ever a whole revolution.
TEST(Capture, PartOfARevolutionAtTheStartIsLeftOut) {
  const ScratchFolder scratch;
  std::vector<std::string> packets = vlp16_packets(5);
  packets.erase(packets.begin(), packets.begin() + 40);
  write_content(scratch.path() / "walk.pcap", pcap_file(packets));
  const ProcessResult result = run_surefoot({"run", "walk.pcap", "-o", "out"}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  const std::string remark = "left out: revolution 0: partial revolution: firings over 16";
  EXPECT_NE(result.errors.find(remark), std::string::npos) << result;
  EXPECT_NE(result.output.find("1 partial, left out"), std::string::npos) << result;
  EXPECT_NE(file_content(scratch.path() / "out" / "run.yaml").find(remark), std::string::npos);
  const std::string csv = file_content(scratch.path() / "out" / "scans.csv");
  EXPECT_EQ(csv.find("\"revolution 0\""), std::string::npos) << csv;
  EXPECT_NE(csv.find("0,\"revolution 1\""), std::string::npos) << csv;
  EXPECT_NE(csv.find("\"revolution 4\""), std::string::npos) << csv;
}

TEST(Capture, ItsPointsElsewhereGiveTheSameRun) {
  const ScratchFolder scratch;
  std::vector<std::string> packets = vlp16_packets(5);
  packets.erase(packets.begin(), packets.begin() + 65);
  write_content(scratch.path() / "walk.pcap", pcap_file(packets));
  ASSERT_EQ(run_surefoot({"run", "walk.pcap", "-o", "expected"}, scratch.path()).exit_code, 0);
  for (const std::string name : {"walk.mcap", "walk"}) {
    const ProcessResult converted = run_surefoot({"convert", "walk.pcap", name}, scratch.path());
    ASSERT_EQ(converted.exit_code, 0) << converted;
    EXPECT_NE(converted.errors.find("left out: revolution 0: partial revolution"),
              std::string::npos)
        << converted;
    const ProcessResult result = run_surefoot({"run", name, "-o", name + "-out"}, scratch.path());
    ASSERT_EQ(result.exit_code, 0) << result;
    for (const char* file : {"trajectory.tum", "map.ply"}) {
      EXPECT_TRUE(file_content(scratch.path() / (name + "-out") / file) ==
                  file_content(scratch.path() / "expected" / file))
          << name << ' ' << file << result;
    }
  }
}

TEST(Capture, PartOfARevolutionThatIsAllThereIsIsUsed) {
  const ScratchFolder scratch;
  std::vector<std::string> packets = vlp16_packets(1);
  packets.resize(50);
  write_content(scratch.path() / "walk.pcap", pcap_file(packets));
  const ProcessResult result = run_surefoot({"run", "walk.pcap", "-o", "out"}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(result.errors.find("left out"), std::string::npos) << result;
  EXPECT_EQ(io::read_tum(scratch.path() / "out" / "trajectory.tum").size(), 1U) << result;
}

TEST(Output, StampsAreMidScanExactly) {
  const ScratchFolder scratch;
  std::vector<Scan> scans = hall_scans(3);
  for (Scan& scan : scans) scan.stamp_ns += 1'700'000'000'123'456'789;
  write_pcd_recording(scratch.path() / "in", scans);
  const ProcessResult result = run_surefoot({"run", "in", "-o", "out"}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  const Trajectory found = io::read_tum(scratch.path() / "out" / "trajectory.tum");
  ASSERT_EQ(found.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const auto [first, last] =
        std::minmax_element(scans[i].times_ns.begin(), scans[i].times_ns.end());
    EXPECT_EQ(found[i].stamp_ns, scans[i].stamp_ns + *first + (*last - *first) / 2);
  }
}

TEST(Output, EveryFileIsThere) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(3));
  const ProcessResult result = run_surefoot({"run", "in", "-o", "out"}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  for (const char* name : {"trajectory.tum", "trajectory_kitti.txt", "map.ply", "scans.csv",
                           "run.yaml", "picture.png"}) {
    EXPECT_FALSE(file_content(scratch.path() / "out" / name).empty()) << name;
  }
}

}  // namespace
}  // namespace surefoot::test
