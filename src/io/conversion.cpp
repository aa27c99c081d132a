// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/conversion.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "io/file_writer.hpp"
#include "io/printable.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

// What the endings of outputs that are no formats' are better called.
std::string advice_for(const fs::path& extension) {
  if (extension == ".db3") return "; a ROS 2 bag is a folder: FOLDER --to rosbag2";
  if (extension == ".zst" || extension == ".zstd") {
    return "; an .mcap is compressed inside, and of another 'zstd FILE' makes one";
  }
  if (extension == ".pcap" || extension == ".pcapng") {
    return "; points cannot be turned back into packets, and packets are not copied: 'editcap' "
           "cuts a "
           "capture";
  }
  if (extension == ".laz") return "; LAZ is not written: .las, and 'laszip' makes one of it";
  return "";
}

ScanFormat wanted_format(const ConversionRequest& request) {
  if (!request.format.empty()) return scan_format_named(request.format);
  const fs::path extension = request.output.extension();
  if (extension.empty()) return ScanFormat::pcd;
  const std::string name = extension.string().substr(1);
  const std::vector<std::string>& names = scan_format_names();
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  if (known && name != "rosbag2") return scan_format_named(name);
  throw std::invalid_argument(
      request.output.string() + ": extension '" + extension.string() +
      "'; expected .mcap, .bag, .pcd, .ply, .bin, .las, or a folder (PCD, " + "or --to says what)" +
      advice_for(extension));
}

// Called as the files of its format are.
bool is_one_file(const ConversionRequest& request, ScanFormat format) {
  const std::string& name = scan_format_names()[static_cast<std::size_t>(format)];
  return has_file_a_scan(format) && request.output.extension() == "." + name;
}

std::unique_ptr<Recording> open_with_all_fields(const ConversionRequest& request) {
  OpenOptions options = request.reader;
  options.further_fields = true;
  return open_recording(request.input, options);
}

/// One recording turned into another.
class Conversion {
 public:
  Conversion(const ConversionRequest& request, const ConversionListener& listener)
      : request_(request),
        listener_(listener),
        format_(wanted_format(request)),
        one_file_(is_one_file(request, format_)),
        recording_(open_with_all_fields(request)) {
    std::error_code ignored;
    const bool is_empty_folder = is_folder(format_) && !one_file_ &&
                                 fs::is_directory(request.output, ignored) &&
                                 fs::is_empty(request.output, ignored);
    if (fs::exists(fs::symlink_status(request.output, ignored)) && !is_empty_folder) {
      throw std::invalid_argument(request.output.string() + ": is there already");
    }
  }

  ConversionOutcome execute();

 private:
  void open_output(const ScanItem& first);
  void leave_out(const std::string& why);
  void add(const ScanItem& item);
  /// False where the end of the time range is reached.
  bool use(const ScanItem& item);
  [[nodiscard]] std::vector<std::string> losses() const;

  const ConversionRequest& request_;
  const ConversionListener& listener_;
  ScanFormat format_;
  bool one_file_;
  std::unique_ptr<Recording> recording_;
  std::optional<UnfinishedOutput> output_;
  std::unique_ptr<ScanSink> sink_;
  ConversionOutcome outcome_;
  std::optional<std::int64_t> first_ns_;
  std::size_t dropped_points_ = 0, dropped_empty_ = 0;
  std::size_t late_in_a_row_ = 0;
  double rounded_by_ = 0.0;  ///< [m]
  std::set<std::string> field_losses_;
};

// What is not asked for is the source's.
void Conversion::open_output(const ScanItem& first) {
  const SinkOptions usual;
  SinkOptions sink = request_.sink;
  if (sink.topic.empty()) sink.topic = recording_->topic();
  if (sink.topic.empty()) sink.topic = usual.topic;
  if (sink.frame.empty()) sink.frame = first.frame;
  if (sink.frame.empty()) sink.frame = usual.frame;
  sink.one_file = one_file_;
  output_.emplace(request_.output, is_folder(format_) && !one_file_);
  sink_ = make_scan_sink(output_->path(), format_, sink);
}

