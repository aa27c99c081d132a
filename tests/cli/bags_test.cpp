// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot convert, and bags in and out of the other commands: the same scans through every
// container give the same trajectory, to the byte.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "capture.hpp"
#include "io/bags/bag_files.hpp"
#include "io/bags/bag_writer.hpp"
#include "io/bags/compression.hpp"
#include "io/file_writer.hpp"
#include "io/messages/point_cloud2_writer.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

constexpr int kBagScans = 5;

void compress_file(const fs::path& from, const fs::path& to) {
  fs::create_directories(to.parent_path());
  write_content(to, io::compress(io::Compression::zstd, file_content(from)));
}

TEST(Bags, EveryContainerGivesTheTrajectoryOfThePcdFiles) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(kBagScans));
  const ProcessResult reference =
      run_surefoot({"run", "pcd", "-o", "expected", "--no-report"}, folder);
  ASSERT_EQ(reference.exit_code, 0) << reference;
  const std::string expected = file_content(folder / "expected" / "trajectory.tum");

  for (const std::vector<std::string>& to :
       {std::vector<std::string>{"a.mcap"}, {"a.bag"}, {"bag2", "--to", "rosbag2"}}) {
    std::vector<std::string> arguments = {"convert", "pcd"};
    arguments.insert(arguments.end(), to.begin(), to.end());
    const ProcessResult result = run_surefoot(arguments, folder);
    ASSERT_EQ(result.exit_code, 0) << result;
    EXPECT_EQ(result.errors.find("lost:"), std::string::npos) << result;
  }
  compress_file(folder / "a.mcap", folder / "z" / "a.mcap.zstd");
  compress_file(folder / "bag2" / "bag2_0.db3", folder / "zdb" / "bag2_0.db3.zstd");
  for (const char* input : {"a.mcap", "a.bag", "bag2", "bag2/bag2_0.db3", "z/a.mcap.zstd", "zdb"}) {
    fs::remove_all(folder / "out");
    const ProcessResult result = run_surefoot({"run", input, "-o", "out", "--no-report"}, folder);
    ASSERT_EQ(result.exit_code, 0) << input << result;
    EXPECT_EQ(file_content(folder / "out" / "trajectory.tum"), expected) << input;
    const ProcessResult info = run_surefoot({"info", input}, folder);
    EXPECT_EQ(info.exit_code, 0) << info;
    EXPECT_NE(info.output.find("topic /points (sensor_msgs/PointCloud2)"), std::string::npos)
        << info;
  }
}

TEST(Convert, ThereAndBackIsTheSame) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(kBagScans));
  ASSERT_EQ(run_surefoot({"convert", "pcd", "first"}, folder).exit_code, 0);
  ASSERT_EQ(run_surefoot({"convert", "first", "a.mcap"}, folder).exit_code, 0);
  ASSERT_EQ(run_surefoot({"convert", "a.mcap", "a.bag"}, folder).exit_code, 0);
  ASSERT_EQ(run_surefoot({"convert", "a.bag", "second"}, folder).exit_code, 0);
  for (const char* name : {"000000.pcd", "000004.pcd", "times.txt"}) {
    EXPECT_FALSE(file_content(folder / "first" / name).empty()) << name;
    EXPECT_EQ(file_content(folder / "second" / name), file_content(folder / "first" / name))
        << name;
  }
}

TEST(Convert, PartsOfARecordingAndWhatIsLost) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(kBagScans));
  const ProcessResult every =
      run_surefoot({"convert", "pcd", "a", "--stride", "2", "--to", "bin"}, folder);
  EXPECT_EQ(every.exit_code, 0) << every;
  EXPECT_NE(every.output.find("3 scans"), std::string::npos) << every;
  EXPECT_NE(every.errors.find("lost: fields that are not written to it: ring, t\n"),
            std::string::npos)
      << every;
  const ProcessResult range = run_surefoot(
      {"convert", "pcd", "b", "--begin", "0.05", "--end", "0.25", "--to", "ply"}, folder);
  EXPECT_NE(range.output.find("2 scans"), std::string::npos) << range;
  EXPECT_NE(run_surefoot({"convert", "pcd", "c", "--begin", "99"}, folder).errors.find("no scan"),
            std::string::npos);
}

