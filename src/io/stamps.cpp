// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/stamps.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include "io/ascii_values.hpp"
#include "io/decimal_time.hpp"
#include "io/recording.hpp"
#include "io/saturated.hpp"

namespace surefoot::io {
namespace {

std::optional<std::int64_t> parse_whole(std::string_view text) {
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? std::optional(value) : std::nullopt;
}

// Whole seconds of this size would be 3,000 years: they are nanoseconds, or what is between.
constexpr std::int64_t kLeastNanoseconds = 100'000'000'000;

// Smaller ones that are further apart as a rule are no seconds either, but since a start; and such
// that are further apart than these are no microseconds.
constexpr std::int64_t kTooFarApart = 1'000, kFewestNanoseconds = 1'000'000;

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

// Of names that are all "SECONDS.NANOSECONDS", these without leading zeros, as of Python's
// f"{sec}.{nanosec}": ".20000000" is 0.02 s. Nothing where they cannot be.
std::optional<std::vector<std::int64_t>> stamps_with_nanoseconds(
    const std::vector<std::filesystem::path>& files) {
  constexpr std::size_t kNanosecondDigits = 9;
  std::vector<std::int64_t> stamps;
  std::size_t most = 0, fewest = kNanosecondDigits;
  for (const std::filesystem::path& file : files) {
    const std::string name = last_part(file.stem().string());
    const std::size_t point = std::min(name.find('.'), name.size());
    const std::string seconds = name.substr(0, point);
    const std::string rest = name.substr(std::min(point + 1, name.size()));
    const bool leads = rest.size() > 1 && rest.front() == '0';
    if (!is_whole(seconds) || !is_whole(rest) || rest.size() > kNanosecondDigits || leads) {
      return std::nullopt;
    }
    const std::optional<std::int64_t> whole_seconds = parse_decimal_seconds(seconds);
    std::int64_t stamp = 0;
    if (!whole_seconds || __builtin_add_overflow(*whole_seconds, *parse_whole(rest), &stamp)) {
      return std::nullopt;
    }
    stamps.push_back(stamp);
    most = std::max(most, rest.size());
    fewest = std::min(fewest, rest.size());
  }
  const bool are_alike = most < kNanosecondDigits || fewest == most;
  return are_alike ? std::nullopt : std::optional(stamps);
}

/// One or the other may be wild, and is mended then.
bool are_of_no_time(const std::vector<std::int64_t>& stamps) {
  return !stamps.empty() && std::all_of(stamps.begin(), stamps.end(), [](std::int64_t stamp) {
    return stamp != sane_time(stamp);
  });
}

std::vector<double> intervals_of(std::vector<std::int64_t> stamps) {
  std::sort(stamps.begin(), stamps.end());
  std::vector<double> intervals;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    intervals.push_back(static_cast<double>(stamps[i] - stamps[i - 1]));
  }
  return intervals;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// How far the intervals are from their median, together.
double unsteadiness(const std::vector<std::int64_t>& stamps) {
  const std::vector<double> intervals = intervals_of(stamps);
  const double usual = median(intervals);
  double sum = 0.0;
  for (const double interval : intervals) sum += std::abs(interval - usual);
  return sum;
}

// The points between digits, with what is around them: natural order takes what is behind a decimal
// point for a whole number.
std::string fractions_in(const std::string& stem) {
  constexpr std::string_view kNumber = "0123456789.";
  std::string fractions;
  for (std::size_t begin = 0; begin < stem.size();) {
    begin = std::min(stem.find_first_of(kNumber, begin), stem.size());
    const std::size_t end = std::min(stem.find_first_not_of(kNumber, begin), stem.size());
    const std::string number = stem.substr(begin, end - begin);
    const std::size_t point = number.find('.', 1);
    if (point != std::string::npos && point + 1 < number.size()) fractions += number + ' ';
    begin = end;
  }
  return fractions;
}

}  // namespace

void WholeTimes::add(std::string_view word) {
  const std::optional<std::int64_t> value = is_whole(word) ? parse_whole(word) : std::nullopt;
  all_whole_ = all_whole_ && value.has_value();
  if (!value) return;
  least_ = count_ == 0 ? *value : std::min(least_, *value);
  greatest_ = std::max(greatest_, *value);
  values_.push_back(*value);
  ++count_;
}

bool WholeTimes::is_near_zero() const { return greatest_ < kLeastNanoseconds; }

// Two are no habit; of epoch seconds there may be few.
std::string WholeTimes::unit_near_zero() const {
  if (count_ < 3) return {};
  const auto apart = static_cast<std::int64_t>(median(intervals_of(values_)));
  if (apart >= kFewestNanoseconds) return "nanoseconds";
  const auto middle = static_cast<std::int64_t>(median({values_.begin(), values_.end()}));
  return apart > kTooFarApart && !is_epoch(middle, 1'000'000'000) ? "microseconds" : "";
}

std::string WholeTimes::unusual_unit() const {
  if (!all_whole_ || count_ == 0) return {};
  if (is_near_zero()) return unit_near_zero();
  const std::int64_t range = greatest_ - least_;
  for (const WholeUnit& unit : kWholeUnits) {
    const bool is_close =
        count_ == 1 || range / static_cast<std::int64_t>(count_ - 1) < unit.too_close;
    if (is_epoch(least_, unit.scale) && is_close) return unit.name;
  }
  return {};
}

std::optional<std::int64_t> WholeTimes::scale() const {
  const std::string name = unusual_unit();
  if (!all_whole_ || (name.empty() && is_near_zero())) return std::nullopt;
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
  if (are_of_no_time(stamps)) {
    throw ReadError("line " + std::to_string(lines.front().number) + ": " +
                    in_quotes(lines.front().text) +
                    " is no instant from 1834 to 2106, which stamps are expected to be; nor is any "
                    "other");
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
  const bool near_zero = unusual_unit == "nanoseconds";
  if (unit != nullptr) *unit = unusual_unit;
  std::vector<std::int64_t> stamps;
  for (const std::filesystem::path& file : files) {
    const std::string name = file.stem().string();
    const std::optional<std::int64_t> stamp =
        near_zero ? parse_whole_time(last_part(name), 1)
                  : stamp_of_name(name, unusual_unit == "milliseconds");
    if (!stamp) {
      return std::nullopt;
    }
    stamps.push_back(*stamp);
  }
  if (are_of_no_time(stamps)) return std::nullopt;
  const auto with_nanoseconds = stamps_with_nanoseconds(files);
  if (with_nanoseconds && unsteadiness(*with_nanoseconds) < unsteadiness(stamps)) {
    if (unit != nullptr) *unit = "seconds and nanoseconds without leading zeros";
    return with_nanoseconds;
  }
  return stamps;
}

bool are_counted(const std::vector<std::filesystem::path>& files) {
  const auto without_digits = [](std::string stem) {
    std::erase_if(stem, [](char c) { return c >= '0' && c <= '9'; });
    return stem;
  };
  const auto differ_by_whole_numbers = [&](const std::string& one, const std::string& other) {
    return without_digits(one) == without_digits(other) && fractions_in(one) == fractions_in(other);
  };
  return std::all_of(files.begin(), files.end(), [&](const std::filesystem::path& file) {
    return differ_by_whole_numbers(file.stem().string(), files.front().stem().string());
  });
}

std::optional<std::vector<std::int64_t>> stamps_of_frames(
    const std::vector<std::int64_t>& stamps, const std::vector<std::filesystem::path>& files) {
  std::vector<std::int64_t> result;
  std::int64_t last = -1;
  for (const std::filesystem::path& file : files) {
    const std::optional<std::int64_t> frame = parse_whole(file.stem().string());
    if (!frame || *frame <= last || *frame >= std::ssize(stamps)) return std::nullopt;
    last = *frame;
    result.push_back(stamps[static_cast<std::size_t>(last)]);
  }
  return result;
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
