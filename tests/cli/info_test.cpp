// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot info, as text and as JSON.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "capture.hpp"
#include "process.hpp"
#include "recordings.hpp"
#include "sensors/velodyne/vlp16.hpp"

namespace surefoot::test {
namespace {

/// What follows `name` in the table; fails where there is no such row.
std::string row(const ProcessResult& result, const std::string& name) {
  const std::string start = "\n" + name;
  const std::size_t at = ("\n" + result.output).find(start);
  EXPECT_NE(at, std::string::npos) << "no row " << name << "\n" << result;
  if (at == std::string::npos) return {};
  const std::size_t value = result.output.find_first_not_of(' ', at + name.size());
  return result.output.substr(value, result.output.find('\n', value) - value);
}

nlohmann::json info_json(const std::string& input, int exit_code, const ScratchFolder& scratch) {
  const ProcessResult result = run_surefoot({"info", input, "--json"}, scratch.path());
  EXPECT_EQ(result.exit_code, exit_code) << result;
  EXPECT_TRUE(result.errors.empty()) << result;
  const nlohmann::json json = nlohmann::json::parse(result.output, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << result;
  return json;
}

TEST(Info, TellsOfAFolder) {
  const ScratchFolder scratch;
  const std::vector<Scan> scans = hall_scans(3);
  write_pcd_recording(scratch.path() / "in", scans);
  const ProcessResult text = run_surefoot({"info", "in"}, scratch.path());
  EXPECT_EQ(text.exit_code, 0) << text;
  EXPECT_EQ(row(text, "recording"), "folder of 3 PCD files");
  EXPECT_EQ(row(text, "scans"), "3");
  EXPECT_EQ(row(text, "stamps"), "0.000000000 .. 0.200000000 s (0.200000000 s)");
  EXPECT_EQ(row(text, "rate"), "10.000 Hz");

  const nlohmann::json json = info_json("in", 0, scratch);
  EXPECT_EQ(json["description"], "folder of 3 PCD files");
  EXPECT_EQ(json["scans"], 3);
  EXPECT_EQ(json["unreadable"], 0);
  EXPECT_EQ(json["last_stamp"], "0.200000000");
  EXPECT_NEAR(json["rate_hz"].get<double>(), 10.0, 1e-9);
  const auto [fewest, most] = std::minmax_element(
      scans.begin(), scans.end(),
      [](const Scan& a, const Scan& b) { return a.points.size() < b.points.size(); });
  EXPECT_EQ(json["points_per_scan"]["min"], static_cast<double>(fewest->points.size()));
  EXPECT_EQ(json["points_per_scan"]["max"], static_cast<double>(most->points.size()));
  EXPECT_TRUE(json["odd"].empty()) << json["odd"];
  EXPECT_FALSE(json.contains("packets"));
}

// The scans that are there are told of, the one that is not is named, and the code says so.
TEST(Info, NamesAnUnreadableScan) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(3));
  write_content(scratch.path() / "in" / scan_name(1), "");
  const ProcessResult text = run_surefoot({"info", "in"}, scratch.path());
  EXPECT_EQ(text.exit_code, 1) << text;
  EXPECT_NE(text.output.find(scan_name(1)), std::string::npos) << text;
  const nlohmann::json json = info_json("in", 1, scratch);
  EXPECT_EQ(json["unreadable"], 1);
  EXPECT_NE(json["odd"].dump().find(scan_name(1)), std::string::npos) << json["odd"];
}

TEST(Info, TellsOfACapture) {
  const ScratchFolder scratch;
  std::vector<std::string> packets = vlp16_packets(3);
  packets.erase(packets.begin(), packets.begin() + 40);
  packets.erase(packets.begin() + 60);
  write_content(scratch.path() / "walk.pcap", pcap_file(packets));
  const ProcessResult text = run_surefoot({"info", "walk.pcap"}, scratch.path());
  EXPECT_EQ(text.exit_code, 0) << text;
  EXPECT_EQ(row(text, "recording"), "VLP-16 capture, return mode single, strongest");
  EXPECT_EQ(row(text, "rings"), "16, 0 .. 15");
  EXPECT_NE(row(text, "packets").find("1 lost"), std::string::npos) << text;

  const nlohmann::json json = info_json("walk.pcap", 0, scratch);
  EXPECT_EQ(json["packets"]["all"], packets.size());
  EXPECT_EQ(json["packets"]["data"], packets.size());
  EXPECT_EQ(json["packets"]["lost"], 1);
  EXPECT_EQ(json["rings"].size(), static_cast<std::size_t>(vlp16::kLasers));
  EXPECT_NE(json["odd"].dump().find("revolution 0: partial"), std::string::npos) << json["odd"];
}

TEST(Info, RefusesWhatIsNoRecording) {
  const ScratchFolder scratch;
  write_content(scratch.path() / "walk.pcap", "no capture");
  const ProcessResult result = run_surefoot({"info", "walk.pcap", "--json"}, scratch.path());
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_TRUE(result.output.empty()) << result;
  EXPECT_NE(result.errors.find("walk.pcap: no pcap"), std::string::npos) << result;
}

}  // namespace
}  // namespace surefoot::test
