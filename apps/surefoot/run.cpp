// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot run: a recording in, trajectory and map out.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "quantile.hpp"
#include "report_maker.hpp"
#include "run_options.hpp"
#include "run_output.hpp"

namespace surefoot::app {

namespace {

constexpr int kInterrupted = 130;  // what shells give for Ctrl-C

/// What the last lines on the terminal tell.
struct Tally {
  std::map<Status, std::size_t> statuses;
  std::vector<double> milliseconds;
  double length = 0.0;  // [m]
  std::size_t unreadable = 0;
  std::size_t partial = 0;

  [[nodiscard]] std::size_t count(Status status) const {
    const auto found = statuses.find(status);
    return found == statuses.end() ? 0 : found->second;
  }
  [[nodiscard]] std::size_t scans() const { return milliseconds.size(); }
  [[nodiscard]] std::size_t untrusted() const {
    return count(Status::too_few_matches) + count(Status::diverged) + count(Status::rejected);
  }
};

/// One run from the first scan to the last file.
class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_(options),
        config_(make_config(options)),
        recording_(dataset::open_recording(options.input, options.reader)),
        odometry_(config_, options.threads),
        T_lidar_written_(written_frame(options, config_)),
        map_(options.map_voxel),
        progress_("scans", options.quiet) {
    odometry_.set_step_observer([this](Step step) { times_.begin(step); });
  }

  int execute();

 private:
  void say(const std::string& text) {
    progress_.finish();
    if (!options_.quiet) fmt::print(stderr, "{}\n", text);
  }
  void say_new_notes();
  [[nodiscard]] std::optional<dataset::ScanItem> first_scan();
  void process(const dataset::ScanItem& item, RunOutput& output);
  [[nodiscard]] double progress(std::size_t done) const;
  void write_page(const std::filesystem::path& folder);
  void report(const RunOutput& output, bool interrupted);

  const RunOptions& options_;
  const Config config_;
  std::unique_ptr<dataset::Recording> recording_;
  Odometry odometry_;
  Pose T_lidar_written_;
  MapBuilder map_;
  Progress progress_;
  StepTimes times_;
  Tally tally_;
  std::vector<std::string> notes_;      ///< the recording's that were said
  std::vector<std::string> own_notes_;  ///< the run's
  Status last_status_ = Status::ok;
  std::int64_t first_stamp_ns_ = 0;
};

void Run::say_new_notes() {
  const std::vector<std::string>& all = recording_->notes();
  for (; notes_.size() < all.size(); notes_.push_back(all[notes_.size()])) {
    say("note: " + all[notes_.size()]);
  }
}

/// The scan that the map begins with. A capture hardly ever begins where a revolution does; the
/// part of one that it begins with shows the next scan too little, and is left out unless it is all
/// there is.
std::optional<dataset::ScanItem> Run::first_scan() {
  recording_->skip(options_.start);
  auto first = recording_->next();
  if (!first || first->remark.empty()) return first;
  auto second = recording_->next();
  if (!second) return first;
  ++tally_.partial;
  own_notes_.push_back(fmt::format("left out: {}: {}", first->name, first->remark));
  say(own_notes_.back());
  return second;
}

double Run::progress(std::size_t done) const {
  if (const auto size = recording_->size()) {
    const std::size_t left = *size > options_.start ? *size - options_.start : 1;
    const std::size_t total =
        std::min((left + options_.stride - 1) / options_.stride, options_.count);
    return static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(total, 1));
  }
  return recording_->progress();
}

void Run::process(const dataset::ScanItem& item, RunOutput& output) {
  if (!item.scan) {
    ++tally_.unreadable;
    say("left out: " + item.error);
    return;
  }
  times_.reset();
  const Estimate estimate = odometry_.add_scan(*item.scan);
  if (tally_.scans() == 0) first_stamp_ns_ = estimate.stamp_ns;
  output.add(item.name, estimate, T_lidar_written_, times_);
  if (estimate.trusted() && !options_.no_map) {
    const double seconds = 1e-9 * static_cast<double>(estimate.stamp_ns - first_stamp_ns_);
    map_.forget(odometry_.emptied_cubes(), seconds);
    map_.add(odometry_.deskewed_scan(), estimate.T_map_lidar, seconds);
  }
  const bool serious = !estimate.trusted() || estimate.status == Status::first_scan;
  if (serious && estimate.status != last_status_) {
    say(fmt::format("{}: {}: {}", item.name, to_string(estimate.status), estimate.message));
  }
  last_status_ = estimate.status;
  ++tally_.statuses[estimate.status];
  tally_.milliseconds.push_back(times_.total());
  const Trajectory& path = output.trajectory();
  if (estimate.status != Status::rejected && path.size() > 1) {
    tally_.length += (path.back().pose.translation - path[path.size() - 2].pose.translation).norm();
  }
}

int Run::execute() {
  InterruptGuard interrupt;
  auto item = first_scan();  // before the folder is made: bad input leaves nothing behind
  if (!item) {
    throw dataset::ReadError(
        fmt::format("{}: no scans after the first {}", options_.input.string(), options_.start));
  }
  RunOutput output(options_);
  std::size_t done = 0;
  while (item && !interrupt.interrupted()) {
    say_new_notes();
    process(*item, output);
    ++done;
    progress_.update(done, progress(done));
    if (done == options_.count) break;
    recording_->skip(options_.stride - 1);
    item = recording_->next();
  }
  progress_.finish();
  say_new_notes();
  const bool interrupted = interrupt.interrupted();
  std::vector<std::string> notes = notes_;
  notes.insert(notes.end(), own_notes_.begin(), own_notes_.end());
  map_.drop_forgotten();
  output.finish(options_, config_,
                {recording_->description(), notes, odometry_.level().message, tally_.scans(),
                 tally_.untrusted(), interrupted},
                map_);
  write_page(output.folder());
  report(output, interrupted);
  if (output.trajectory().empty()) {
    throw dataset::ReadError(
        fmt::format("{}: none of {} scans could be used; scans.csv in {} says why for each",
                    options_.input.string(), done, output.folder().string()));
  }
  return interrupted ? kInterrupted : 0;
}

/// The page is an extra: without it the run is whole all the same.
void Run::write_page(const std::filesystem::path& folder) {
  if (options_.no_report || !has_report_page()) return;
  try {
    ReportMaker maker;
    maker.add_run(folder);
    write_report(maker.take({}), folder / "report.html");
  } catch (const std::exception& error) {
    say(fmt::format("no report.html: {}", error.what()));
  }
}

void Run::report(const RunOutput& output, bool interrupted) {
  if (options_.quiet) return;
  if (interrupted) fmt::print("interrupted: what was done up to here is written\n");
  fmt::print("{} scans, {:.1f} m; per scan {:.1f} ms median, {:.1f} ms p99, {} thread{}\n",
             tally_.scans(), tally_.length, quantile(tally_.milliseconds, 0.5),
             quantile(tally_.milliseconds, 0.99), options_.threads,
             options_.threads == 1 ? "" : "s");
  for (const auto& [status, count] : tally_.statuses) {
    if (status != Status::ok) fmt::print("  {:5} {}\n", count, to_string(status));
  }
  if (tally_.partial > 0) fmt::print("  {:5} partial, left out\n", tally_.partial);
  if (tally_.unreadable > 0) fmt::print("  {:5} unreadable\n", tally_.unreadable);
  fmt::print("results: {}\n", output.folder().string());
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Turn a recording into a trajectory and a map");
  add_run_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = Run(*options).execute(); });
}

}  // namespace surefoot::app
