// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans that wait, are dropped and are timed, from a stream that is no sensor.
#include "live/live_recording.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>

#include "io/file_writer.hpp"
#include "support/scratch.hpp"

namespace surefoot::live {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kLost = 7;  // by every stream

/// What a test knows of its stream while LiveRecording's thread reads it.
struct Seen {
  std::atomic<int> allowed = 1'000;  ///< scans that may have come
  std::atomic<bool> ended = false;   ///< the reader was told that there is no more
};

/// So many scans, stamped 1, 2, ..., as soon as they may come.
class Scans final : public ScanStream {
 public:
  Scans(int count, bool patient, Seen& seen) : count_(count), patient_(patient), seen_(&seen) {}

  std::optional<LiveScan> next(const std::function<bool()>& go_on) override {
    while (given_ < count_ && given_ >= seen_->allowed && go_on()) {
      std::this_thread::sleep_for(milliseconds(1));
    }
    if (given_ >= count_ || given_ >= seen_->allowed) {
      seen_->ended = true;
      return std::nullopt;
    }
    if (given_ == fails_after_) throw io::WriteError("the disk is full");
    ++given_;
    LiveScan scan;
    scan.item.name = "scan " + std::to_string(given_);
    if (given_ == unreadable_ || given_ == also_unreadable_) {
      scan.item.error = given_ == unreadable_ ? "it is not one" : "nor is this";
    } else {
      scan.item.scan.emplace();
      scan.item.scan->stamp_ns = given_;
    }
    scan.received = last_ = Clock::now();
    return scan;
  }
  StreamState state() const override {
    return {static_cast<std::size_t>(given_), kLost, {}, {}, ""};
  }
  std::optional<Clock::time_point> last() const override { return last_; }
  bool patient() const override { return patient_; }
  std::string nothing_text() const override { return count_ == 0 ? "nothing came" : ""; }

  void make_unreadable(int which, int also) {
    unreadable_ = which;
    also_unreadable_ = also;
  }
  void fail_after(int scans) { fails_after_ = scans; }

