// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/truth_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/decompositions.hpp"
#include "io/ascii_values.hpp"
#include "io/bags/bag_files.hpp"
#include "io/bags/motion_topics.hpp"
#include "io/column_names.hpp"
#include "io/decimal_time.hpp"
#include "io/file_reader.hpp"
#include "io/files/scan_files.hpp"
#include "io/stamps.hpp"
#include "io/trajectory_files.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string_view>;

constexpr double kEarth = 6378137.0;  // [m], as in KITTI's devkit
constexpr double kRadian = std::numbers::pi / 180.0;

double number_of(std::string_view word, std::size_t line) {
  double value = 0.0;
  if (!parse_real(word, value) || !std::isfinite(value)) {
    fail_at_line(line, in_quotes(word) + "; expected a finite number");
  }
  return value;
}

/// Of nine digits at most.
std::int64_t whole_number(std::string_view word, std::size_t line) {
  return static_cast<std::int64_t>(number_of(word, line));
}

/// What a table's rows begin with.
struct RowTimes {
  std::int64_t scale = 1;  ///< nanoseconds in a whole number's unit
  bool all_whole = false;  ///< and none is seconds
};

std::int64_t stamp_of(std::string_view word, std::size_t line, const RowTimes& times) {
  constexpr std::size_t kNanosecondDigits = 16;
  const bool whole = is_whole(word) && (times.all_whole || word.size() >= kNanosecondDigits);
  const std::optional<std::int64_t> stamp =
      whole ? parse_whole_time(word, times.scale) : parse_decimal_seconds(word);
  if (!stamp) fail_at_line(line, in_quotes(word) + "; expected a time");
  return *stamp;
}

Eigen::Vector3d position_of(const Words& words, std::size_t first, std::size_t line) {
  return {number_of(words[first], line), number_of(words[first + 1], line),
          number_of(words[first + 2], line)};
}

/// Nothing for 0 0 0 0.
std::optional<Eigen::Quaterniond> rotation_of(const Words& words, std::size_t first,
                                              std::size_t line) {
  const Eigen::Quaterniond rotation(
      number_of(words[first + 3], line), number_of(words[first], line),
      number_of(words[first + 1], line), number_of(words[first + 2], line));
  if (rotation.norm() == 0.0) return std::nullopt;
  if (std::abs(rotation.norm() - 1.0) > 0.01) {
    fail_at_line(line, "quaternion of length " + std::to_string(rotation.norm()) +
                           "; expected 1, or 0 0 0 0 where only the position is known");
  }
  return rotation.normalized();
}

void add_pose(Truth& truth, const Words& words, std::size_t first, std::size_t line,
              std::int64_t stamp_ns) {
  StampedPose pose;
  pose.stamp_ns = stamp_ns;
  pose.pose.translation = position_of(words, first, line);
  const bool positions_only = words.size() == first + 3;
  const auto rotation = positions_only ? std::nullopt : rotation_of(words, first + 3, line);
  truth.has_rotations = truth.has_rotations && rotation.has_value();
  pose.pose.rotation = rotation.value_or(Eigen::Quaterniond::Identity());
  truth.poses.push_back(pose);
}

/// Position and w x y z of the rotation, as EuRoC has them; what follows (there velocity and
/// biases) is left.
void add_w_first(Truth& truth, const Words& words, std::size_t first, std::size_t line,
                 std::int64_t stamp_ns) {
  const auto at = words.begin() + static_cast<std::ptrdiff_t>(first);
  Words pose(words.begin(), at + 3);
  pose.insert(pose.end(), {at[4], at[5], at[6], at[3]});
  add_pose(truth, pose, first, line, stamp_ns);
}

/// MulRan's, and not any 13 columns, as Boreas has them.
void add_stamped_matrix(Truth& truth, const Words& words, std::size_t line, const RowTimes& times) {
  try {
    truth.poses.push_back(
        {stamp_of(words[0], line, times), pose_of_kitti_row(std::span(words).subspan(1), line)});
  } catch (const ReadError& error) {
    throw ReadError(std::string(error.what()) +
                    "; of 13 columns expected a time and the rows of a 3x4 matrix (MulRan's)");
  }
}

