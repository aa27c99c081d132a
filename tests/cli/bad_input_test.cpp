// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Inputs that hold nothing of use end with exit code 2 and a message; a bad scan among good ones is
// left out or rejected, and the rest goes on.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <limits>

#include "capture.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

std::string pcd(const std::string& fields, const std::string& sizes, const std::string& types,
                const std::string& width, const std::string& data) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types +
         "\nWIDTH " + width + "\nHEIGHT 1\nPOINTS " + width + "\nDATA " + data;
}

std::string xyz_pcd(const std::string& width, const std::string& data) {
  return pcd("x y z", "4 4 4", "F F F", width, data);
}

std::string ply_text(const std::string& format, const std::string& vertices,
                     const std::string& data) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + data;
}

std::string good_pcd() { return io::format_pcd(hall_scans(1).front(), io::PcdData::binary); }

Scan uniform_scan(std::size_t points, const Eigen::Vector3f& point) {
  Scan scan;
  scan.points.assign(points, point);
  return scan;
}

std::string uniform_pcd(std::size_t points, const Eigen::Vector3f& point) {
  return io::format_pcd(uniform_scan(points, point), io::PcdData::binary);
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kHuge = std::numeric_limits<float>::max();

struct BadFile {
  const char* name;
  std::string extension;
  std::string content;
};

void PrintTo(const BadFile& file, std::ostream* out) { *out << file.name; }

/// Sizes of the compressed and the uncompressed data, then the data.
std::string compressed_pcd(std::uint32_t compressed, std::uint32_t whole, const std::string& data) {
  std::string sizes(8, '\0');
  for (int byte = 0; byte < 4; ++byte) {
    sizes[byte] = static_cast<char>(compressed >> 8 * byte);
    sizes[4 + byte] = static_cast<char>(whole >> 8 * byte);
  }
  return xyz_pcd("100", "binary_compressed\n" + sizes + data);
}

std::vector<BadFile> bad_scans() {
  const std::string some_bytes(1200, '\x42');
  return {
      {"empty_pcd", ".pcd", ""},
      {"empty_ply", ".ply", ""},
      {"empty_bin", ".bin", ""},
      {"noise_pcd", ".pcd", some_bytes},
      {"noise_ply", ".ply", some_bytes},
      {"zeros_pcd", ".pcd", std::string(4096, '\0')},
      {"no_data_line", ".pcd", "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\n"},
      {"no_points", ".pcd", xyz_pcd("0", "binary\n")},
      {"header_cut", ".pcd", good_pcd().substr(0, 60)},
      {"data_cut", ".pcd", good_pcd().substr(0, 5000)},
      {"width_4_gb", ".pcd", xyz_pcd("4294967295", "binary\n" + some_bytes)},
      {"width_overflows", ".pcd", xyz_pcd("18446744073709551615", "binary\n" + some_bytes)},
      {"width_overflows_12_bytes", ".pcd", xyz_pcd("1537228672809129302", "binary\n" + some_bytes)},
      {"width_beyond_64_bits", ".pcd", xyz_pcd("99999999999999999999", "binary\n" + some_bytes)},
      {"width_negative", ".pcd", xyz_pcd("-5", "binary\n" + some_bytes)},
      {"width_a_word", ".pcd", xyz_pcd("many", "binary\n" + some_bytes)},
      {"ascii_width_4_gb", ".pcd", xyz_pcd("4294967295", "ascii\n1 2 3\n")},
      {"ascii_words", ".pcd", xyz_pcd("2", "ascii\n1 2 3\nx y z\n")},
      {"ascii_short_line", ".pcd", xyz_pcd("2", "ascii\n1 2 3\n1 2\n")},
      {"no_z", ".pcd", pcd("x y", "4 4", "F F", "100", "binary\n" + some_bytes)},
      {"size_three", ".pcd", pcd("x y z", "3 4 4", "F F F", "100", "binary\n" + some_bytes)},
      {"type_unknown", ".pcd", pcd("x y z", "4 4 4", "F Q F", "100", "binary\n" + some_bytes)},
      {"sizes_missing", ".pcd", pcd("x y z", "4 4", "F F F", "100", "binary\n" + some_bytes)},
      {"data_unknown", ".pcd", xyz_pcd("100", "zipped\n" + some_bytes)},
      {"compressed_4_gb", ".pcd", compressed_pcd(64, 0xffffffff, some_bytes)},
      {"compressed_beyond_file", ".pcd", compressed_pcd(0xffffffff, 1200, some_bytes)},
      {"compressed_noise", ".pcd", compressed_pcd(1200, 1200, some_bytes)},
      {"compressed_no_sizes", ".pcd", xyz_pcd("100", "binary_compressed\n12")},
      {"ply_4_gb", ".ply", ply_text("binary_little_endian", "4294967295", some_bytes)},
      {"ply_overflows", ".ply",
       ply_text("binary_little_endian", "1537228672809129302", some_bytes)},
      {"ply_cut", ".ply", ply_text("binary_big_endian", "101", some_bytes)},
      {"ply_ascii_cut", ".ply", ply_text("ascii", "3", "1 2 3\n4 5 6\n")},
      {"ply_format_unknown", ".ply", ply_text("binary_middle_endian", "100", some_bytes)},
      {"ply_no_end", ".ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"},
      {"bin_odd_size", ".bin", std::string(1234, '\x42')},
      {"one_point", ".pcd", uniform_pcd(1, {1, 2, 3})},
      {"all_points_equal", ".pcd", uniform_pcd(5000, {1, 2, 3})},
      {"all_points_zero", ".pcd", uniform_pcd(5000, {0, 0, 0})},
      {"all_nan", ".pcd", uniform_pcd(5000, {kNan, kNan, kNan})},
      {"all_infinite", ".pcd", uniform_pcd(5000, {kInf, -kInf, kInf})},
      {"all_huge", ".pcd", uniform_pcd(5000, {kHuge, -kHuge, kHuge})},
  };
}

class BadScan : public testing::TestWithParam<BadFile> {};

TEST_P(BadScan, AloneIsRefused) {
  const ScratchFolder scratch;
  const std::string name = "scan" + GetParam().extension;
  write_content(scratch.path() / name, GetParam().content);
  const ProcessResult result = run_surefoot({"run", name, "-o", "out"}, scratch.path());
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(result.errors.find(name), std::string::npos) << "file not named\n" << result;
}

TEST_P(BadScan, InfoGoesOn) {
  const ScratchFolder scratch;
  const std::string name = "scan" + GetParam().extension;
  write_content(scratch.path() / name, GetParam().content);
  const ProcessResult result = run_surefoot({"info", name}, scratch.path());
  EXPECT_EQ(result.signal, 0) << result;
  EXPECT_LE(result.exit_code, 2) << result;
}

INSTANTIATE_TEST_SUITE_P(All, BadScan, testing::ValuesIn(bad_scans()),
                         [](const auto& instance) { return std::string(instance.param.name); });

std::vector<BadFile> bad_pcd_scans() {
  std::vector<BadFile> files = bad_scans();
  std::erase_if(files, [](const BadFile& file) { return file.extension != ".pcd"; });
  return files;
}

class BadPcdAmongGoodOnes : public testing::TestWithParam<BadFile> {};

TEST_P(BadPcdAmongGoodOnes, IsLeftOut) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(4));
  write_content(scratch.path() / "in" / scan_name(2), GetParam().content);
  const ProcessResult result = run_surefoot({"run", "in", "-o", "out"}, scratch.path());
  const bool was_read = result.errors.find(scan_name(2) + ": rejected: ") != std::string::npos;
  EXPECT_EQ(result.exit_code, was_read ? 0 : 1) << result;
  EXPECT_NE(result.errors.find(scan_name(2)), std::string::npos) << "file not named\n" << result;
  EXPECT_EQ(io::read_tum(scratch.path() / "out" / "trajectory.tum").size(), 3U) << result;
}