TEST(Convert, OneWildStampIsNotTheEnd) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(4));
  write_content(folder / "pcd" / "times.txt", "1.0\n1.1\n99.0\n1.3\n");
  const ProcessResult result =
      run_surefoot({"convert", "pcd", "a.mcap", "--no-repair-stamps", "--end", "5"}, folder);
  EXPECT_NE(result.output.find("3 scans"), std::string::npos) << result;
}

TEST(Convert, RefusesWhatIsThereAlreadyAndOtherNames) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(1));
  for (const char* output : {"pcd", "x.e57", "x.db3", "x.pcap"}) {
    const ProcessResult result = run_surefoot({"convert", "pcd", output}, folder);
    EXPECT_EQ(result.exit_code, 2) << result;
  }
}

TEST(Convert, LeavesNoHalfOutputAndTakesNobodyElses) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(kBagScans));
  for (const std::string format : {"mcap", "bag", "rosbag2", "pcd"}) {
    const std::string output = format == "mcap" || format == "bag" ? "a." + format : format + "_";
    const std::vector<std::string> arguments{"convert", "pcd", output, "--to", format, "-q"};
    const ProcessResult full =
        run_surefoot(arguments, folder, {.program = {}, .most_file_bytes = 3000});
    EXPECT_EQ(full.exit_code, 2) << full;
    EXPECT_FALSE(fs::exists(folder / output)) << output;
    EXPECT_FALSE(fs::exists(folder / (output + io::kUnfinished))) << output;
    const ProcessResult again = run_surefoot(arguments, folder);
    EXPECT_EQ(again.exit_code, 0) << again;
    EXPECT_TRUE(fs::exists(folder / output)) << output;
    EXPECT_FALSE(fs::exists(folder / (output + io::kUnfinished))) << output;
  }
  EXPECT_TRUE(fs::exists(folder / "rosbag2_" / "rosbag2__0.db3"));
}

TEST(Convert, TakesOverWhatAKilledOneLeftAndNothingElse) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(kBagScans));
  write_content(folder / "b.mcap.part", "another's");
  for (const std::string output : {"b.mcap", "folder"}) {
    const fs::path part = folder / (output + io::kUnfinished);
    const bool is_folder = output == "folder";
    if (is_folder) fs::create_directories(part);
    write_content(is_folder ? part / "999999.pcd" : part, std::string(1'000'000, 'x'));

    const int other = open(part.c_str(), O_RDONLY);
    ASSERT_EQ(flock(other, LOCK_EX | LOCK_NB), 0);
    const ProcessResult meanwhile = run_surefoot({"convert", "pcd", output}, folder);
    EXPECT_EQ(meanwhile.exit_code, 2) << meanwhile;
    EXPECT_NE(meanwhile.errors.find("another program writes it"), std::string::npos) << meanwhile;
    EXPECT_TRUE(fs::exists(part));
    close(other);

    const ProcessResult after = run_surefoot({"convert", "pcd", output}, folder);
    EXPECT_EQ(after.exit_code, 0) << after;
    EXPECT_FALSE(fs::exists(part));
    EXPECT_FALSE(fs::exists(folder / output / "999999.pcd"));
    const ProcessResult read = run_surefoot({"info", output}, folder);
    EXPECT_EQ(read.exit_code, 0) << read;
  }
  EXPECT_EQ(file_content(folder / "b.mcap.part"), "another's");
}

TEST(Convert, ALinkUnderItsNameIsNotFollowed) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(1));
  fs::create_directory(folder / "victim");
  write_content(folder / "victim" / "keep.txt", "a");
  for (const std::string output : {"out", "out.mcap"}) {
    const fs::path link = folder / (output + io::kUnfinished);
    fs::create_symlink(output == "out" ? "victim" : "victim/keep.txt", link);
    const ProcessResult result = run_surefoot({"convert", "pcd", output}, folder);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_EQ(file_content(folder / "victim" / "keep.txt"), "a");
  }
}