void Conversion::leave_out(const std::string& why) {
  ++outcome_.unreadable;
  listener_.complain("left out: " + printable(why));
}

void Conversion::add(const ScanItem& item) {
  if (one_file_ && outcome_.scans > 0) {
    throw std::invalid_argument(
        request_.output.string() +
        ": holds one scan, and there are more: name a folder, or choose one "
        "with --start N --count 1");
  }
  if (!sink_) open_output(item);
  if (const std::string why = sink_->refusal(*item.scan, item.further); !why.empty()) {
    return leave_out(item.name + ": " + why);
  }
  sink_->add(*item.scan, item.further);
  ++outcome_.scans;
  outcome_.points += item.scan->points.size();
  dropped_points_ += item.dropped_points;
  dropped_empty_ += item.dropped_not_finite + item.dropped_zero;
  rounded_by_ = std::max(rounded_by_, item.rounded_by);
  constexpr std::size_t kMostLosses = 20;
  for (const std::string& loss : item.losses) {
    if (field_losses_.size() < kMostLosses) field_losses_.insert(loss);
  }
  listener_.progress(outcome_.scans, recording_->progress());
}

bool Conversion::use(const ScanItem& item) {
  if (!item.scan) {
    leave_out(item.error);
    return true;
  }
  if (!first_ns_) first_ns_ = item.scan->stamp_ns;
  const double at = seconds(item.scan->stamp_ns - *first_ns_);
  if (at < request_.begin) return true;
  // A single wild stamp is not the end.
  constexpr std::size_t kSurelyLate = 20;
  if (at > request_.end) return ++late_in_a_row_ < kSurelyLate;
  late_in_a_row_ = 0;
  add(item);
  return true;
}

std::vector<std::string> Conversion::losses() const {
  std::vector<std::string> lines;
  if (const std::string fields = sink_->lost(); !fields.empty()) {
    lines.push_back("lost: fields that the format does not hold: " + printable(fields));
  }
  std::istringstream remarks(sink_->remark());
  for (std::string line; std::getline(remarks, line);) lines.push_back(line);
  for (const std::string& loss : field_losses_) lines.push_back("lost: " + printable(loss));
  if (rounded_by_ > 0.0) {
    std::array<char, 32> metres;
    std::snprintf(metres.data(), metres.size(), "%.2g", rounded_by_);
    lines.push_back(std::string("lost: coordinates become floats, which changes them by up to ") +
                    metres.data() + " m");
  }
  if (dropped_points_ > 0) {
    lines.push_back("left out: " + std::to_string(dropped_points_) +
                    " points without a usable time");
  }
  if (dropped_empty_ > 0) {
    lines.push_back("left out: " + std::to_string(dropped_empty_) +
                    " points that are no returns and of no time of the sweep");
  }
  return lines;
}

ConversionOutcome Conversion::execute() {
  recording_->skip(request_.start);
  std::optional<ScanItem> item = recording_->next();
  while (item && !listener_.interrupted() && use(*item) && outcome_.scans < request_.count) {
    recording_->skip(request_.stride - 1);
    item = recording_->next();
  }
  outcome_.interrupted = listener_.interrupted();
  if (outcome_.scans == 0 && outcome_.interrupted) return std::move(outcome_);
  if (outcome_.scans == 0) {
    throw ReadError(request_.input.string() + ": no scan in what is asked for");
  }
  sink_->finish();
  output_->finish();
  outcome_.notes = recording_->notes();
  outcome_.losses = losses();
  return std::move(outcome_);
}

}  // namespace

ConversionOutcome convert_recording(const ConversionRequest& request,
                                    const ConversionListener& listener) {
  return Conversion(request, listener).execute();
}

}  // namespace surefoot::io
