// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_runs/live_run.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <utility>

#include "live/live_health.hpp"
#include "runs/run_bag.hpp"
#include "runs/run_files.hpp"
#include "text/printable.hpp"

namespace surefoot::live_runs {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// `run` is null until the first scan has come.
live::CommandAnswer execute(const std::string& command, live::LiveRecording& recording,
                            runs::RunControl* run) {
  if (command == "pause" || command == "resume") {
    recording.pause(command == "pause");
    return {true, command == "pause" ? "scans are left out" : "scans are used"};
  }
  if (run == nullptr) return {false, "no scan has come yet"};
  if (command == "save_map") return {true, fs::absolute(run->save_map()).string()};
  if (command == "localize" || command.starts_with("localize ")) {
    run->localize(command.substr(std::min<std::size_t>(command.size(), 9)));
    return {true, "its place in the map is searched for"};
  }
  if (command != "reset") return {false, command + " is not known"};
  recording.log().reset();
  run->reset();
  return {true, "the odometry begins anew with the next scan"};
}

/// The log names the scans that were used: what else chooses among them has been done.
void repeat_by(const fs::path& log, runs::OptionTexts& given) {
  std::erase_if(given, [](const auto& option) {
    return option.first == "start" || option.first == "stride" || option.first == "count";
  });
  given.emplace_back("like", fs::absolute(log).string());
}

/// Opens what the run reads from; what names and repeats it is noted in the run's options.
live::LiveInput open_input(LiveRequest& request, live::CommandQueue& commands,
                           const LiveListener& listener) {
  live::LiveInput input = live::open_live_input(
      request.source, request.run.reader, commands,
      [&listener](const std::string& text) { listener.say("note: " + text::printable(text)); });
  request.run.input = input.path;
  request.run.is_live = !input.is_kept;
  std::copy(input.repeated_by.begin(), input.repeated_by.end(),
            std::back_inserter(request.run.given));
  return input;
}

}  // namespace

LiveOutcome run_live(LiveRequest request, const LiveListener& listener) {
  (void)runs::config_of(request.run);  // what is wrong with it is told before anything is opened
  live::CommandQueue commands;
  live::LiveInput input = open_input(request, commands, listener);
  std::function<void()> work;
  std::optional<live::HealthPublisher> publisher;
  std::function<void()> tell_health = [] {};
  request.live.stopped = listener.interrupted;
  request.live.idle = [&] {
    work();
    tell_health();
  };
  live::LiveRecording recording(std::move(input.stream), request.live);
  const auto work_for = [&](runs::RunControl* run) {
    work = [&, run] {
      commands.work([&](const std::string& one) { return execute(one, recording, run); });
    };
  };
  work_for(nullptr);
  if (input.messages) {
    (void)runs::add_run_topics(*input.messages);
    publisher.emplace(input.messages);
    tell_health = [&] { publisher->tell(recording.figures()); };
  }
  std::unique_ptr<live::LiveViewer> viewer;
  if (listener.watch) {
    viewer = listener.watch(request.run.input.filename().string(), commands, recording);
  }
  const auto answered = [&](const std::string& name, const Estimate& estimate,
                            const Odometry& odometry) {
    recording.answered();
    if (viewer) viewer->answered(name, estimate, odometry);
  };
  // Whoever still waits for an answer is told before the server that waits for it ends.
  const std::shared_ptr<void> at_end(nullptr, [&](void*) { commands.close(); });

  Clock::time_point told = Clock::now();
  const auto progress = [&](std::size_t, double) {
    const double latency_ms = recording.done();
    if (viewer) viewer->used(latency_ms);
    work();
    tell_health();
    constexpr auto kPeriod = std::chrono::seconds(10);
    if (Clock::now() - told < kPeriod) return;
    told = Clock::now();
    listener.report(recording.figures());
  };
  const auto started = [&](const fs::path& folder, runs::RunControl& run) {
    work_for(&run);
    const fs::path log = folder / runs::kLiveLogFile;
    recording.log().open(log);
    repeat_by(log, request.run.given);
  };
  // An interrupt ends the stream, not the run.
  runs::RunOutcome outcome = runs::run_odometry(request.run,
                                                {.say = listener.say,
                                                 .progress = progress,
                                                 .interrupted = [] { return false; },
                                                 .started = started,
                                                 .answered = answered,
                                                 .messages = input.messages,
                                                 .complain = listener.complain},
                                                recording);
  recording.rethrow_failure();  // its files are whole: a full disk's record costs no map
  return {std::move(outcome), recording.figures(), request.run.input, input.of_topic};
}

}  // namespace surefoot::live_runs
