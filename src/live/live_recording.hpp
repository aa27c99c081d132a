// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A stream of scans as a recording that grows while it is read. A thread of its own receives, so
// that nothing is lost while a scan is registered; scans wait in a short queue, and where they come
// faster than they are used the oldest one goes: what is used is as fresh as can be.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "io/recording.hpp"
#include "live/live_log.hpp"
#include "live/scan_stream.hpp"

namespace surefoot::live {

struct LiveOptions {
  std::size_t queue = 2;          ///< scans that may wait
  double silence = 0.0;           ///< [s] of it that end the run, once there was something; 0: none
  std::function<void()> idle;     ///< called ten times a second while next() waits; may be empty
  std::function<bool()> stopped;  ///< asked ten times a second; true ends the stream in good order
};

/// Of a live run so far.
struct LiveFigures {
  std::size_t received = 0;  ///< datagrams or messages
  std::uint64_t lost = 0;    ///< of them, before they were received
  io::CaptureCounts packets;
  std::size_t used = 0;     ///< scans
  std::size_t dropped = 0;  ///< scans that waited for too long
  std::size_t paused = 0;   ///< scans that came during a pause
  bool is_paused = false;
  double silent_s = 0.0;       ///< since a scan came, or it began
  std::size_t unreadable = 0;  ///< messages that no scan could be made of
  std::vector<double>
      latencies_ms;  ///< from a used scan's last packet to answered(); the last 100,000
};

class LiveRecording final : public io::Recording {
 public:
  /// Begins to receive.
  LiveRecording(std::unique_ptr<ScanStream> stream, LiveOptions options);
  ~LiveRecording() override;
  LiveRecording(const LiveRecording&) = delete;
  LiveRecording& operator=(const LiveRecording&) = delete;

  /// Waits for a scan; nothing once the stream has ended and all that waited was used. Throws what
  /// went wrong while receiving if no scan came before that; else the run has an end, and
  /// rethrow_failure() the reason of it.
  [[nodiscard]] std::optional<io::ScanItem> next() override;
  [[nodiscard]] std::optional<std::size_t> size() const override { return std::nullopt; }
  void skip(std::size_t scans) override;
  [[nodiscard]] double progress() const override { return 0.0; }
  [[nodiscard]] const std::vector<std::string>& notes() const override;
  [[nodiscard]] std::string description() const override;
  [[nodiscard]] io::CaptureCounts capture_counts() const override { return figures().packets; }

  /// Throws, once, what went wrong while receiving.
  void rethrow_failure();
  /// To be called when the pose of the scan that next() gave last is written and published: what
  /// is done with the scan after that does not count as its latency.
  void answered();
  /// To be called when that scan was used. What it took from its last packet to answered(), or, if
  /// that was not called, until now [ms].
  double done();
  /// Scans that come during a pause are not used.
  void pause(bool paused);
  [[nodiscard]] LiveFigures figures() const;
  [[nodiscard]] LiveLog& log() { return log_; }

 private:
  struct Given {
    std::int64_t stamp_ns = 0;
    std::string name;
    std::chrono::steady_clock::time_point received;
    std::optional<std::chrono::steady_clock::time_point> answered;
  };

  void run();
  void receive_all();
  [[nodiscard]] bool goes_on();
  void take_state();
  void enqueue(LiveScan scan);

  std::unique_ptr<ScanStream> stream_;  ///< the thread's
  LiveOptions options_;
  LiveLog log_;

  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  StreamState state_;
  std::deque<LiveScan> queue_;
  LiveFigures figures_;
  std::chrono::steady_clock::time_point last_scan_ = std::chrono::steady_clock::now();
  std::size_t next_latency_ = 0;
  std::vector<std::string> notes_;
  std::size_t stream_notes_ = 0;  ///< of the stream's, that are among them
  bool ended_ = false;
  bool paused_ = false;
  bool abandoned_ = false;  ///< nobody will ask for more
  std::exception_ptr failure_;

  // The reader's own.
  std::optional<Given> given_;
  bool has_given_ = false;
  mutable std::vector<std::string> notes_given_;

  std::thread thread_;
};

}  // namespace surefoot::live
