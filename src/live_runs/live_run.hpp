// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A run on what comes as it comes: the same folder as of a run on a recording, and a log by which
// it can be repeated.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "live/command_queue.hpp"
#include "live/live_input.hpp"
#include "live/live_recording.hpp"
#include "live/live_viewer.hpp"
#include "runs/odometry_run.hpp"
#include "runs/run_options.hpp"

namespace surefoot::live_runs {

struct LiveRequest {
  runs::RunOptions run;  ///< but its input, which the source names
  live::LiveSource source;
  live::LiveOptions live;  ///< but what is called while it waits
};

/// Who is told what goes on.
struct LiveListener {
  std::function<void(const std::string& text)> say;       ///< what is worth a line
  std::function<void(const std::string& text)> complain;  ///< likewise of scans that cannot be read
  std::function<void(const live::LiveFigures&)> report;   ///< every ten seconds
  std::function<bool()> interrupted;  ///< true ends the stream: what was received is used
  /// Makes who watches the run; may be empty. Commands that the viewer puts into the queue are
  /// closed before it ends.
  std::function<std::unique_ptr<live::LiveViewer>(const std::string& title, live::CommandQueue&,
                                                  const live::LiveRecording&)>
      watch = {};
};

struct LiveOutcome {
  runs::RunOutcome run;
  live::LiveFigures figures;
  std::filesystem::path input;  ///< what it is called
  bool of_topic = false;        ///< messages, not packets
};

/// Runs until the source ends, is silent for too long, or is interrupted. Commands of others
/// (pause, resume, reset, save_map, localize) are done between two scans. Throws ConfigError,
/// io::ReadError, std::runtime_error.
[[nodiscard]] LiveOutcome run_live(LiveRequest request, const LiveListener& listener);

}  // namespace surefoot::live_runs
