// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/odometry_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "io/scan_selection.hpp"
#include "mapping/placed_scans.hpp"
#include "mapping/pose_graph_solver.hpp"
#include "mapping/walk_clock.hpp"
#include "process/machine.hpp"
#include "runs/input_checks.hpp"
#include "runs/localization_run.hpp"
#include "runs/loop_truth.hpp"
#include "runs/map_run.hpp"
#include "runs/output_checks.hpp"
#include "runs/output_folder.hpp"
#include "runs/report_maker.hpp"
#include "runs/run_account.hpp"
#include "runs/run_bag.hpp"
#include "runs/run_files.hpp"
#include "runs/run_output.hpp"
#include "runs/run_scans.hpp"
#include "runs/run_truth.hpp"
#include "runs/saved_map.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/reference.hpp"

namespace surefoot::runs {

namespace {

/// Of all the work, what is done by now and what will be after the present part of it.
struct Shares {
  double from = 0.0, to = 1.0;

  [[nodiscard]] double of(double part) const { return from + part * (to - from); }
};

// A reference's: the odometry takes about half the time, and the passes most of the rest.
constexpr Shares kOdometry{0.0, 0.5}, kPasses{0.5, 0.85}, kWriting{0.85, 1.0};

/// Without, the whole recording would be read for a map that cannot be finished.
void require_solver(const RunOptions& options) {
  const bool closes_loops = options.loop_closure && !options.no_loops;
  if ((!closes_loops && options.continued.empty()) || mapping::has_solver()) return;
  throw std::runtime_error(
      "this program was built without Ceres (SUREFOOT_CERES): loops cannot be closed, nor maps "
      "joined; surefoot map --no-loops makes one of the odometry's poses");
}

class OdometryRun final : public RunControl {
 public:
  OdometryRun(const RunOptions& options, const RunListener& listener, io::Recording& recording)
      : options_(options),
        listener_(listener),
        config_(config_of(options)),
        method_(method_of(options)),
        scans_(recording, options),
        odometry_(config_, options.threads),
        T_lidar_written_(written_frame(options, config_)),
        map_(options.map_voxel),
        account_(listener, outcome_) {
    observe();
  }

  [[nodiscard]] RunOutcome execute();
  void reset() override;
  std::filesystem::path save_map() override;
  void localize(const std::filesystem::path& map) override;

 private:
  void observe() {
    odometry_.set_step_observer([this](Step step) { times_.begin(step); });
  }
  [[nodiscard]] std::optional<io::ScanItem> first_scan();
  void for_all(std::optional<io::ScanItem> item,
               const std::function<void(const io::ScanItem&)>& use);
  void check_truth(const RunOutput& output);
  void know_all(Reference reference, std::optional<io::ScanItem>& item);
  void use(const io::ScanItem& item, RunOutput& output);
  [[nodiscard]] RunDescription description(const RunOutput& output) const;
  void open_bags();
  void begin_map();
  [[nodiscard]] std::exception_ptr finish_map();
  void write_page(const std::filesystem::path& folder);

