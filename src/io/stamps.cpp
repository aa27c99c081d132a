// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/stamps.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <limits>
#include <string>

#include "io/ascii_values.hpp"
#include "io/decimal_time.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

std::optional<std::int64_t> parse_whole(std::string_view text) {
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? std::optional(value) : std::nullopt;
}

// Whole seconds of this size would be 3,000 years: they are nanoseconds, or what is between.
constexpr std::int64_t kLeastNanoseconds = 100'000'000'000;

struct WholeUnit {
  const char* name;
  std::int64_t scale;
  std::int64_t too_close;  ///< apart on average for nanoseconds of such size, a computer's uptime
};
constexpr std::array<WholeUnit, 2> kWholeUnits = {
    {{"microseconds", 1'000, 3'000'000}, {"milliseconds", 1'000'000, 100'000}}};

bool is_epoch(std::int64_t value, std::int64_t scale) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  constexpr std::int64_t kEpochLeast = 1'000'000'000;
  constexpr std::int64_t kEpochGreatest = 4'200'000'000;
  const std::int64_t seconds = value / (kSecond / scale);
  return seconds >= kEpochLeast && seconds <= kEpochGreatest;
}

std::string_view trimmed_line(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) {
    return {};
  }
  return line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

struct StampLine {
  std::string_view text;
  std::size_t number;
};

std::vector<StampLine> stamp_lines(std::string_view text) {
  std::vector<StampLine> lines;
  LineReader reader(text);
  for (std::string_view line; reader.next(line);) {
    line = trimmed_line(line);
    if (!line.empty() && line.front() != '#') {
      lines.push_back({line, reader.line_number()});
    }
  }
  return lines;
}

// "cloud_1583836591_182590976": any name, seconds, nanoseconds.
std::optional<std::int64_t> stamp_of_two_numbers(const std::string& name) {
  constexpr std::size_t kSecondDigits = 10, kNanosecondDigits = 9;
  const std::size_t second = name.rfind('_');
  if (second == std::string::npos || second < kSecondDigits) return std::nullopt;
  const std::size_t first = second - kSecondDigits;
  if (first > 0 && name[first - 1] != '_') return std::nullopt;
  const std::string seconds = name.substr(first, kSecondDigits);
  const std::string nanoseconds = name.substr(second + 1);
  const bool whole = is_whole(seconds) && is_whole(nanoseconds);
  if (!whole || nanoseconds.size() > kNanosecondDigits) return std::nullopt;
  const std::optional<std::int64_t> whole_seconds = parse_decimal_seconds(seconds);
  std::int64_t stamp = 0;
  const bool fits =
      whole_seconds && !__builtin_add_overflow(*whole_seconds, *parse_whole(nanoseconds), &stamp);
  return fits ? std::optional(stamp) : std::nullopt;
}

/// "n015-2018-07-24__LIDAR_TOP__1532402927647951.pcd", as nuScenes has them: the last part.
std::string last_part(std::string name) {
  if (name.ends_with(".pcd")) name.resize(name.size() - 4);
  const std::size_t bar = name.rfind("__");
  return bar == std::string::npos ? name : name.substr(bar + 2);
}

std::optional<std::int64_t> stamp_of_name(const std::string& whole_name, bool with_milliseconds) {
  if (const auto stamp = stamp_of_two_numbers(whole_name)) return stamp;
  const std::string name = last_part(whole_name);
  if (name.empty() || name.find_first_not_of("0123456789.") != std::string::npos) {
    return std::nullopt;
  }
  if (!is_whole(name)) {
    return parse_decimal_seconds(name);
  }
  if (name.size() == 18 || name.size() == 19) {
    return name.front() == '0' ? std::nullopt : parse_whole(name);
  }
  const std::optional<std::int64_t> number = parse_whole(name);
  for (const std::int64_t scale : {1'000'000'000, 1'000'000, 1'000}) {
    const bool is_meant = scale != 1'000'000 || with_milliseconds;
    if (number && is_meant && is_epoch(*number, scale)) return *number * scale;
  }
  return std::nullopt;
}

}  // namespace

void WholeTimes::add(std::string_view word) {
  const std::optional<std::int64_t> value = is_whole(word) ? parse_whole(word) : std::nullopt;
  all_whole_ = all_whole_ && value.has_value();
  if (!value) return;
  least_ = count_ == 0 ? *value : std::min(least_, *value);
  greatest_ = std::max(greatest_, *value);
  ++count_;
}

std::string WholeTimes::unusual_unit() const {
  if (!all_whole_ || count_ == 0) return {};
  const std::int64_t range = greatest_ - least_;
  for (const WholeUnit& unit : kWholeUnits) {
    const bool is_close =
        count_ == 1 || range / static_cast<std::int64_t>(count_ - 1) < unit.too_close;
    if (is_epoch(least_, unit.scale) && is_close) return unit.name;
  }
  return {};
}