TEST(Convert, AStampThatRosCannotHoldCostsItsScanAlone) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  std::vector<Scan> scans = hall_scans(kBagScans);
  constexpr std::int64_t kIn2038 = 2'147'483'647'850'000'000;  // two scans later ROS 2 has no time
  const std::int64_t first_ns = scans.front().stamp_ns;
  for (Scan& scan : scans) scan.stamp_ns += kIn2038 - first_ns;
  write_pcd_recording(folder / "pcd", scans);
  const ProcessResult bag = run_surefoot({"convert", "pcd", "a.mcap"}, folder);
  EXPECT_EQ(bag.exit_code, 1) << bag;
  EXPECT_NE(bag.errors.find("left out: 000002.pcd: it is stamped 2147483648.05"), std::string::npos)
      << bag;
  EXPECT_NE(bag.output.find("2 scans"), std::string::npos) << bag;
  EXPECT_EQ(run_surefoot({"info", "a.mcap"}, folder).exit_code, 0);
}

TEST(Convert, QuietStillNamesWhatIsLeftOut) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(kBagScans));
  write_content(folder / "pcd" / scan_name(2), "no scan");
  const ProcessResult result = run_surefoot({"convert", "pcd", "a.mcap", "-q"}, folder);
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_NE(result.errors.find("left out: pcd/" + scan_name(2)), std::string::npos) << result;
}

TEST(Convert, TakesOverTopicAndFrame) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(2));
  ASSERT_EQ(run_surefoot({"convert", "pcd", "a.mcap", "--out-topic", "/os", "--frame", "os_lidar"},
                         folder)
                .exit_code,
            0);
  ASSERT_EQ(run_surefoot({"convert", "a.mcap", "b.bag"}, folder).exit_code, 0);
  const ProcessResult info = run_surefoot({"info", "b.bag", "--topic", "/none"}, folder);
  EXPECT_NE(info.errors.find("/os  sensor_msgs/PointCloud2"), std::string::npos) << info;
  EXPECT_NE(info.errors.find("frame os_lidar"), std::string::npos) << info;
  const ProcessResult idle =
      run_surefoot({"convert", "pcd", "las", "--to", "las", "--frame", "os_lidar"}, folder);
  EXPECT_NE(idle.errors.find("--frame counts for nothing here"), std::string::npos) << idle;
  EXPECT_EQ(idle.errors.find("--out-topic"), std::string::npos) << idle;
}

// Coordinates of a map's grid in doubles, an integer of 64 bits, and a point without a time.
TEST(Convert, SaysWhatTheOutputDoesNotHold) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  std::string points;
  for (int i = 0; i < 200; ++i) {
    points += std::to_string(5'400'000 + i) + ".3 1 1 7 " +
              (i == 100 ? std::string("nan") : std::to_string(0.0005 * i)) + "\n";
  }
  fs::create_directory(folder / "pcd");
  write_content(folder / "pcd" / "a.pcd",
                "VERSION .7\nFIELDS x y z ambient time\nSIZE 8 4 4 8 4\nTYPE F F F U F\n"
                "COUNT 1 1 1 1 1\nWIDTH 200\nHEIGHT 1\nPOINTS 200\nDATA ascii\n" +
                    points);
  const ProcessResult result = run_surefoot({"convert", "pcd", "a.mcap"}, folder);
  EXPECT_EQ(result.exit_code, 0) << result;
  for (const char* part : {"lost: fields that are not written to it: ambient\n",
                           "lost: coordinates become floats, which changes them by up to 0.2 m",
                           "left out: 1 points without a usable time"}) {
    EXPECT_NE(result.errors.find(part), std::string::npos) << result;
  }
}