  const RunOptions& options_;
  const RunListener& listener_;
  const Config config_;
  const std::string method_;
  RunScans scans_;
  Odometry odometry_;
  Pose T_lidar_written_;
  mapping::MapBuilder map_;
  StepTimes times_;
  std::vector<RunBag> bags_;
  std::optional<MapRun> map_run_;
  std::optional<mapping::SavedMap> continued_;
  std::optional<LocalizationRun> localization_;
  std::filesystem::path localized_in_;  ///< the map that was asked for last
  MapVersion localized_version_;
  RunOutcome outcome_;
  RunAccount account_;
  Shares shares_;          ///< what has been done, and is done after this
  int first_segment_ = 0;  ///< since it began anew
  int last_segment_ = -1;
  mapping::WalkClock clock_;     ///< of the scans in the map
  mapping::PlacedScans placed_;  ///< their frames
};

RunOutcome OdometryRun::execute() {
  require_solver(options_);
  check_outputs(options_);  // what needs no scan first: a live run's may be long in coming
  if (!options_.truth.empty()) (void)read_truth_poses(options_.truth);  // what is given must do
  if (!options_.localize.empty()) localize(options_.localize);
  if (!options_.continued.empty()) continued_ = read_saved_map(options_.continued);
  auto item = first_scan();  // before the folder is made: bad input leaves nothing behind
  check_first_scan(options_, item);
  refuse_past_truth(options_, item, scans_);
  std::optional<Reference> reference;
  if (options_.reference) reference.emplace(config_, options_.threads);
  RunOutput output(options_);
  outcome_.folder = output.folder().path();
  if (reference) know_all(std::move(*reference), item);
  outcome_.interrupted = listener_.interrupted();
  if (outcome_.interrupted) return std::move(outcome_);  // an earlier run's files stay
  output.begin(options_);
  if (output.folder().replaced()) {
    listener_.say(
        fmt::format("note: {}: an earlier run's files are replaced", outcome_.folder.string()));
  }
  if (localization_) localization_->open(outcome_.folder);
  if (listener_.started) listener_.started(outcome_.folder, *this);
  open_bags();
  begin_map();
  for_all(std::move(item), [&](const io::ScanItem& one) { use(one, output); });
  account_.say_notes_of(scans_.recording());
  map_ = map_.without_forgotten();
  const std::exception_ptr map_failed = map_run_ ? finish_map() : nullptr;
  check_truth(output);
  const RunDescription run = description(output);
  if (localization_) outcome_.localization = localization_->finish();
  output.finish(options_, run, map_, outcome_.map ? map_run_->drawn() : report::DrawnLoops{});
  for (RunBag& bag : bags_) bag.finish(run_yaml_text(run));
  outcome_.poses = output.poses();
  outcome_.length = output.length();
  outcome_.segments = std::max<std::size_t>(output.segments().size(), 1);
  outcome_.losses = scans_.recording().losses();
  write_page(outcome_.folder);
  if (map_failed) std::rethrow_exception(map_failed);
  return std::move(outcome_);
}

std::optional<io::ScanItem> OdometryRun::first_scan() {
  std::optional<io::ScanItem> item = scans_.first();
  if (scans_.left_out().empty()) return item;
  ++outcome_.partial;
  account_.note(scans_.left_out());
  listener_.say(scans_.left_out());
  return item;
}

/// What is not compared is said here, whether or not anybody looks at the picture.
void OdometryRun::check_truth(const RunOutput& output) {
  const std::filesystem::path file = truth_file(options_);
  const std::map<int, SegmentSpan>& measured = output.segments();
  if (file.empty() || measured.empty() || (options_.no_picture && options_.no_report)) return;
  SegmentSpan all = measured.begin()->second;  // who comes home goes on in an earlier segment
  for (const auto& [number, span] : measured) {
    all.first_ns = std::min(all.first_ns, span.first_ns);
    all.last_ns = std::max(all.last_ns, span.last_ns);
  }
  std::string why;
  try {
    why = other_times(file, read_truth_poses(file), all.first_ns, all.last_ns);
  } catch (const io::ReadError& error) {
    why = error.what();
  }
  if (why.empty()) return;
  account_.note(why);
  listener_.complain ? listener_.complain("note: " + why) : listener_.say("note: " + why);
}

void OdometryRun::for_all(std::optional<io::ScanItem> item,
                          const std::function<void(const io::ScanItem&)>& use) {
  std::size_t done = 0;
  while (item) {  // one at least, which is read by now
    account_.say_notes_of(scans_.recording());
    use(*item);
    ++done;
    listener_.progress(done, shares_.of(scans_.progress(done)));
    if (done == options_.count || listener_.interrupted()) break;
    item = scans_.next();
  }
  outcome_.interrupted = listener_.interrupted();
}

/// Reads all scans from the first on, and makes the odometry one that knows them all; then the
/// recording is at its first scan again.
void OdometryRun::know_all(Reference reference, std::optional<io::ScanItem>& item) {
  std::size_t scans = 0;
  shares_ = kOdometry;
  for_all(std::move(item), [&](const io::ScanItem& one) {
    ++scans;
    if (one.scan) reference.add_scan(*one.scan);
  });
  (void)reference.refine([&](double share) {
    listener_.progress(scans, kPasses.of(share));
    return !listener_.interrupted();
  });
  odometry_ = reference.replay();
  observe();
  shares_ = kWriting;
  account_.note("a reference: every scan against the map of all of them");
  for (const int segment : reference.unrefined()) {
    account_.note(
        fmt::format("segment {} stays as the odometry has it: all of its scans at once have no "
                    "solution",
                    segment));
  }
  scans_.begin_again(io::open_recording(options_.input, options_.reader));
  item = scans_.first();
}

void OdometryRun::use(const io::ScanItem& item, RunOutput& output) {
  if (!item.scan) {
    account_.leave_out(item);
    return;
  }
  const std::vector<std::int64_t>& resets = options_.reset_before;
  if (std::binary_search(resets.begin(), resets.end(), item.scan->stamp_ns)) reset();
  times_.reset();
  Estimate estimate = odometry_.add_scan(*item.scan);
  estimate.segment += first_segment_;
  last_segment_ = std::max(last_segment_, estimate.segment);
  output.add(item.name, estimate, T_lidar_written_, times_);
  if (!options_.no_report) output.add_sample(*item.scan, estimate);
  if (localization_) {
    localization_->add(estimate,
                       [&]() -> const DeskewedScan& { return odometry_.deskewed_scan(); });
  }
  for (RunBag& bag : bags_) {
    if (localization_) bag.place(localization_->T_map_world());
    bag.add(item.name, estimate, odometry_);
  }
  if (listener_.answered) listener_.answered(item.name, estimate, odometry_);
  if (estimate.trusted() && !options_.no_map) {
    const std::int64_t now_ns = clock_.next(estimate.stamp_ns);
    const mapping::MapBuilder::When when{now_ns - clock_.begin_ns(),
                                         static_cast<std::size_t>(placed_.next(estimate).frame)};
    const DeskewedScan& seen = odometry_.deskewed_scan();  // while the local map is added to
    map_.forget(odometry_.emptied_cubes(), when);
    map_.add(seen, estimate.T_world_lidar, when);
  }
  if (map_run_ && estimate.trusted()) {
    map_run_->add(estimate, T_lidar_written_, odometry_.deskewed_scan());
  }
  account_.add(item, estimate, times_.total());
}

void OdometryRun::reset() {
  if (last_segment_ < first_segment_) return;  // it has not begun
  odometry_ = Odometry(config_, options_.threads);
  observe();
  first_segment_ = last_segment_ + 1;
  listener_.say("reset: the odometry begins anew, in a segment of its own");
}

std::filesystem::path OdometryRun::save_map() {
  if (options_.no_map) throw std::invalid_argument("--no-map: no map is kept");
  write_map(outcome_.folder, map_.without_forgotten());
  return outcome_.folder / kMapFile;
}

void OdometryRun::localize(const std::filesystem::path& map) {
  const std::filesystem::path wanted = map.empty() ? localized_in_ : map;
  if (wanted.empty()) {
    throw std::invalid_argument("there is no map: --localize MAP, or name it: localize MAP");
  }
  MapVersion version = map_version(wanted);
  mapping::SavedMap saved = read_saved_map(wanted);
  if (localization_) {
    localization_->begin_anew(std::move(saved), version != localized_version_);
  } else {
    localization_.emplace(std::move(saved), T_lidar_written_);
    if (!outcome_.folder.empty()) localization_->open(outcome_.folder);
  }
  localized_in_ = wanted;
  localized_version_ = std::move(version);
}

RunDescription OdometryRun::description(const RunOutput& output) const {
  RunDescription run;
  run.version = options_.version.empty() ? SUREFOOT_VERSION : options_.version;
  run.command = options_.command;
  run.method = method_;
  run.input = options_.is_live ? options_.input.string()
                               : std::filesystem::absolute(options_.input).string();
  run.content = scans_.recording().description();
  run.notes = account_.notes();
  run.options = options_.given;
  run.scans = std::to_string(outcome_.scans());
  run.unreadable = std::to_string(outcome_.unreadable);
  run.untrusted = std::to_string(account_.untrusted());
  run.segments = segment_lines(output.segments());
  run.interrupted = outcome_.interrupted ? "true" : "false";
  run.level = odometry_.level().message;
  run.pose_of = options_.pose_of;
  run.processor = process::processor_name();
  run.cores = std::to_string(process::processor_cores());
  run.threads = std::to_string(options_.threads);
  run.compiler = __VERSION__;
  run.parameters = parameter_texts(config_);
  return run;
}

void OdometryRun::open_bags() {
  const bool of_base = options_.pose_of == "base";
  const std::optional<Pose> T_lidar_base = of_base ? std::optional(T_lidar_written_) : std::nullopt;
  if (!options_.mcap.empty()) bags_.emplace_back(io::make_mcap_bag(options_.mcap), T_lidar_base);
  if (!options_.rosbag2.empty()) {
    bags_.emplace_back(io::make_sqlite_bag(options_.rosbag2), T_lidar_base);
  }
  if (listener_.messages) bags_.emplace_back(listener_.messages, T_lidar_base);
}

void OdometryRun::begin_map() {
  if (!options_.loop_closure && options_.continued.empty()) return;
  mapping::MapperOptions options;
  options.close_loops = !options_.no_loops;
  options.loops.candidates = options_.loop_candidates;
  options.folder = outcome_.folder;
  map_run_.emplace(options, truth_of_loops(options_, listener_.say), std::move(continued_));
}

/// What went wrong, if anything did: the odometry's own results are written all the same.
std::exception_ptr OdometryRun::finish_map() {
  const bool save = options_.save_map || !options_.continued.empty();
  try {
    outcome_.map = map_run_->finish(outcome_.folder, map_, save);
  } catch (const std::exception& error) {
    account_.note(fmt::format("no map after loops: {}", error.what()));
    return std::current_exception();
  }
  const std::optional<JoinOutcome>& join = outcome_.map->join;
  if (join && !join->joined) {
    account_.note(
        fmt::format("{} is not continued: {}", options_.continued.string(), join->message));
  }
  return nullptr;
}

void OdometryRun::write_page(const std::filesystem::path& folder) {
  if (options_.no_report || !has_report_page()) return;
  try {
    ReportMaker maker(options_.truth);
    maker.add_run(folder);
    write_report(maker.take({}), folder / kReportFile);
  } catch (const std::exception& error) {
    listener_.say(
        outcome_.losses.emplace_back(fmt::format("no {}: {}", kReportFile, error.what())));
  }
}

}  // namespace

RunOutcome run_odometry(const RunOptions& options, const RunListener& listener) {
  (void)config_of(options);  // what is wrong with it is told before a long recording is opened
  refuse_run_folder(options.input);
  std::unique_ptr<io::Recording> recording = io::open_recording(options.input, options.reader);
  if (!options.only_stamps.empty()) {
    recording = io::select_scans(std::move(recording), options.only_stamps);
  }
  return run_odometry(options, listener, *recording);
}

RunOutcome run_odometry(const RunOptions& options, const RunListener& listener,
                        io::Recording& recording) {
  return OdometryRun(options, listener, recording).execute();
}

}  // namespace surefoot::runs