void add_row(Truth& truth, const Words& words, std::size_t line, const RowTimes& times,
             bool w_first) {
  const auto add = w_first ? add_w_first : add_pose;
  switch (words.size()) {
    case 4:
      return add_pose(truth, words, 1, line, stamp_of(words[0], line, times));
    case 8:
      return add(truth, words, 1, line, stamp_of(words[0], line, times));
    case 9: {
      const bool whole = is_whole(words[0]) && is_whole(words[1]) && words[1].size() <= 9;
      const auto seconds = parse_decimal_seconds(words[0]);
      std::int64_t stamp = 0;
      if (!whole || !seconds ||
          __builtin_add_overflow(*seconds, whole_number(words[1], line), &stamp)) {
        fail_at_line(line, "9 columns that do not begin with seconds and nanoseconds");
      }
      return add(truth, words, 2, line, stamp);
    }
    case 12:
      truth.has_stamps = false;
      truth.poses.push_back(
          {static_cast<std::int64_t>(truth.poses.size()), pose_of_kitti_row(words, line)});
      return;
    case 13:
      return add_stamped_matrix(truth, words, line, times);
    case 17:
      return add_w_first(truth, words, 1, line, stamp_of(words[0], line, times));
    default:
      fail_at_line(line, std::to_string(words.size()) +
                             " columns; expected 4, 8, 9, 12, 13 or 17: times and poses");
  }
}

/// Calls `take` with the words and the number of every line but comments and the columns' names,
/// which one line at the top may have. Returns how many columns there are.
template <typename Take>
std::size_t for_each_row(std::string_view text, Take&& take) {
  std::size_t columns = 0;
  LineReader reader(text);
  for (std::string_view line; reader.next(line);) {
    const Words words = columns_of(line);
    if (words.empty() || words.front().starts_with('#')) continue;
    double ignored = 0.0;
    const bool names = columns == 0 && !parse_real(words.front(), ignored);
    if (columns == 0) columns = words.size();
    if (names) continue;
    if (words.size() != columns) {
      fail_at_line(reader.line_number(), std::to_string(words.size()) + " columns; expected " +
                                             std::to_string(columns) + " as before");
    }
    take(words, reader.line_number());
  }
  return columns;
}

std::string text_in(const fs::path& file) {
  std::vector<std::byte> bytes;
  read_whole_file(file, bytes);
  return std::string(text_of(bytes));
}

Truth read_table(const fs::path& file) {
  try {
    return parse_truth_table(text_in(file));
  } catch (const ReadError& error) {
    const std::string what = error.what();
    throw ReadError(what.starts_with(file.string()) ? what : file.string() + ": " + what);
  }
}

fs::path first_there(const std::vector<fs::path>& places) {
  std::error_code ignored;
  for (const fs::path& place : places) {
    if (fs::is_regular_file(place, ignored)) return place;
  }
  std::string text;
  for (const fs::path& place : places) text += (text.empty() ? "" : ", ") + place.string();
  throw ReadError("none of these is there: " + text);
}

/// The numbers behind "NAME:" in one of KITTI's calibration files.
std::vector<double> calibration(const fs::path& file, std::string_view name, std::size_t count) {
  const std::string text = text_in(file);
  LineReader reader(text);
  for (std::string_view line; reader.next(line);) {
    const Words words = columns_of(line);
    if (words.size() != count + 1 || words.front() != name) continue;
    std::vector<double> values;
    for (std::size_t i = 1; i < words.size(); ++i) {
      values.push_back(number_of(words[i], reader.line_number()));
    }
    return values;
  }
  throw ReadError(file.string() + ": no line '" + std::string(name) + "' with " +
                  std::to_string(count) + " numbers");
}

Pose pose_of_values(const std::vector<double>& rotation, const std::vector<double>& translation) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = rotation[static_cast<std::size_t>(i)];
  return {Eigen::Quaterniond(matrix).normalized(),
          {translation[0], translation[1], translation[2]}};
}

/// Poses of the left camera; the calibration's Tr takes points from the LiDAR to it.
Truth read_kitti(const fs::path& file) {
  Truth truth = read_table(file);
  if (truth.has_stamps) throw ReadError(file.string() + ": has stamps; KITTI's poses have none");
  const fs::path folder = file.parent_path();
  const fs::path sequence = folder / ".." / "sequences" / file.stem();
  const std::vector<double> values =
      calibration(first_there({folder / "calib.txt", sequence / "calib.txt"}), "Tr:", 12);
  const std::vector<double> rotation = {values[0], values[1], values[2], values[4], values[5],
                                        values[6], values[8], values[9], values[10]};
  truth.T_lidar_truth = pose_of_values(rotation, {values[3], values[7], values[11]}).inverse();
  for (const fs::path& times : {folder / "times.txt", sequence / "times.txt"}) {
    std::error_code ignored;
    if (truth.has_stamps || !fs::is_regular_file(times, ignored)) continue;
    const std::vector<std::int64_t> stamps = parse_stamps(text_in(times));
    if (stamps.size() != truth.poses.size()) continue;
    for (std::size_t i = 0; i < stamps.size(); ++i) truth.poses[i].stamp_ns = stamps[i];
    truth.has_stamps = true;
  }
  return truth;
}