TEST(Convert, OneScanToAFileOfItsOwn) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(3));
  for (const std::string output : {"a.pcd", "a.ply", "a.bin", "a.las"}) {
    const ProcessResult several = run_surefoot({"convert", "pcd", output}, folder);
    EXPECT_EQ(several.exit_code, 2) << several;
    EXPECT_NE(several.errors.find("--start N --count 1"), std::string::npos) << several;
    EXPECT_FALSE(fs::exists(folder / output));
    const ProcessResult one =
        run_surefoot({"convert", "pcd", output, "--start", "1", "--count", "1"}, folder);
    EXPECT_EQ(one.exit_code, 0) << one;
    EXPECT_NE(one.errors.find("lost: the scan's stamp"), std::string::npos) << one;
    EXPECT_TRUE(fs::is_regular_file(folder / output));
    EXPECT_EQ(run_surefoot({"info", output}, folder).exit_code, 0);
  }
  const ProcessResult las = run_surefoot({"convert", "pcd", "las", "--to", "las"}, folder);
  EXPECT_EQ(las.exit_code, 0) << las;
  EXPECT_NE(las.errors.find(
                "are not written to it: intensity, ring, t\nlost: digits below the millimetre"),
            std::string::npos)
      << las;
  EXPECT_NE(run_surefoot({"info", "las"}, folder).output.find("scans          3"),
            std::string::npos);
}

TEST(Convert, CaptureToBag) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_content(folder / "walk.pcap", pcap_file(vlp16_packets(3)));
  const ProcessResult result = run_surefoot({"convert", "walk.pcap", "walk.mcap"}, folder);
  EXPECT_EQ(result.exit_code, 0) << result;
  const ProcessResult info = run_surefoot({"info", "walk.mcap"}, folder);
  EXPECT_NE(info.output.find("rings          16"), std::string::npos) << info;
}

TEST(Convert, CaptureToCapture) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_content(folder / "walk.pcapng", pcapng_file(vlp16_packets(4)));
  const ProcessResult all = run_surefoot({"convert", "walk.pcapng", "walk.pcap"}, folder);
  EXPECT_EQ(all.exit_code, 0) << all;
  EXPECT_NE(all.output.find(" packets, copied as they are"), std::string::npos) << all;
  EXPECT_NE(all.errors.find("lost: what pcapng has besides packets"), std::string::npos) << all;
  const ProcessResult some =
      run_surefoot({"convert", "walk.pcap", "some", "--to", "pcap", "--stride", "2"}, folder);
  EXPECT_EQ(some.exit_code, 0) << some;
  EXPECT_NE(some.errors.find("packets go whole"), std::string::npos) << some;
  const ProcessResult again = run_surefoot({"convert", "walk.pcapng", "walk.pcap"}, folder);
  EXPECT_EQ(again.exit_code, 2) << again;
  EXPECT_NE(again.errors.find("walk.pcap: is there already"), std::string::npos) << again;
}

// Everything that a run says as messages, in both containers.
TEST(RunBag, HoldsScansMapOdometryPathTransformsAndDiagnostics) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(kBagScans));
  const ProcessResult result =
      run_surefoot({"run", "pcd", "-o", "out", "--no-report", "--mcap", "run.mcap", "--rosbag2",
                    "bag2", "--extrinsic", "0.1,0,0.3,0,0,0", "--pose-of", "base"},
                   folder);
  ASSERT_EQ(result.exit_code, 0) << result;
  for (const char* bag : {"run.mcap", "bag2"}) {
    std::map<std::string, int> counts;
    const auto source = io::open_bag(folder / bag);
    while (const auto message = source->next()) {
      ++counts[message->topic->name + " " + message->topic->type];
    }
    EXPECT_TRUE(source->notes().empty());
    EXPECT_EQ(counts["/surefoot/odometry nav_msgs/Odometry"], kBagScans) << bag;
    EXPECT_EQ(counts["/surefoot/scan sensor_msgs/PointCloud2"], kBagScans) << bag;
    EXPECT_EQ(counts["/tf tf2_msgs/TFMessage"], kBagScans) << bag;
    EXPECT_EQ(counts["/diagnostics diagnostic_msgs/DiagnosticArray"], kBagScans) << bag;
    EXPECT_GE(counts["/surefoot/local_map sensor_msgs/PointCloud2"], 1) << bag;
    EXPECT_GE(counts["/surefoot/path nav_msgs/Path"], 1) << bag;
  }
  const ProcessResult info =
      run_surefoot({"info", "run.mcap", "--topic", "/surefoot/scan"}, folder);
  EXPECT_EQ(info.exit_code, 0) << info;
  EXPECT_NE(info.output.find("topic          /tf  tf2_msgs/TFMessage"), std::string::npos) << info;
  // Of several topics all are listed; who has to take one is told how, by no other command's name.
  const ProcessResult several = run_surefoot({"info", "run.mcap"}, folder);
  EXPECT_EQ(several.exit_code, 0) << several;
  for (const char* part : {"--topic /surefoot/local_map", "--topic /surefoot/scan",
                           "/surefoot/odometry  nav_msgs/Odometry  10.0 Hz"}) {
    EXPECT_NE(several.output.find(part), std::string::npos) << part << several;
  }
  const ProcessResult json = run_surefoot({"info", "run.mcap", "--json"}, folder);
  EXPECT_NE(json.output.find("\"name\": \"/diagnostics\""), std::string::npos) << json;
  const ProcessResult check = run_surefoot({"check", "run.mcap"}, folder);
  EXPECT_EQ(check.exit_code, 2) << check;
  for (const char* part : {"by the same command with:\n", "\n  --topic /surefoot/local_map\n"}) {
    EXPECT_NE(check.errors.find(part), std::string::npos) << part << check;
  }
  EXPECT_EQ(check.errors.find("surefoot run"), std::string::npos) << check;
}

