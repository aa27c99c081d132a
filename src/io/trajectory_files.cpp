// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/trajectory_files.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/decompositions.hpp"
#include "io/ascii_values.hpp"
#include "io/decimal_time.hpp"
#include "io/file_reader.hpp"
#include "io/file_writer.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

constexpr int kMetreDecimals = 9;
constexpr int kRotationDecimals = 12;

double finite_number(std::string_view word, std::size_t line) {
  double value = 0.0;
  if (!parse_real(word, value) || !std::isfinite(value)) {
    fail_at_line(line, in_quotes(word) + " is no finite number");
  }
  return value;
}

constexpr const char* kTumShape = "t x y z qx qy qz qw";

// Calls use(words, line number) for the lines that are neither empty nor a comment. Returns the
// number of the last line.
template <typename Use>
std::size_t for_each_row(std::string_view text, std::size_t columns, const char* shape, Use&& use,
                         std::size_t lines_before = 0) {
  LineReader lines(text, lines_before);
  for (std::string_view line; lines.next(line);) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty() || words[0].front() == '#') {
      continue;
    }
    if (words.size() != columns) {
      fail_at_line(lines.line_number(), std::to_string(words.size()) + " values; expected " +
                                            std::to_string(columns) + " (" + shape + ")");
    }
    use(words, lines.line_number());
  }
  return lines.line_number();
}

StampedPose pose_of_tum_row(const std::vector<std::string_view>& words, std::size_t line) {
  const std::optional<std::int64_t> stamp = parse_decimal_seconds(words[0]);
  if (!stamp) {
    fail_at_line(line, in_quotes(words[0]) + " is no stamp in seconds");
  }
  std::array<double, 7> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = finite_number(words[i + 1], line);
  }
  StampedPose pose;
  pose.stamp_ns = *stamp;
  pose.pose.translation = {values[0], values[1], values[2]};
  const Eigen::Quaterniond rotation(values[6], values[3], values[4], values[5]);
  // Far from unit length it is no rotation that was written with few digits, but something else.
  if (std::abs(rotation.norm() - 1.0) > 0.01) {
    fail_at_line(line, "quaternion of length " + std::to_string(rotation.norm()) + "; expected 1");
  }
  pose.pose.rotation = rotation.normalized();
  return pose;
}

// Lets errors in a file name it.
template <typename Read>
auto naming(const std::filesystem::path& file, Read&& read) {
  try {
    return read();
  } catch (const ReadError& error) {
    throw ReadError(file.string() + ": " + error.what());
  }
}

template <typename Parse>
auto parse_file(const std::filesystem::path& file, Parse&& parse) {
  return naming(file, [&] {
    std::vector<std::byte> bytes;
    read_whole_file(file, bytes);
    return parse(text_of(bytes));
  });
}

}  // namespace

Pose pose_of_kitti_row(std::span<const std::string_view> words, std::size_t line) {
  Eigen::Matrix<double, 3, 4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix(row, column) = finite_number(words[static_cast<std::size_t>(4 * row + column)], line);
    }
  }
  const Eigen::Matrix3d given = matrix.leftCols<3>();
  const Eigen::Matrix3d rotation = nearest_rotation(given);
  if (!((given - rotation).norm() < 0.01)) {
    fail_at_line(line, "the 3x3 part is no rotation");
  }
  return {Eigen::Quaterniond(rotation).normalized(), matrix.col(3)};
}

std::string format_tum(const Trajectory& trajectory) {
  std::string out;
  for (const StampedPose& stamped : trajectory) {
    out += format_seconds(stamped.stamp_ns);
    for (const double value : stamped.pose.translation) {
      append_fixed(out += ' ', value, kMetreDecimals);
    }
    for (const double value : stamped.pose.rotation.coeffs()) {  // x y z w
      append_fixed(out += ' ', value, kRotationDecimals);
    }
    out += '\n';
  }
  return out;
}

std::string format_kitti_poses(const Trajectory& trajectory) {
  std::string out;
  for (const StampedPose& stamped : trajectory) {
    const Eigen::Matrix4d matrix = stamped.pose.matrix();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        append_fixed(out, matrix(row, column), column < 3 ? kRotationDecimals : kMetreDecimals);
        out += ' ';
      }
    }
    out.back() = '\n';
  }
  return out;
}

void write_tum(const std::filesystem::path& file, const Trajectory& trajectory) {
  write_whole_file(file, format_tum(trajectory));
}

void write_kitti_poses(const std::filesystem::path& file, const Trajectory& trajectory) {
  write_whole_file(file, format_kitti_poses(trajectory));
}

Trajectory parse_tum(std::string_view text) {
  Trajectory trajectory;
  for_each_row(text, 8, kTumShape, [&](const auto& words, std::size_t line) {
    trajectory.push_back(pose_of_tum_row(words, line));
  });
  return trajectory;
}

std::vector<Pose> parse_kitti_poses(std::string_view text) {
  std::vector<Pose> poses;
  for_each_row(text, 12, "rows of a 3x4 matrix", [&](const auto& words, std::size_t line) {
    poses.push_back(pose_of_kitti_row(words, line));
  });
  return poses;
}

Trajectory read_tum(const std::filesystem::path& file) { return parse_file(file, parse_tum); }

Trajectory read_tum_thinned(const std::filesystem::path& file, std::int64_t step_ns) {
  Trajectory result;
  std::optional<StampedPose> last;  // that was left out
  const auto take = [&](const auto& words, std::size_t line) {
    last = pose_of_tum_row(words, line);
    if (!result.empty() && last->stamp_ns - result.back().stamp_ns < step_ns) return;
    result.push_back(*last);
    last.reset();
  };
  std::size_t lines = 0;
  naming(file, [&] {
    read_lines_in_parts(file, [&](std::string_view text) {
      lines = for_each_row(text, 8, kTumShape, take, lines);
    });
  });
  if (last) result.push_back(*last);
  return result;
}

std::vector<Pose> read_kitti_poses(const std::filesystem::path& file) {
  return parse_file(file, parse_kitti_poses);
}

}  // namespace surefoot::io