 private:
  int count_;
  bool patient_;
  Seen* seen_;
  int given_ = 0;
  int unreadable_ = 0, also_unreadable_ = 0;
  int fails_after_ = -1;
  Clock::time_point last_ = Clock::now();
};

void wait_for_end(const Seen& seen) {
  while (!seen.ended) std::this_thread::sleep_for(milliseconds(1));
}

std::vector<std::int64_t> stamps_used(LiveRecording& recording) {
  std::vector<std::int64_t> stamps;
  while (const std::optional<io::ScanItem> item = recording.next()) {
    stamps.push_back(item->scan->stamp_ns);
    recording.done();
  }
  return stamps;
}

TEST(LiveRecording, WhatIsDoneAfterTheAnswerIsNoLatency) {
  Seen seen;
  const Clock::time_point began = Clock::now();
  LiveRecording recording(std::make_unique<Scans>(1, true, seen), {});
  ASSERT_TRUE(recording.next());
  recording.answered();
  constexpr auto kMapGrows = milliseconds(200);
  std::this_thread::sleep_for(kMapGrows);
  const double latency_ms = recording.done();
  const std::chrono::duration<double, std::milli> all = Clock::now() - began;
  EXPECT_GE(latency_ms, 0.0);
  EXPECT_LE(latency_ms, (all - kMapGrows).count());
  EXPECT_EQ(recording.figures().latencies_ms, std::vector<double>{latency_ms});
}

TEST(LiveRecording, WithoutAnAnswerLatencyEndsWithTheUse) {
  Seen seen;
  LiveRecording recording(std::make_unique<Scans>(2, true, seen), {});
  ASSERT_TRUE(recording.next());
  recording.answered();
  recording.done();
  ASSERT_TRUE(recording.next());  // the answer of the scan before is not this one's
  std::this_thread::sleep_for(milliseconds(30));
  EXPECT_GE(recording.done(), 30.0);
}

TEST(LiveRecording, ThatAScanWaitedIsLatency) {
  Seen seen;
  LiveRecording recording(std::make_unique<Scans>(1, true, seen), {});
  wait_for_end(seen);
  std::this_thread::sleep_for(milliseconds(30));
  ASSERT_TRUE(recording.next());
  recording.answered();
  EXPECT_GE(recording.done(), 30.0);
}

TEST(LiveRecording, AScanIsDoneOnce) {
  Seen seen;
  LiveRecording recording(std::make_unique<Scans>(1, true, seen), {});
  ASSERT_TRUE(recording.next());
  (void)recording.done();
  EXPECT_EQ(recording.done(), 0.0);
  EXPECT_EQ(recording.figures().used, 1U);
}

TEST(LiveRecording, IsSilentSinceTheLastScan) {
  Seen seen;
  seen.allowed = 0;
  LiveRecording recording(std::make_unique<Scans>(1, true, seen), {});
  std::this_thread::sleep_for(milliseconds(30));
  const Clock::time_point before = Clock::now();
  seen.allowed = 1;
  ASSERT_TRUE(recording.next());
  const Clock::time_point after = Clock::now();
  std::this_thread::sleep_for(milliseconds(30));
  const double silent_s = recording.figures().silent_s;
  const std::chrono::duration<double> most = Clock::now() - before;
  EXPECT_LE(silent_s, most.count());
  EXPECT_GE(silent_s, 0.03 - std::chrono::duration<double>(after - before).count());
}

// It ends after half a second of silence, not after half a millisecond.
TEST(LiveRecording, EndsAfterSilence) {
  Seen seen;
  seen.allowed = 1;
  LiveOptions options;
  options.silence = 0.5;
  LiveRecording recording(std::make_unique<Scans>(3, true, seen), options);
  ASSERT_TRUE(recording.next());
  std::this_thread::sleep_for(milliseconds(30));
  seen.allowed = 2;
  EXPECT_TRUE(recording.next());
  EXPECT_FALSE(recording.next());
}

TEST(LiveRecording, TheFreshestWaitTheOthersAreDroppedAndCounted) {
  Seen seen;
  LiveOptions options;
  options.queue = 2;
  LiveRecording recording(std::make_unique<Scans>(7, false, seen), options);
  wait_for_end(seen);
  EXPECT_EQ(stamps_used(recording), (std::vector<std::int64_t>{6, 7}));
  const LiveFigures figures = recording.figures();
  EXPECT_EQ(figures.received, 7U);
  EXPECT_EQ(figures.lost, kLost);
  EXPECT_EQ(figures.used, 2U);
  EXPECT_EQ(figures.dropped, 5U);
  EXPECT_EQ(figures.latencies_ms.size(), 2U);
}

TEST(LiveRecording, APatientStreamWaitsAndLosesNothing) {
  Seen seen;
  LiveRecording recording(std::make_unique<Scans>(7, true, seen), {});
  EXPECT_EQ(stamps_used(recording), (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(recording.figures().dropped, 0U);
}

TEST(LiveRecording, WhatComesDuringAPauseIsCountedAndNotUsed) {
  Seen seen;
  seen.allowed = 0;
  LiveRecording recording(std::make_unique<Scans>(3, true, seen), {});
  recording.pause(true);
  EXPECT_TRUE(recording.figures().is_paused);
  seen.allowed = 3;
  wait_for_end(seen);
  EXPECT_TRUE(stamps_used(recording).empty());
  EXPECT_EQ(recording.figures().paused, 3U);
}

TEST(LiveRecording, WhatIsUnreadableIsCountedAndSaid) {
  Seen seen;
  auto scans = std::make_unique<Scans>(4, true, seen);
  scans->make_unreadable(2, 3);
  LiveRecording recording(std::move(scans), {});
  EXPECT_EQ(stamps_used(recording), (std::vector<std::int64_t>{1, 4}));
  EXPECT_EQ(recording.figures().unreadable, 2U);
  EXPECT_EQ(recording.notes(), std::vector<std::string>{"left out: it is not one"});
}

TEST(LiveRecording, WhatEndsWithNothingIsAnErrorOnce) {
  Seen seen;
  LiveRecording recording(std::make_unique<Scans>(0, true, seen), {});
  EXPECT_THROW((void)recording.next(), io::ReadError);
  EXPECT_FALSE(recording.next());
}

TEST(LiveRecording, WhatGoesWrongOnTheWayEndsItInGoodOrder) {
  Seen seen;
  auto scans = std::make_unique<Scans>(9, true, seen);
  scans->fail_after(3);
  LiveRecording recording(std::move(scans), {});
  EXPECT_EQ(stamps_used(recording), (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_THROW(recording.rethrow_failure(), io::WriteError);
  EXPECT_NO_THROW(recording.rethrow_failure());
}

TEST(LiveRecording, EndsWhenItIsStopped) {
  Seen seen;
  seen.allowed = 1;
  std::atomic<bool> stopped = false;
  LiveOptions options;
  options.stopped = [&] { return stopped.load(); };
  LiveRecording recording(std::make_unique<Scans>(9, true, seen), options);
  ASSERT_TRUE(recording.next());
  stopped = true;
  EXPECT_FALSE(recording.next());
}

class LiveRecordingLog : public test::Scratch {};

TEST_F(LiveRecordingLog, HasTheFateOfEveryScan) {
  Seen seen;
  LiveOptions options;
  options.queue = 2;
  LiveRecording recording(std::make_unique<Scans>(4, false, seen), options);
  wait_for_end(seen);
  stamps_used(recording);
  const std::filesystem::path file = folder_ / "live.log";
  recording.log().open(file);
  EXPECT_EQ(used_scans(file).used, (std::vector<std::int64_t>{3, 4}));
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_NE(text.find("dropped"), std::string::npos) << text;
}

// They are looked for by bisection.
TEST_F(LiveRecordingLog, ResetsAreInTheOrderOfTheirStamps) {
  const std::filesystem::path file = folder_ / "live.log";
  LiveLog log;
  log.open(file);
  for (const std::int64_t stamp_ns : {900, 500, 100}) {  // the sensor's clock is set back
    log.reset();
    log.used(stamp_ns, "scan", 1.0);
  }
  EXPECT_EQ(used_scans(file).reset_before, (std::vector<std::int64_t>{100, 500, 900}));
}

TEST_F(LiveRecordingLog, AFileThatIsNoneIsToldWithoutItsRawBytes) {
  const std::filesystem::path file = folder_ / "live.log";
  std::ofstream(file) << "\xff\x01"
                         "ELF\n";
  try {
    (void)used_scans(file);
    FAIL() << "it is no log";
  } catch (const io::ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("got '??ELF'"), std::string::npos) << error.what();
  }
}

TEST_F(LiveRecordingLog, AResetIsBeforeOneScanAndALineThatIsBeingWrittenIsNone) {
  const std::filesystem::path file = folder_ / "live.log";
  std::ofstream(file) << "stamp_ns,scan,fate,latency_ms\n0,,reset,\n100,a,used,1.000\n"
                         "200,b,dropped,\n300,c,used,1.000\n40";
  const UsedScans scans = used_scans(file);
  EXPECT_EQ(scans.used, (std::vector<std::int64_t>{100, 300}));
  EXPECT_EQ(scans.reset_before, std::vector<std::int64_t>{100});
}

}  // namespace
}  // namespace surefoot::live
