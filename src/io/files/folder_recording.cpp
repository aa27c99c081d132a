// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/folder_recording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <tuple>
#include <utility>

#include "io/all_fields.hpp"
#include "io/ascii_values.hpp"
#include "io/decimal_time.hpp"
#include "io/file_reader.hpp"
#include "io/files/folder_listing.hpp"
#include "io/files/kitti_bin.hpp"
#include "io/files/scan_files.hpp"
#include "io/scan_builder.hpp"
#include "io/stamps.hpp"

namespace surefoot::io {
namespace {

constexpr double kAssumedRateHz = 10.0;

class FolderRecording final : public Recording {
 public:
  FolderRecording(FolderListing listing, bool is_folder, OpenOptions options)
      : listing_(std::move(listing)), is_folder_(is_folder), options_(std::move(options)) {
    read_stamps_file();
    find_point_time_rule();
    set_other_stamps();
  }

  std::optional<ScanItem> next() override {
    if (next_ >= listing_.files.size()) {
      return std::nullopt;
    }
    const std::size_t index = next_++;
    ScanItem item;
    item.name = listing_.files[index].filename().string();
    try {
      read_scan(index, item);
    } catch (const ReadError& error) {
      item.error = listing_.files[index].string() + ": " + error.what();
    } catch (const std::bad_alloc&) {
      item.error = listing_.files[index].string() + ": takes more memory than there is";
    }
    return item;
  }

  std::optional<std::size_t> size() const override { return listing_.files.size(); }
  void skip(std::size_t scans) override { next_ += std::min(scans, listing_.files.size() - next_); }
  double progress() const override {
    return static_cast<double>(next_) / static_cast<double>(listing_.files.size());
  }
  const std::vector<std::string>& notes() const override { return notes_; }
  std::string description() const override {
    return is_folder_ ? "folder of " + std::to_string(listing_.files.size()) + " " +
                            name_of(listing_.kind) + " files"
                      : std::string("one ") + name_of(listing_.kind) + " file";
  }

 private:
  void read_stamps_file() {
    const std::filesystem::path file = options_.stamps_file.empty() && is_folder_
                                           ? find_stamps_file(listing_.folder, options_.stamps_name)
                                           : options_.stamps_file;
    if (file.empty()) {
      return;
    }
    std::string unit;
    try {
      read_whole_file(file, bytes_);
      stamps_ = parse_stamps(text_of(bytes_), &unit);
    } catch (const ReadError& error) {
      throw ReadError(file.string() + ": " + error.what());
    }
    if (stamps_.size() != listing_.files.size()) take_stamps_by_number(file);
    notes_.push_back("stamps: from " + file.filename().string() + in_unit(unit));
  }

  // Of a recording some of whose scans are not here.
  void take_stamps_by_number(const std::filesystem::path& file) {
    const auto counted = [&](const std::string& between) {
      return std::to_string(stamps_.size()) + between + std::to_string(listing_.files.size()) +
             " scans";
    };
    auto named = stamps_of_frames(stamps_, listing_.files);
    if (!named) {
      throw ReadError(file.string() + ": " + counted(" stamps for the ") + " in " +
                      listing_.folder.string() + "; expected as many of both");
    }
    notes_.push_back(
        counted(" stamps, of frames 0, 1, ...; taken by their names' numbers those of ") +
        " that are here");
    stamps_ = std::move(*named);
  }

  // A few scans over the whole recording, the middle one first: the first is often cut short, and
  // its stamp may be zero.
  std::vector<std::size_t> scans_to_look_at() const {
    const std::size_t n = listing_.files.size();
    std::vector<std::size_t> indices = {n / 2, n - 1, 0, n / 4, n / 2 + n / 4};
    std::vector<std::size_t> once;
    for (const std::size_t index : indices) {
      if (std::find(once.begin(), once.end(), index) == once.end()) {
        once.push_back(index);
      }
    }
    return once;
  }

  // One scan whose times fit nothing does not refuse the others.
  void find_point_time_rule() {
    std::string first_error;
    for (const std::size_t index : scans_to_look_at()) {
      try {
        if (look_at_times(index)) break;
      } catch (const ReadError& error) {
        if (first_error.empty()) first_error = error.what();
      } catch (const std::bad_alloc&) {
        continue;  // said again when it is its turn
      }
    }
    if (rule_) {
      notes_.push_back(rule_text_);
    } else if (!first_error.empty()) {
      throw ReadError(first_error);
    }
  }

  // True where this scan settles the rule.
  bool look_at_times(std::size_t index) {
    PointTable table;
    ScanColumns columns;
    try {
      read_whole_file(listing_.files[index], bytes_);
      table = parse_scan_file(listing_.kind, bytes_);
      columns = find_scan_columns(table, options_);
    } catch (const ReadError&) {
      return false;  // said again when it is its turn
    }
    return columns.time != nullptr && look_at_times(index, table, columns);
  }

  bool look_at_times(std::size_t index, const PointTable& table, const ScanColumns& columns) {
    const TimeExtents extents = time_extents(table, columns);
    if (extents.count == 0) {
      return false;
    }
    const bool left_out = options_.time_direction == TimeDirection::none;
    try {
      const PointTimeRule rule =
          decide_point_time(extents, columns.time->type, given_stamp(index),
                            with_defined_unit(options_, table, *columns.time));
      // They may still be all that gives stamps.
      if (left_out && (given_stamp(index) || rule.reference == TimeReference::relative)) {
        return true;
      }
      if (!rule_ || knows_better(rule, *rule_)) {
        rule_ = rule;
        rule_text_ = describe_point_time(columns.time->name, columns.time->type, rule, extents);
      }
      return rule.certain && rule.unit_certain;
    } catch (const ReadError& error) {
      if (left_out) return false;
      throw ReadError(listing_.files[index].string() + ": field '" + columns.time->name +
                      "': " + error.what());
    }
  }

