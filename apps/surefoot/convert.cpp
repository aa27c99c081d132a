// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot convert: the scans of a recording to another format.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <set>

#include "commands.hpp"
#include "io/file_writer.hpp"
#include "io/printable.hpp"
#include "io/scan_sink.hpp"
#include "option_checks.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "process/progress.hpp"
#include "reader_options.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::app {

namespace {

namespace fs = std::filesystem;

struct ConvertOptions {
  fs::path input;
  fs::path output;
  io::OpenOptions reader;
  io::SinkOptions sink;
  std::string format;  ///< empty: by the output's name
  double begin = 0.0;  ///< [s] after the first scan's stamp
  double end = std::numeric_limits<double>::infinity();
  std::size_t start = 0;
  std::size_t count = std::numeric_limits<std::size_t>::max();
  std::size_t stride = 1;
  bool quiet = false;
};

io::ScanFormat format_of(const ConvertOptions& options) {
  if (!options.format.empty()) return io::scan_format_named(options.format);
  const fs::path extension = options.output.extension();
  if (extension == ".mcap") return io::ScanFormat::mcap;
  if (extension == ".bag") return io::ScanFormat::ros1_bag;
  if (extension.empty()) return io::ScanFormat::pcd;
  throw std::invalid_argument(
      fmt::format("{}: extension '{}'; expected .mcap, .bag, or a folder (PCD, or --to says what)",
                  options.output.string(), extension.string()));
}

/// One recording turned into another.
class Conversion {
 public:
  explicit Conversion(const ConvertOptions& options)
      : options_(options),
        format_(format_of(options)),
        recording_(io::open_recording(options.input, options.reader)),
        progress_("scans", options.quiet) {
    std::error_code ignored;
    const bool is_folder = io::is_folder(format_) && fs::is_directory(options.output, ignored);
    if (fs::exists(fs::symlink_status(options.output, ignored)) &&
        !(is_folder && fs::is_empty(options.output, ignored))) {
      throw std::invalid_argument(options.output.string() + ": is there already");
    }
  }

  int execute();

 private:
  void say(const std::string& text) {
    progress_.finish();
    if (!options_.quiet) fmt::print(stderr, "{}\n", text);
  }
  /// As `say`, also where only errors are to be printed.
  void complain(const std::string& text) {
    progress_.finish();
    fmt::print(stderr, "{}\n", text);
  }
  void open_output(const io::ScanItem& first);
  void add(const io::ScanItem& item);
  void tell_what_is_lost();
  /// False where the end of the time range is reached.
  bool use(const io::ScanItem& item);