INSTANTIATE_TEST_SUITE_P(All, BadPcdAmongGoodOnes, testing::ValuesIn(bad_pcd_scans()),
                         [](const auto& instance) { return std::string(instance.param.name); });

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// Its header is honest, and the file as long as it says: a hole on the disk.
TEST(BadInput, AScanThatTakesMoreMemoryThanThereIsIsLeftOut) {
  constexpr std::uint64_t kPoints = 250'000'000;  // 3 GB
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(4));
  const fs::path large = scratch.path() / "in" / scan_name(2);
  const std::string header = xyz_pcd(std::to_string(kPoints), "binary\n");
  write_content(large, header);
  fs::resize_file(large, header.size() + 12 * kPoints);
  const ProcessResult result = run_surefoot({"run", "in", "-o", "out"}, scratch.path());
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_NE(result.errors.find(scan_name(2) + ": takes more memory than there is"),
            std::string::npos)
      << result;
  EXPECT_EQ(io::read_tum(scratch.path() / "out" / "trajectory.tum").size(), 3U) << result;
}
#endif

void expect_input_refused(const std::vector<std::string>& arguments, const std::string& named,
                          const ScratchFolder& scratch) {
  const ProcessResult result = run_surefoot(arguments, scratch.path());
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(result.errors.find(named), std::string::npos) << "not named: " << named << "\n"
                                                          << result;
}

