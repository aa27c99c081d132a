// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where the stamps of a folder of scans come from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::io {

/// What a file's times count, where all are whole numbers and the greatest is 1e11 or more, which
/// no seconds are: microseconds or milliseconds where the least is such a time since the epoch
/// (2001 to 2103) and they follow each other too closely for nanoseconds, else nanoseconds. Smaller
/// ones, as of a simulator's clock, are nanoseconds where they are 1e6 or more apart on average,
/// and microseconds from 1000 on: no scans are hours apart.
class WholeTimes {
 public:
  void add(std::string_view word);
  [[nodiscard]] bool all_whole() const { return all_whole_; }
  /// Nanoseconds in one of them; nothing where they are decimal seconds or else.
  [[nodiscard]] std::optional<std::int64_t> scale() const;
  /// "microseconds" or "milliseconds", and "nanoseconds" where they are that small; empty: none.
  [[nodiscard]] std::string unusual_unit() const;

 private:
  [[nodiscard]] bool is_near_zero() const;
  [[nodiscard]] std::string unit_near_zero() const;

  bool all_whole_ = true;
  std::vector<std::int64_t> values_;
  std::int64_t least_ = 0, greatest_ = 0;
  std::size_t count_ = 0;
};

/// A whole number of `scale` nanoseconds; nothing where it is none or too large.
[[nodiscard]] std::optional<std::int64_t> parse_whole_time(std::string_view word,
                                                           std::int64_t scale);

/// One stamp a line: decimal seconds, KITTI's date lines, or whole numbers (WholeTimes). Empty
/// lines and `#` comments are passed over. Throws ReadError naming the line. `unit`, where it is
/// not null, is then WholeTimes' unusual one.
[[nodiscard]] std::vector<std::int64_t> parse_stamps(std::string_view text,
                                                     std::string* unit = nullptr);

/// `preferred`, times.txt, timestamps.txt or stamps.txt in the folder, else in the one above;
/// empty: none.
[[nodiscard]] std::filesystem::path find_stamps_file(const std::filesystem::path& folder,
                                                     const std::string& preferred = {});

/// Stamps from file names that are numbers: 18 or 19 digits are nanoseconds, 16 microseconds and 13
/// milliseconds of epoch size, numbers with a decimal point or of epoch size (1e9 .. 4.2e9)
/// seconds, smaller ones that are 1e6 or more apart nanoseconds; "1600000000.20000000" is 0.02 s
/// past the second where the scans come more steadily so; "cloud_1583836591_182590976" is seconds
/// and nanoseconds, as Newer College has them; of nuScenes' what follows the last "__". Nothing
/// where one name is neither: then they are names or indices. `unit` as of parse_stamps().
[[nodiscard]] std::optional<std::vector<std::int64_t>> stamps_from_names(
    const std::vector<std::filesystem::path>& files, std::string* unit = nullptr);

/// Whether files' names differ by whole numbers alone: then their natural order is that in which
/// they were written, whatever a clock that was set meanwhile says.
[[nodiscard]] bool are_counted(const std::vector<std::filesystem::path>& files);

/// Of the stamps of all frames those of these files, whose names are frames' numbers, counted from
/// zero ("0000000012.bin", as in KITTI's folders). Nothing where a name is none that has a stamp.
[[nodiscard]] std::optional<std::vector<std::int64_t>> stamps_of_frames(
    const std::vector<std::int64_t>& stamps, const std::vector<std::filesystem::path>& files);

/// Numbers of frames in file names that end with one ("scan_0012"), counted from the first: they
/// grow, and somewhere by one only. Nothing where they tell no more than the files' order.
[[nodiscard]] std::optional<std::vector<std::int64_t>> frame_numbers(
    const std::vector<std::filesystem::path>& files);

}  // namespace surefoot::io