  const ConvertOptions& options_;
  io::ScanFormat format_;
  std::unique_ptr<io::Recording> recording_;
  std::optional<io::UnfinishedOutput> output_;
  std::unique_ptr<io::ScanSink> sink_;
  process::Progress progress_;
  std::optional<std::int64_t> first_ns_;
  std::size_t scans_ = 0;
  std::size_t points_ = 0;
  std::size_t unreadable_ = 0;
  std::size_t dropped_points_ = 0;
  std::size_t late_in_a_row_ = 0;
  std::set<std::string> unused_;  ///< fields, as scans have them
  double rounded_by_ = 0.0;       ///< [m]
};

// What is not asked for is the source's.
void Conversion::open_output(const io::ScanItem& first) {
  const io::SinkOptions usual;
  io::SinkOptions sink = options_.sink;
  if (sink.topic.empty()) sink.topic = recording_->topic();
  if (sink.topic.empty()) sink.topic = usual.topic;
  if (sink.frame.empty()) sink.frame = first.frame;
  if (sink.frame.empty()) sink.frame = usual.frame;
  output_.emplace(options_.output, io::is_folder(format_));
  sink_ = io::make_scan_sink(output_->path(), format_, sink);
}

void Conversion::add(const io::ScanItem& item) {
  if (!sink_) open_output(item);
  sink_->add(*item.scan);
  ++scans_;
  points_ += item.scan->points.size();
  dropped_points_ += item.dropped_points;
  rounded_by_ = std::max(rounded_by_, item.rounded_by);
  constexpr std::size_t kMostNamed = 10;
  if (!item.unused.empty() && unused_.size() < kMostNamed) unused_.insert(item.unused);
  progress_.update(scans_, recording_->progress());
}

void Conversion::tell_what_is_lost() {
  if (!sink_->lost().empty()) say("lost: " + sink_->lost());
  for (const std::string& fields : unused_) {
    say("lost: fields that are not written: " + io::printable(fields));
  }
  if (rounded_by_ > 0.0) {
    say(fmt::format("lost: coordinates become floats, which changes them by up to {:.2g} m",
                    rounded_by_));
  }
  if (dropped_points_ > 0) {
    say(fmt::format("left out: {} points without a usable time", dropped_points_));
  }
}

bool Conversion::use(const io::ScanItem& item) {
  if (!item.scan) {
    ++unreadable_;
    complain("left out: " + io::printable(item.error));
    return true;
  }
  if (!first_ns_) first_ns_ = item.scan->stamp_ns;
  const double at = seconds(item.scan->stamp_ns - *first_ns_);
  if (at < options_.begin) return true;
  // A single wild stamp is not the end.
  constexpr std::size_t kSurelyLate = 20;
  if (at > options_.end) return ++late_in_a_row_ < kSurelyLate;
  late_in_a_row_ = 0;
  add(item);
  return true;
}

int Conversion::execute() {
  const process::InterruptGuard interrupt;
  recording_->skip(options_.start);
  std::optional<io::ScanItem> item = recording_->next();
  while (item && !interrupt.interrupted() && use(*item) && scans_ < options_.count) {
    recording_->skip(options_.stride - 1);
    item = recording_->next();
  }
  if (!sink_ && interrupt.interrupted()) {
    complain("interrupted before the first scan; nothing is written");
    return process::kInterrupted;
  }
  if (!sink_) {
    throw io::ReadError(options_.input.string() + ": no scan in what is asked for");
  }
  sink_->finish();
  output_->finish();
  progress_.finish();
  for (const std::string& note : recording_->notes()) say("note: " + io::printable(note));
  tell_what_is_lost();
  if (!options_.quiet) {
    fmt::print("{} scans, {} points: {}\n", scans_, points_, options_.output.string());
    if (unreadable_ > 0) fmt::print("  {:5} unreadable\n", unreadable_);
  }
  if (interrupt.interrupted()) return process::kInterrupted;
  return unreadable_ > 0 ? process::kSomeFailed : process::kDone;
}

}  // namespace

void add_convert_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "Write a recording's scans in another format");
  command->add_option("input", options->input, "any recording that 'surefoot run' takes")
      ->required();
  command->add_option("output", options->output, "FILE.mcap, FILE.bag (ROS 1), or a folder")
      ->required();
  command->add_option("--to", options->format, "format (by the output's name; a folder: pcd)")
      ->check(CLI::IsMember(io::scan_format_names()));
  command
      ->add_option("--begin", options->begin, "leave out what is before [s after the first scan]")
      ->check(number_within(0.0, 1e9));
  command->add_option("--end", options->end, "leave out what is after [s after the first scan]")
      ->check(number_within(0.0, 1e9));
  command->add_option("--start", options->start, "scans to pass over at first")
      ->check(whole_number(0));
  command->add_option("--count", options->count, "scans to write at most")->check(whole_number(1));
  command->add_option("--stride", options->stride, "every n-th scan")->check(whole_number(1));
  options->sink.topic.clear();
  options->sink.frame.clear();
  command->add_option("--out-topic", options->sink.topic,
                      "topic in a bag (the source's, else /points)");
  command->add_option("--frame", options->sink.frame, "frame in a bag (the source's, else lidar)");
  command->add_flag("-q,--quiet", options->quiet, "print errors only");
  add_reader_options(*command, options->reader);
  command->callback([options, &exit_code] { exit_code = Conversion(*options).execute(); });
}

}  // namespace surefoot::app