// A terminal would act on what such a name holds, or show a line that nobody said.
TEST(BadInput, NamesAreShownAsWhatATerminalDoesNotActOn) {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "scans");
  const std::string name = "b\x1b[31m\nverdict: fit.pcd";
  write_content(scratch.path() / "scans" / ("a" + name), good_pcd());
  write_content(scratch.path() / "scans" / name, "junk");
  fs::create_directories(scratch.path() / "walk\x1b[2J");
  write_content(scratch.path() / "walk\x1b[2J" / "a.pcd", good_pcd());
  const std::string gone = "scans/none\x1b[2J";
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"info", "scans"},
                                                    {"check", "scans", "--html", "page.html"},
                                                    {"run", "scans", "-o", "out", "--no-report"},
                                                    {"convert", "scans", "a.mcap"},
                                                    {"run", "walk\x1b[2J", "--no-report"},
                                                    {"run", "--config", "results/latest/run.yaml"},
                                                    {"info", gone}}) {
    const ProcessResult result = run_surefoot(arguments, scratch.path());
    const std::string said = result.output + result.errors;
    EXPECT_EQ(said.find('\x1b'), std::string::npos) << result;
    EXPECT_EQ(said.find("\nverdict: fit.pcd"), std::string::npos) << result;
    EXPECT_NE(said.find("?["), std::string::npos) << result;
  }
  EXPECT_EQ(file_content(scratch.path() / "page.html").find('\x1b'), std::string::npos);
}

TEST(BadInput, BytesThatAreNoTextAreNotShown) {
  const ScratchFolder scratch;
  write_content(scratch.path() / "route",
                "\xFF\xFE\x9B"
                "31m");
  const ProcessResult result =
      run_surefoot({"simulate", "campus", "--route", "route", "-o", "out"}, scratch.path());
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(result.errors.find("'???31m'"), std::string::npos) << result;
}

TEST(BadInput, MissingPath) {
  const ScratchFolder scratch;
  expect_input_refused({"run", "nowhere"}, "nowhere", scratch);
  expect_input_refused({"run", "nowhere.pcap"}, "nowhere.pcap", scratch);
  expect_input_refused({"info", "nowhere"}, "nowhere", scratch);
  expect_input_refused({"run", ""}, "surefoot", scratch);
}

TEST(BadInput, FolderWithoutScans) {
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / "in");
  expect_input_refused({"run", "in", "-o", "out"}, "in", scratch);
  write_content(scratch.path() / "in" / "readme.txt", "nothing here");
  expect_input_refused({"run", "in", "-o", "out"}, "in", scratch);
  EXPECT_FALSE(fs::exists(scratch.path() / "out"));
}

TEST(BadInput, UnknownKindOfFile) {
  const ScratchFolder scratch;
  write_content(scratch.path() / "walk.e57", "ASTM-E57");
  expect_input_refused({"run", "walk.e57"}, "walk.e57", scratch);
}

TEST(BadInput, FolderNamedAsAScan) {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "in" / "000000.pcd");
  expect_input_refused({"run", "in"}, "in", scratch);
}

TEST(BadInput, LinkToItself) {
  const ScratchFolder scratch;
  fs::create_symlink("loop.pcd", scratch.path() / "loop.pcd");
  expect_input_refused({"run", "loop.pcd"}, "loop.pcd", scratch);
}

// Opening a pipe would wait for a writer; a device may have no end.
TEST(BadInput, NoRegularFile) {
  const ScratchFolder scratch;
  for (const char* name : {"scan.pcd", "walk.pcap", "walk.mcap", "walk", "path.tum"}) {
    ASSERT_EQ(mkfifo((scratch.path() / name).c_str(), 0600), 0);
  }
  fs::create_symlink("/dev/zero", scratch.path() / "endless.ply");
  expect_input_refused({"run", "scan.pcd", "-o", "out"}, "scan.pcd: it is a named pipe", scratch);
  for (const std::string name : {"walk.pcap", "walk.mcap", "walk"}) {
    expect_input_refused(
        {"run", name},
        name + ": it is a named pipe; expected a regular file: it is read more than once", scratch);
  }
  expect_input_refused({"run", "endless.ply", "-o", "out"}, "endless.ply: it is a device", scratch);
  expect_input_refused({"eval", "path.tum", "path.tum"}, "path.tum: it is a named pipe", scratch);
}

TEST(BadInput, StartBeyondTheEnd) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(2));
  expect_input_refused({"run", "in", "-o", "out", "--start", "2"}, "in", scratch);
  EXPECT_FALSE(fs::exists(scratch.path() / "out"));
}