std::optional<std::int64_t> WholeTimes::scale() const {
  if (!all_whole_ || greatest_ < kLeastNanoseconds) return std::nullopt;
  const std::string name = unusual_unit();
  for (const WholeUnit& unit : kWholeUnits) {
    if (name == unit.name) return unit.scale;
  }
  return 1;
}

std::optional<std::int64_t> parse_whole_time(std::string_view word, std::int64_t scale) {
  const std::optional<std::int64_t> value = is_whole(word) ? parse_whole(word) : std::nullopt;
  std::int64_t time = 0;
  const bool fits = value && !__builtin_mul_overflow(*value, scale, &time);
  return fits ? std::optional(time) : std::nullopt;
}

std::vector<std::int64_t> parse_stamps(std::string_view text, std::string* unit) {
  const std::vector<StampLine> lines = stamp_lines(text);
  WholeTimes whole;
  for (const StampLine& line : lines) whole.add(line.text);
  const std::optional<std::int64_t> scale = whole.scale();
  if (unit != nullptr) *unit = whole.unusual_unit();

  std::vector<std::int64_t> stamps;
  stamps.reserve(lines.size());
  for (const StampLine& line : lines) {
    std::optional<std::int64_t> stamp =
        scale ? parse_whole_time(line.text, *scale) : parse_decimal_seconds(line.text);
    stamp = stamp ? stamp : parse_date_time(line.text);
    if (!stamp) {
      throw ReadError(
          "line " + std::to_string(line.number) + ": " + in_quotes(line.text) +
          "; expected one stamp: seconds, whole nanoseconds, microseconds or milliseconds, or "
          "a date and time");
    }
    stamps.push_back(*stamp);
  }
  return stamps;
}

std::filesystem::path find_stamps_file(const std::filesystem::path& folder,
                                       const std::string& preferred) {
  const std::filesystem::path above = std::filesystem::absolute(folder / "").parent_path();
  for (const std::filesystem::path& place : {folder, above.parent_path()}) {
    for (const std::string& name : {preferred, std::string("times.txt"),
                                    std::string("timestamps.txt"), std::string("stamps.txt")}) {
      std::error_code ignored;
      if (name.empty()) continue;
      if (std::filesystem::is_regular_file(place / name, ignored)) {
        return place / name;
      }
    }
  }
  return {};
}

std::optional<std::vector<std::int64_t>> stamps_from_names(
    const std::vector<std::filesystem::path>& files, std::string* unit) {
  WholeTimes whole;
  for (const std::filesystem::path& file : files) whole.add(last_part(file.stem().string()));
  const std::string unusual_unit = whole.unusual_unit();
  if (unit != nullptr) *unit = unusual_unit;
  std::vector<std::int64_t> stamps;
  for (const std::filesystem::path& file : files) {
    const std::optional<std::int64_t> stamp =
        stamp_of_name(file.stem().string(), unusual_unit == "milliseconds");
    if (!stamp) {
      return std::nullopt;
    }
    stamps.push_back(*stamp);
  }
  return stamps;
}

bool are_counted(const std::vector<std::filesystem::path>& files) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto without_digits = [&](const std::filesystem::path& file) {
    std::string stem = file.stem().string();
    std::erase_if(stem, is_digit);
    return stem;
  };
  // Natural order takes what is behind a decimal point for a whole number.
  const auto has_fraction = [&](const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    for (std::size_t i = 1; i + 1 < stem.size(); ++i) {
      if (stem[i] == '.' && is_digit(stem[i - 1]) && is_digit(stem[i + 1])) return true;
    }
    return false;
  };
  return std::all_of(files.begin(), files.end(), [&](const std::filesystem::path& file) {
    return without_digits(file) == without_digits(files.front()) && !has_fraction(file);
  });
}

std::optional<std::vector<std::int64_t>> frame_numbers(
    const std::vector<std::filesystem::path>& files) {
  constexpr std::size_t kMostDigits = 9;
  std::vector<std::int64_t> numbers;
  std::int64_t least_step = std::numeric_limits<std::int64_t>::max();
  for (const std::filesystem::path& file : files) {
    const std::string stem = file.stem().string();
    const std::size_t digits = stem.find_last_not_of("0123456789") + 1;  // npos + 1 is 0
    if (digits == stem.size() || stem.size() - digits > kMostDigits) return std::nullopt;
    numbers.push_back(*parse_whole(std::string_view(stem).substr(digits)));
    if (numbers.size() == 1) continue;
    const std::int64_t step = numbers.back() - numbers[numbers.size() - 2];
    if (step <= 0) return std::nullopt;
    least_step = std::min(least_step, step);
  }
  const bool in_a_row =
      numbers.empty() || numbers.back() - numbers.front() + 1 == std::ssize(numbers);
  if (in_a_row || least_step != 1) return std::nullopt;
  const std::int64_t first = numbers.front();
  for (std::int64_t& number : numbers) number -= first;
  return numbers;
}

}  // namespace surefoot::io