// What is there stays unless it may go, and the recording itself always does.
TEST(RunBag, DoesNotReplaceWhatIsThere) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_pcd_recording(folder / "pcd", hall_scans(kBagScans));
  ASSERT_EQ(run_surefoot({"convert", "pcd", "in.mcap"}, folder).exit_code, 0);
  const std::string before = file_content(folder / "in.mcap");
  const std::vector<std::string> run = {"run",         "in.mcap",      "-o",     "out",
                                        "--no-report", "--no-picture", "--mcap", "in.mcap"};
  std::vector<std::string> forced = run;
  forced.emplace_back("--overwrite");
  for (const auto& arguments : {run, forced}) {
    const ProcessResult result = run_surefoot(arguments, folder);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE(result.errors.find("in.mcap: is the recording itself"), std::string::npos) << result;
  }
  EXPECT_EQ(file_content(folder / "in.mcap"), before);
  EXPECT_FALSE(fs::exists(folder / "out"));
  write_content(folder / "old.mcap", "precious");
  std::vector<std::string> other = run;
  other.back() = "old.mcap";
  EXPECT_EQ(run_surefoot(other, folder).exit_code, 2);
  EXPECT_EQ(file_content(folder / "old.mcap"), "precious");
  other.emplace_back("--overwrite");
  EXPECT_EQ(run_surefoot(other, folder).exit_code, 0);
}

TEST(Bags, OneBadMessageIsNamedAndCountedAndTheRunGoesOn) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  const std::vector<Scan> scans = hall_scans(kBagScans);
  const auto bag = io::make_mcap_bag(folder / "a.mcap");
  const std::size_t topic = bag->add_topic("/points", io::point_cloud2_definition());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    std::string message =
        io::format_point_cloud2(scans[i], "lidar", io::MessageWriter::Flavour::cdr);
    if (i == 2) message.resize(message.size() / 2);
    bag->write(topic, scans[i].stamp_ns, message);
  }
  bag->finish();
  const ProcessResult result = run_surefoot({"run", "a.mcap", "-o", "out", "--no-report"}, folder);
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_NE(result.errors.find("/points, message 2: "), std::string::npos) << result;
  EXPECT_NE(result.output.find("1 unreadable"), std::string::npos) << result;
  EXPECT_NE(result.output.find("4 scans"), std::string::npos) << result;
  const ProcessResult quiet =
      run_surefoot({"run", "a.mcap", "-o", "quiet", "--no-report", "-q"}, folder);
  EXPECT_NE(quiet.errors.find("left out: a.mcap: /points, message 2: "), std::string::npos)
      << quiet;
  const std::string yaml = file_content(folder / "quiet" / "run.yaml");
  EXPECT_NE(yaml.find("unreadable_scans: 1\n"), std::string::npos) << yaml;
  EXPECT_NE(yaml.find("/points, message 2: "), std::string::npos) << yaml;
}

}  // namespace
}  // namespace surefoot::test