/// A drive's folder of OXTS records.
Truth read_oxts(const fs::path& drive) {
  const fs::path folder = drive / "oxts";
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder / "data", error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().extension() == ".txt") files.push_back(it->path());
  }
  if (files.empty()) throw ReadError((folder / "data").string() + ": no OXTS records (.txt)");
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  const std::vector<std::int64_t> stamps = parse_stamps(text_in(folder / "timestamps.txt"));
  if (stamps.size() != files.size()) {
    throw ReadError(folder.string() + ": " + std::to_string(stamps.size()) + " stamps for " +
                    std::to_string(files.size()) + " records; expected as many of both");
  }
  Truth truth;
  truth.what = "OXTS records";
  const double scale = mercator_scale(text_in(files.front()));
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Pose pose = pose_of_oxts(text_in(files[i]), scale);
    truth.poses.push_back({stamps[i], pose});
  }
  const Pose T_first_world = truth.poses.front().pose.inverse();
  for (StampedPose& pose : truth.poses) pose.pose = T_first_world * pose.pose;
  const std::string name = "calib_imu_to_velo.txt";
  const fs::path calib = first_there({drive / name, drive / ".." / name});
  truth.T_lidar_truth = pose_of_values(calibration(calib, "R:", 9), calibration(calib, "T:", 3));
  return truth;
}

bool holds_topics(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored) ? !bag_files(path).empty() : is_bag_file(path);
}

/// A total station knows no rotations; some of its files have 0 0 0 1 in their place.
bool never_turns(const Truth& truth) {
  return truth.poses.size() > 1 &&
         std::all_of(truth.poses.begin(), truth.poses.end(), [](const StampedPose& pose) {
           return pose.pose.rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs();
         });
}

}  // namespace

double mercator_scale(std::string_view text) {
  const Words words = columns_of(text.substr(0, text.find('\n')));
  if (words.size() < 6) throw ReadError("an OXTS record of less than 6 numbers");
  return std::cos(number_of(words[0], 1) * kRadian);
}

Pose pose_of_oxts(std::string_view text, double scale) {
  const Words words = columns_of(text.substr(0, text.find('\n')));
  if (words.size() < 6) throw ReadError("an OXTS record of less than 6 numbers");
  const double latitude = number_of(words[0], 1), longitude = number_of(words[1], 1);
  Pose pose;
  pose.translation = {scale * longitude * kRadian * kEarth,
                      scale * kEarth * std::log(std::tan((90.0 + latitude) * 0.5 * kRadian)),
                      number_of(words[2], 1)};
  pose.rotation =
      from_roll_pitch_yaw({number_of(words[3], 1), number_of(words[4], 1), number_of(words[5], 1)});
  return pose;
}

Truth parse_truth_table(std::string_view text) {
  Truth truth;
  WholeTimes whole;
  for_each_row(text, [&](const Words& words, std::size_t) { whole.add(words.front()); });
  const RowTimes times{whole.scale().value_or(1), whole.scale().has_value()};
  const RotationOrder order = rotation_order(text);
  const std::size_t columns = for_each_row(text, [&](const Words& words, std::size_t line) {
    add_row(truth, words, line, times, order.w_first);
  });
  if (truth.poses.empty()) throw ReadError("no poses");
  const std::string unit = whole.unusual_unit();
  const bool has_order = (columns == 8 || columns == 9) && truth.has_rotations;
  const bool is_guess = !order.is_told && text.find(',') != std::string_view::npos;
  truth.what = std::to_string(columns) + " columns" + (unit.empty() ? "" : ", times in " + unit) +
               (has_order && order.w_first ? ", rotations as w x y z"
                : has_order && is_guess    ? ", rotations taken as x y z w"
                                           : "") +
               (!truth.has_rotations ? ", positions without rotations"
                : never_turns(truth) ? ", and no rotation in any row: are they known?"
                                     : "");
  return truth;
}

Truth read_truth(const fs::path& path, const Dataset* set, const std::string& topic) {
  Truth truth;
  if (set != nullptr && set->truth == TruthOf::oxts) return read_oxts(path);
  if (set != nullptr && set->truth == TruthOf::kitti_camera) return read_kitti(path);
  if (holds_topics(path)) {
    const std::string name = topic.empty() && set != nullptr ? set->truth_topic : topic;
    PoseTopic told = read_pose_topic(path, name);
    truth.poses = std::move(told.poses);
    truth.has_rotations = told.has_rotations;
    truth.what = "topic " + (name.empty() ? std::string("of poses") : name) +
                 (truth.has_rotations ? "" : ", positions without rotations");
  } else {
    truth = read_table(path);
  }
  if (set == nullptr) return truth;
  if (set->truth == TruthOf::positions) truth.has_rotations = false;
  truth.T_lidar_truth = set->T_lidar_truth.value_or(Pose{});
  return truth;
}

}  // namespace surefoot::io