TEST(BadInput, UnknownTimeField) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(2));
  expect_input_refused({"run", "in", "-o", "out", "--time-field", "clock"}, "clock", scratch);
}

struct BadStamps {
  const char* name;
  const char* content;
};

class StampsFile : public testing::TestWithParam<BadStamps> {};

TEST_P(StampsFile, IsRefused) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(3));
  write_content(scratch.path() / "in" / "times.txt", GetParam().content);
  expect_input_refused({"run", "in", "-o", "out"}, "times.txt", scratch);
}

INSTANTIATE_TEST_SUITE_P(All, StampsFile,
                         testing::Values(BadStamps{"empty", ""}, BadStamps{"too_few", "0.0\n0.1\n"},
                                         BadStamps{"words", "0.0\nsoon\n0.2\n"},
                                         BadStamps{"not_a_number", "0.0\nnan\n0.2\n"},
                                         BadStamps{"beyond_64_bits", "0\n1e300\n2\n"}),
                         [](const auto& instance) { return std::string(instance.param.name); });

// Names that count frames tell which stamps are theirs; "last" does not.
TEST(BadInput, StampsOfScansThatNobodyCanTell) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(3));
  fs::rename(scratch.path() / "in" / "000002.pcd", scratch.path() / "in" / "last.pcd");
  write_content(scratch.path() / "in" / "times.txt", "0\n1\n2\n3\n");
  expect_input_refused({"run", "in", "-o", "out"}, "times.txt: 4 stamps for the 3 scans", scratch);
}

/// Statuses of scans.csv that are "rejected".
std::size_t rejected_scans(const ScratchFolder& scratch) {
  const std::string csv = file_content(scratch.path() / "out" / "scans.csv");
  std::size_t count = 0;
  for (std::size_t at = 0; (at = csv.find(",rejected,", at)) != std::string::npos; ++at) ++count;
  return count;
}

TEST(BadStampOrder, EqualStampsAreMendedOrRejected) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(4));
  write_content(scratch.path() / "in" / "times.txt", "5.0\n5.0\n5.0\n5.0\n");
  const ProcessResult mended = run_surefoot({"run", "in", "-o", "mended"}, scratch.path());
  EXPECT_EQ(mended.exit_code, 0) << mended;
  EXPECT_NE(mended.errors.find("stand still"), std::string::npos) << mended;
  const ProcessResult result =
      run_surefoot({"run", "in", "-o", "out", "--no-repair-stamps"}, scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(rejected_scans(scratch), 3U) << result;
}

TEST(BadStampOrder, BackwardStampsAreMendedOrRejected) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(4));
  write_content(scratch.path() / "in" / "times.txt", "5.0\n5.1\n4.0\n5.2\n");
  const ProcessResult mended = run_surefoot({"run", "in", "-o", "mended"}, scratch.path());
  EXPECT_EQ(mended.exit_code, 0) << mended;
  EXPECT_NE(mended.errors.find("fits neither side"), std::string::npos) << mended;
  const ProcessResult result =
      run_surefoot({"run", "in", "-o", "out", "--no-repair-stamps"}, scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(rejected_scans(scratch), 1U) << result;
}

TEST(BadCapture, IsRefused) {
  const ScratchFolder scratch;
  const std::string good = pcap_file(vlp16_packets(1));
  const std::pair<const char*, std::string> captures[] = {
      {"empty.pcap", ""},
      {"noise.pcap", std::string(1000, '\x42')},
      {"half_a_header.pcap", good.substr(0, 10)},
      {"no_packets.pcap", good.substr(0, 24)},
      {"half_a_packet.pcap", good.substr(0, 300)},
      {"other_traffic.pcap", pcap_file({"hello", "world"})},
      {"no_sensor.pcap", pcap_file({std::string(1206, '\0')})},
      {"empty.pcapng", ""},
      {"header_only.pcapng", pcapng_file({})},
  };
  for (const auto& [name, content] : captures) {
    write_content(scratch.path() / name, content);
    expect_input_refused({"run", name, "-o", "out"}, name, scratch);
  }
}

TEST(BadCapture, CutInTheMiddleIsReadToTheCut) {
  const ScratchFolder scratch;
  const std::string whole = pcap_file(vlp16_packets(3));
  write_content(scratch.path() / "cut.pcap", whole.substr(0, whole.size() * 5 / 6));
  const ProcessResult result = run_surefoot({"run", "cut.pcap", "-o", "out"}, scratch.path());
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_GE(io::read_tum(scratch.path() / "out" / "trajectory.tum").size(), 2U) << result;
}

}  // namespace
}  // namespace surefoot::test
