// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot live: packets over loopback, or replayed, against the same packets in a capture.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "capture.hpp"
#include "datagram_sender.hpp"
#include "process.hpp"
#include "same_files.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

const std::vector<std::string> kBare = {"--no-report", "--no-picture", "-q"};

std::vector<std::string> with(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// A walk's packets, and their capture's run.
class LiveTest : public testing::Test {
 protected:
  void SetUp() override {
    packets_ = vlp16_packets(8);
    write_content(scratch_.path() / "hall.pcap", pcap_file(packets_));
    const ProcessResult offline =
        run_surefoot(with({"run", "hall.pcap", "-o", "offline"}, kBare), scratch_.path());
    ASSERT_EQ(offline.exit_code, 0) << offline;
  }
  [[nodiscard]] std::string content(const std::string& file) const {
    return file_content(scratch_.path() / file);
  }
  void expect_same(const std::string& a, const std::string& b,
                   const std::vector<std::string>& files) const {
    expect_same_files(scratch_.path() / a, scratch_.path() / b, files);
  }
  /// What run.yaml of a live run repeats.
  void expect_repeated(const std::string& folder) const {
    const ProcessResult again = run_surefoot(
        {"run", "--config", folder + "/run.yaml", "-o", "again", "-q"}, scratch_.path());
    EXPECT_EQ(again.exit_code, 0) << again;
    expect_same(folder, "again", {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
  }

  ScratchFolder scratch_;
  std::vector<std::string> packets_;
};

TEST_F(LiveTest, AReplayLeavesWhatTheCaptureDoes) {
  const ProcessResult live =
      run_surefoot(with({"live", "--replay", "hall.pcap", "--speed", "0", "-o", "live"}, kBare),
                   scratch_.path());
  ASSERT_EQ(live.exit_code, 0) << live;
  EXPECT_EQ(live.errors.find("counts for nothing"), std::string::npos) << live;
  expect_same("offline", "live", {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
  EXPECT_EQ(content("live/live.log").find("dropped"), std::string::npos);
}

TEST_F(LiveTest, OptionsForOtherSourcesAreSaidToCountForNothing) {
  const auto said_of = [&](const std::string& file) {
    const ProcessResult result = run_surefoot(
        {"live", "--replay", file, "--speed", "0", "-o", "out", "--overwrite", "--no-report",
         "--no-picture", "--stamps", "none.txt", "--format", "ply", "--time-field", "t"},
        scratch_.path());
    EXPECT_EQ(result.exit_code, 0) << result;
    return result.errors;
  };
  const std::string of_packets = said_of("hall.pcap");
  for (const char* flag : {"--stamps", "--format", "--time-field"}) {
    EXPECT_NE(of_packets.find(std::string(flag) + " counts for nothing"), std::string::npos)
        << of_packets;
  }
  // Whether a topic's messages are clouds or packets is not known when it is opened.
  const ProcessResult made = run_surefoot({"convert", "hall.pcap", "hall.mcap"}, scratch_.path());
  ASSERT_EQ(made.exit_code, 0) << made;
  const std::string of_messages = said_of("hall.mcap");
  EXPECT_NE(of_messages.find("--stamps counts for nothing"), std::string::npos) << of_messages;
  EXPECT_EQ(of_messages.find("--time-field counts"), std::string::npos) << of_messages;
}

TEST_F(LiveTest, WhatBecameOfLoopsAndOfThePlaceInTheMapIsSaid) {
  const auto done = [&](const std::vector<std::string>& arguments) {
    const ProcessResult result =
        run_surefoot(with(arguments, {"--no-report", "--no-picture"}), scratch_.path());
    EXPECT_EQ(result.exit_code, 0) << result;
    return result.output;
  };
  (void)done({"map", "hall.pcap", "-o", "map"});
  const std::string output = done({"live", "--replay", "hall.pcap", "--speed", "0", "-o", "live",
                                   "--localize", "map", "--loop-closure"});
  EXPECT_NE(output.find("\nloops: "), std::string::npos) << output;
  EXPECT_NE(output.find("found in the map"), std::string::npos) << output;
}

TEST_F(LiveTest, AReplayedBagLeavesWhatItsRunDoes) {
  const auto done = [&](const std::vector<std::string>& arguments) {
    const ProcessResult result = run_surefoot(arguments, scratch_.path());
    EXPECT_EQ(result.exit_code, 0) << result;
  };
  done({"convert", "hall.pcap", "hall.mcap"});
  done(with({"run", "hall.mcap", "-o", "bag"}, kBare));
  done(with({"live", "--replay", "hall.mcap", "--speed", "0", "-o", "live"}, kBare));
  expect_same("bag", "live", {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
  done(with({"live", "--replay", "hall.mcap", "--speed", "20", "--queue", "100", "-o", "paced"},
            kBare));
  expect_same("bag", "paced", {"trajectory.tum", "map.ply"});
  expect_repeated("paced");
}

/// Writes a file bit by bit into another one while a live run follows that, and gives the run's
/// end.
ProcessResult follow(const fs::path& folder, const std::string& source, const std::string& grown) {
  const std::string whole = file_content(folder / source);
  std::ofstream file(folder / grown, std::ios::binary);
  const Process process(with({"live", "--follow", grown, "--silence", "1", "-o", "live"}, kBare),
                        folder);
  std::mt19937 random(5);
  for (std::size_t at = 0; at < whole.size();) {  // cut where it comes
    const std::size_t size = std::min<std::size_t>(1 + random() % 40'000, whole.size() - at);
    file.write(whole.data() + at, static_cast<std::streamsize>(size)).flush();
    at += size;
    std::this_thread::sleep_for(milliseconds(3));
  }
  return process.wait();
}

TEST_F(LiveTest, AFileThatGrowsLeavesWhatItsRunDoes) {
  write_content(scratch_.path() / "hall.pcapng", pcapng_file(packets_));
  for (const char* bag : {"hall.mcap", "hall.bag"}) {
    const ProcessResult made = run_surefoot({"convert", "hall.pcap", bag}, scratch_.path());
    ASSERT_EQ(made.exit_code, 0) << made;
  }
  for (const char* source : {"hall.pcap", "hall.pcapng", "hall.mcap", "hall.bag"}) {
    const ProcessResult whole =
        run_surefoot(with({"run", source, "-o", "whole"}, kBare), scratch_.path());
    ASSERT_EQ(whole.exit_code, 0) << whole;
    const ProcessResult live = follow(scratch_.path(), source,
                                      std::string("grown") + fs::path(source).extension().c_str());
    EXPECT_EQ(live.exit_code, 0) << live;
    EXPECT_EQ(live.errors.find("ends early"), std::string::npos) << live;
    expect_same("whole", "live", {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
    EXPECT_EQ(content("live/live.log").find("dropped"), std::string::npos);
    expect_repeated("live");
  }
}

TEST_F(LiveTest, ACaptureThroughAPipeEndsWithIt) {
  const fs::path pipe = scratch_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const Process process(
      with({"live", "--follow", "pipe", "--record", "heard.pcap", "-o", "live"}, kBare),
      scratch_.path());
  std::ofstream(pipe, std::ios::binary) << content("hall.pcap");
  const ProcessResult live = process.wait();
  ASSERT_EQ(live.exit_code, 0) << live;
  expect_same("offline", "live", {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
  expect_repeated("live");
}

TEST_F(LiveTest, ACaptureThatIsCutIsSaidToBe) {
  const std::string whole = content("hall.pcap");
  write_content(scratch_.path() / "cut.pcap", whole.substr(0, whole.size() - 100));
  const ProcessResult live = run_surefoot(
      {"live", "--replay", "cut.pcap", "--speed", "0", "-o", "live", "--no-report", "--no-picture"},
      scratch_.path());
  EXPECT_EQ(live.exit_code, 0) << live;
  EXPECT_NE(live.errors.find("it ends early: truncated"), std::string::npos) << live;
}

TEST_F(LiveTest, PacketsOverLoopbackGiveWhatTheCaptureGives) {
  const DatagramSender sender;
  const Process process(with({"live", "--udp", sender.port(), "-o", "live", "--record",
                              "heard.pcap", "--queue", "1000", "--silence", "1.5"},
                             kBare),
                        scratch_.path());
  ASSERT_TRUE(sender.wait_for_listener());
  for (std::size_t i = 0; i < packets_.size(); ++i) {
    sender.send(packets_[i]);
    if (i % 20 == 0) std::this_thread::sleep_for(milliseconds(5));
  }
  const ProcessResult live = process.wait();
  ASSERT_EQ(live.exit_code, 0) << live;
  // Stamps are of another hour: all else is the same.
  expect_same("offline", "live", {"trajectory_kitti.txt", "map.ply"});
  expect_repeated("live");
  // The silence that ended it is nobody's latency.
  const std::string log = content("live/live.log");
  EXPECT_LT(std::stod(log.substr(log.find_last_of(',') + 1)), 1500.0) << log;
}

TEST_F(LiveTest, MalformedDatagramsByTheThousandHaveNoEffect) {
  const DatagramSender sender;
  const Process process(
      with({"live", "--udp", sender.port(), "-o", "live", "--queue", "1000", "--silence", "1.5"},
           kBare),
      scratch_.path());
  ASSERT_TRUE(sender.wait_for_listener());
  std::mt19937 random(7);
  const auto junk = [&](std::size_t i) {
    const std::size_t size = i % 4 == 0 ? 1206 : random() % 1500;
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    if (i % 4 == 1) bytes = packets_[i % packets_.size()].substr(0, size % 1206);  // cut short
    if (i % 4 == 2) bytes.clear();
    return bytes;
  };
  std::size_t sent = 0;
  for (std::size_t i = 0; i < packets_.size(); ++i) {
    for (int k = 0; k < 8; ++k) sender.send(junk(sent++));
    sender.send(packets_[i]);
    if (i % 3 == 0) std::this_thread::sleep_for(milliseconds(2));
  }
  EXPECT_GT(sent, 4000U);
  const ProcessResult live = process.wait();
  ASSERT_EQ(live.exit_code, 0) << live;
  expect_same("offline", "live", {"trajectory_kitti.txt", "map.ply"});
}

// Of two revolutions that the one begins with there are parts alone: a run leaves out the first of
// those that it is given. Of the other one a piece is missing, up to shortly before a revolution's
// end: what is left of that has a stamp that a run mends, and a live one does not.
TEST_F(LiveTest, WhatWasLostOnTheWayIsRepeated) {
  const auto without = [&](std::ptrdiff_t from, std::ptrdiff_t to) {
    std::vector<std::string> packets(packets_.begin(), packets_.begin() + from);
    packets.insert(packets.end(), packets_.begin() + to, packets_.end());
    return pcap_file(packets);
  };
  write_content(scratch_.path() / "parts.pcap", without(20, 125));
  write_content(scratch_.path() / "piece.pcap", without(300, 450));
  const auto done = [&](const std::vector<std::string>& arguments) {
    const ProcessResult result = run_surefoot(arguments, scratch_.path());
    EXPECT_EQ(result.exit_code, 0) << result;
  };
  done({"convert", "piece.pcap", "piece.mcap", "--no-repair-stamps"});
  for (const char* recording : {"parts.pcap", "piece.pcap", "piece.mcap"}) {
    done(with({"live", "--replay", recording, "--speed", "0", "-o", "live"}, kBare));
    expect_repeated("live");
    done(with({"run", recording, "--like", "live/live.log", "-o", "like"}, kBare));
    expect_same("live", "like", {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
  }
}

TEST_F(LiveTest, ScansThatWereChosenAreNotChosenAmongAgain) {
  const ProcessResult live =
      run_surefoot(with({"live", "--replay", "hall.pcap", "--speed", "0", "--start", "1",
                         "--stride", "2", "--count", "3", "-o", "live"},
                        kBare),
                   scratch_.path());
  ASSERT_EQ(live.exit_code, 0) << live;
  EXPECT_EQ(lines_of(scratch_.path() / "live" / "trajectory_kitti.txt"), 3U);
  expect_repeated("live");
}

TEST_F(LiveTest, WhatItCannotKeepUpWithIsDroppedToldAndRepeated) {
  const ProcessResult live =
      run_surefoot({"live", "--replay", "hall.pcap", "--speed", "1000", "--queue", "1", "-o",
                    "live", "--no-report", "--no-picture"},
                   scratch_.path());
  ASSERT_EQ(live.exit_code, 0) << live;
  const std::string log = content("live/live.log");
  ASSERT_NE(log.find(",dropped,"), std::string::npos) << log;
  EXPECT_EQ(live.output.find(" 0 dropped"), std::string::npos) << live;
  expect_repeated("live");
  const ProcessResult like = run_surefoot(
      with({"run", "hall.pcap", "--like", "live/live.log", "-o", "like"}, kBare), scratch_.path());
  EXPECT_EQ(like.exit_code, 0) << like;
  expect_same("live", "like", {"trajectory.tum", "map.ply"});
  // Into the live run's own folder: not over the log that is followed, else without it.
  const ProcessResult over = run_surefoot(
      with({"run", "hall.pcap", "--like", "live/live.log", "-o", "live"}, kBare), scratch_.path());
  EXPECT_EQ(over.exit_code, 2) << over;
  EXPECT_NE(over.errors.find("live: is where live.log lies"), std::string::npos) << over;
  EXPECT_EQ(content("live/live.log"), log);
  const ProcessResult anew =
      run_surefoot(with({"run", "hall.pcap", "-o", "live"}, kBare), scratch_.path());
  EXPECT_EQ(anew.exit_code, 0) << anew;
  EXPECT_FALSE(fs::exists(scratch_.path() / "live" / "live.log"));
}

TEST_F(LiveTest, ASignalLeavesWholeFiles) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const DatagramSender sender;
    const Process process(with({"live", "--udp", sender.port(), "-o", "live"}, kBare),
                          scratch_.path());
    ASSERT_TRUE(sender.wait_for_listener());
    for (std::size_t i = 0; i < packets_.size() / 2; ++i) {
      sender.send(packets_[i]);
      std::this_thread::sleep_for(milliseconds(1));
    }
    process.send(signal);
    const ProcessResult live = process.wait();
    EXPECT_EQ(live.exit_code, 0) << live;
    EXPECT_GE(lines_of(scratch_.path() / "live" / "trajectory_kitti.txt"), 3U);
    for (const char* file : {"trajectory.tum", "map.ply", "run.yaml", "live.log"}) {
      EXPECT_FALSE(content(std::string("live/") + file).empty()) << file;
    }
  }
}

#ifdef SUREFOOT_HAS_LIVE_PAGE
/// Where the program says its page is.
struct PageAddress {
  std::uint16_t port = 0;  ///< 0: it did not say
  std::string token;
};

PageAddress page_address(const fs::path& errors) {
  const std::string begin = "page: http://127.0.0.1:", before_token = "/#token=";
  for (int i = 0; i < 1000; ++i) {
    const std::string text = file_content(errors);
    const std::size_t at = text.find(begin), end = text.find('\n', at);
    const std::size_t token = text.find(before_token, at);
    if (at != std::string::npos && end != std::string::npos && token != std::string::npos) {
      const std::size_t from = token + before_token.size();
      return {static_cast<std::uint16_t>(std::stoi(text.substr(at + begin.size()))),
              text.substr(from, end - from)};
    }
    std::this_thread::sleep_for(milliseconds(10));
  }
  return {};
}

/// The whole answer to a command.
std::string asked(const PageAddress& page, const std::string& command) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in address = loopback(page.port);
  (void)::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address));
  const std::string request =
      "POST /commands/" + command + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(page.port) +
      "\r\nX-Surefoot-Token: " + page.token + "\r\nContent-Length: 0\r\n\r\n";
  (void)::send(socket, request.data(), request.size(), MSG_NOSIGNAL);
  std::string answer;
  char buffer[4096];
  for (ssize_t got = 0; (got = ::recv(socket, buffer, sizeof(buffer), 0)) > 0;) {
    answer.append(buffer, static_cast<std::size_t>(got));
  }
  ::close(socket);
  return answer;
}

TEST_F(LiveTest, WhatIsAskedBeforeTheFirstScanIsAnswered) {
  const DatagramSender sender;
  const Process process({"live", "--udp", sender.port(), "--page", "0", "-o", "live"},
                        scratch_.path());
  const PageAddress page = page_address(scratch_.path() / "stderr.txt");
  ASSERT_NE(page.port, 0);
  for (const char* command : {"reset", "save_map"}) {
    const std::string answer = asked(page, command);
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 409")) << answer;
    EXPECT_NE(answer.find("no scan has come yet"), std::string::npos) << answer;
  }
  EXPECT_NE(asked(page, "pause").find("scans are left out"), std::string::npos);
  EXPECT_NE(asked(page, "localize").find("no such command"), std::string::npos);  // in which map?
  process.send(SIGTERM);
  EXPECT_EQ(process.wait().exit_code, 2);
}

TEST_F(LiveTest, WhoLooksAtItAndNeverReadsChangesNothing) {
  const Process process(with({"live", "--replay", "hall.pcap", "--speed", "0.5", "--queue", "1000",
                              "--page", "0", "-o", "live"},
                             kBare),
                        scratch_.path());
  const std::uint16_t port = page_address(scratch_.path() / "stderr.txt").port;
  ASSERT_NE(port, 0);
  std::vector<int> sleepers;
  const std::string request =
      "GET /events HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n\r\n";
  for (int i = 0; i < 20; ++i) {
    sleepers.push_back(::socket(AF_INET, SOCK_STREAM, 0));
    const sockaddr_in address = loopback(port);
    (void)::connect(sleepers.back(), reinterpret_cast<const sockaddr*>(&address), sizeof(address));
    (void)::send(sleepers.back(), request.data(), request.size(), MSG_NOSIGNAL);
  }
  const ProcessResult live = process.wait();
  for (const int socket : sleepers) ::close(socket);
  ASSERT_EQ(live.exit_code, 0) << live;
  expect_same("offline", "live", {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
  EXPECT_EQ(content("live/live.log").find("dropped"), std::string::npos);
}
#endif

TEST_F(LiveTest, BadUsageIsExplained) {
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& text) {
    const ProcessResult result = run_surefoot(arguments, scratch_.path());
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE((result.output + result.errors).find(text), std::string::npos) << result;
  };
  expect({"live"}, "expected --udp PORT");
  expect({"live", "--udp", "70000"}, "--udp");
  expect({"live", "--udp", "2368", "--replay", "hall.pcap"}, "excludes");
  expect({"live", "--udp", "2368", "--address", "here"}, "'here' is no address");
  expect({"live", "--replay", "none.pcap"}, "none.pcap: ");
  expect({"live", "--follow", "none.pcap"}, "none.pcap: cannot read it: No such file");
  expect({"live", "--follow", "."}, "expected a file or a pipe");
  expect({"live", "--follow", "hall.pcap", "--replay", "hall.pcap"}, "excludes");
  expect({"live", "--follow", "hall.pcap", "--record", "too.pcap"},
         "--follow reads would be the same");
  expect({"live", "--udp", "2368", "--record", "hall.pcap"}, "hall.pcap is there already");
  write_content(scratch_.path() / "text.pcap", std::string(100, 'a'));
  expect({"live", "--follow", "text.pcap", "--silence", "1"},
         "text.pcap: no pcap or pcapng capture");
  expect({"live", "--replay", "hall.pcap", "--set", "knots.points=-1"}, "knots.points");
  write_content(scratch_.path() / "no.log", "stamp\n1\n");
  expect({"run", "hall.pcap", "--like", "no.log"}, "no.log: got 'stamp', expected the log");
  expect({"run", "hall.pcap", "--like", "none.log"}, "none.log: cannot read it: No such file");
  const std::string head = "stamp_ns,scan,fate,latency_ms\n";
  write_content(scratch_.path() / "no.log", head + "1,a,dropped,\n");
  expect({"run", "hall.pcap", "--like", "no.log"}, "no.log: its run used no scan");
  write_content(scratch_.path() / "no.log", head + "1,a,used,1.0\n2,b,used,1.0\n");
  expect({"run", "hall.pcap", "--like", "no.log"},
         "hall.pcap: none of the 2 scans that no.log names is there");
  expect({"run", "hall.pcap", "--mcap", "none/x.mcap"},
         "none/x.mcap: cannot be written: there is no folder");
  // What needs no scan is told before the first one comes: none does.
  expect({"live", "--udp", DatagramSender().port(), "--localize", "none.surefoot"},
         "none.surefoot");
  expect({"live", "--udp", DatagramSender().port(), "--map", "none.surefoot"}, "none.surefoot");
  expect({"live", "--udp", DatagramSender().port(), "--mcap", "none/x.mcap"}, "none/x.mcap");
  const DatagramSender silent;
  const Process process({"live", "--udp", silent.port()}, scratch_.path());
  ASSERT_TRUE(silent.wait_for_listener());
  silent.send("hello");
  std::this_thread::sleep_for(milliseconds(300));
  process.send(SIGTERM);
  const ProcessResult result = process.wait();
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(
      result.errors.find("1 datagrams, no LiDAR's data packet among them; most are of 5 bytes"),
      std::string::npos)
      << result;
}

}  // namespace
}  // namespace surefoot::test