  // Where absolute times give it.
  std::optional<std::int64_t> stamp_of(std::size_t index) {
    ScanItem item;
    try {
      read_scan(index, item);
    } catch (const ReadError&) {
      return std::nullopt;  // said again when it is its turn
    } catch (const std::bad_alloc&) {
      return std::nullopt;
    }
    return item.scan->stamp_ns;
  }

  // Every file is read once more for it. One that has no stamp stays behind the one before it.
  void put_in_order_of_times() {
    std::vector<std::pair<std::int64_t, std::filesystem::path>> stamped;
    std::int64_t last = std::numeric_limits<std::int64_t>::min();
    for (std::size_t i = 0; i < listing_.files.size(); ++i) {
      last = stamp_of(i).value_or(last);
      stamped.emplace_back(last, listing_.files[i]);
    }
    const auto by_stamp = [](const auto& a, const auto& b) { return a.first < b.first; };
    if (std::is_sorted(stamped.begin(), stamped.end(), by_stamp)) return;
    std::stable_sort(stamped.begin(), stamped.end(), by_stamp);
    for (std::size_t i = 0; i < stamped.size(); ++i) listing_.files[i] = stamped[i].second;
    notes_.emplace_back("scans: in the order of these times, not of their names");
  }

  // "1644823589.41234" is before "1644823589.5", whatever natural order says.
  void put_in_order_of_stamps() {
    std::vector<std::pair<std::int64_t, std::filesystem::path>> stamped;
    for (std::size_t i = 0; i < stamps_.size(); ++i) {
      stamped.emplace_back(stamps_[i], listing_.files[i]);
    }
    std::stable_sort(stamped.begin(), stamped.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < stamped.size(); ++i) {
      std::tie(stamps_[i], listing_.files[i]) = stamped[i];
    }
  }

  static std::string in_unit(const std::string& unit) { return unit.empty() ? "" : ", in " + unit; }

  // Where no file gives stamps: the points themselves, names that are numbers, or a rate.
  void set_other_stamps() {
    if (!stamps_.empty() || find_stamps_of_scans()) {
      if (options_.rate_hz > 0.0 && options_.robot.empty()) {
        notes_.emplace_back(
            "stamps: not from the rate that was given, which only helps to mend them");
      }
    } else {
      count_stamps();
    }
  }

  bool find_stamps_of_scans() {
    if (rule_ && rule_->reference == TimeReference::absolute) {
      notes_.emplace_back("stamps: from the points' absolute times");
      if (!are_counted(listing_.files)) put_in_order_of_times();
      return true;
    }
    std::string unit;
    const auto named = stamps_from_names(listing_.files, &unit);
    if (!named) return false;
    stamps_ = *named;
    if (!are_counted(listing_.files)) put_in_order_of_stamps();
    notes_.push_back("stamps: from the file names" + in_unit(unit));
    return true;
  }

  void count_stamps() {
    const bool known = options_.rate_hz > 0.0;
    const double rate_hz = known ? options_.rate_hz : kAssumedRateHz;
    const auto numbers = frame_numbers(listing_.files);
    for (std::size_t i = 0; i < listing_.files.size(); ++i) {
      const auto frame = numbers ? static_cast<double>((*numbers)[i]) : static_cast<double>(i);
      stamps_.push_back(std::llround(frame * 1e9 / rate_hz));
    }
    if (listing_.files.size() > 1) {
      std::string text = known ? "stamps: from the rate that was given"
                               : "stamps: none found, 10 scans a second assumed";
      if (numbers) text += ", and the numbers of the files, some of which are missing";
      notes_.push_back(std::move(text));
    }
  }

  std::optional<std::int64_t> given_stamp(std::size_t index) const {
    return stamps_.empty() ? std::nullopt : std::optional(stamps_[index]);
  }

  void read_scan(std::size_t index, ScanItem& item) {
    read_whole_file(listing_.files[index], bytes_);
    const PointTable table = parse_scan_file(listing_.kind, bytes_);
    item.layout = table.layout();
    const ScanColumns columns = find_scan_columns(table, options_);
    if (columns.time != nullptr && !rule_) look_at_times(index, table, columns);
    BuiltScan built = build_scan(table, columns, rule_, given_stamp(index), options_.stamp_at);
    item.dropped_points = built.dropped_points;
    item.dropped_not_finite = built.dropped_not_finite;
    item.dropped_zero = built.dropped_zero;
    if (options_.further_fields) take_all_fields(table, columns, built, item);
    item.rounded_by = built.rounded_by;
    item.clock = built.clock;
    if (options_.kitti_hdl64_correction) {
      correct_kitti_hdl64(built.scan.points);
    }
    item.scan = std::move(built.scan);
  }

  FolderListing listing_;
  bool is_folder_;
  OpenOptions options_;
  std::vector<std::int64_t> stamps_;  ///< empty: absolute point times give them
  std::optional<PointTimeRule> rule_;
  std::string rule_text_;
  std::vector<std::string> notes_;
  std::vector<std::byte> bytes_;  ///< of the file being read
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<Recording> open_scan_files(const std::filesystem::path& path,
                                           const OpenOptions& options) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return std::make_unique<FolderRecording>(list_folder(path, options.format), true, options);
  }
  FolderListing listing;
  listing.folder = path.parent_path();
  listing.kind = scan_kind(kind_of(path)).value();
  listing.files = {path};
  return std::make_unique<FolderRecording>(std::move(listing), false, options);
}

}  // namespace surefoot::io
