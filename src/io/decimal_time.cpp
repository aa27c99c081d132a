// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/decimal_time.hpp"

#include <array>
#include <charconv>
#include <chrono>
#include <limits>

namespace surefoot::io {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Digits of a decimal number without its sign, point and exponent: value = digits * 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

std::optional<Decimal> parse_decimal(std::string_view text) {
  Decimal decimal;
  std::size_t at = 0;
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) {
    decimal.negative = text[0] == '-';
    at = 1;
  }
  bool point = false;
  for (; at < text.size() && (is_digit(text[at]) || (text[at] == '.' && !point)); ++at) {
    if (text[at] == '.') {
      point = true;
      continue;
    }
    decimal.digits += text[at];
    decimal.exponent -= point ? 1 : 0;
  }
  if (decimal.digits.empty()) {
    return std::nullopt;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    at += at + 1 < text.size() && text[at + 1] == '+' ? 2 : 1;
    int power = 0;
    const auto [stop, error] = std::from_chars(text.data() + at, text.data() + text.size(), power);
    if (error != std::errc{} || power < -100 || power > 100) {
      return std::nullopt;
    }
    decimal.exponent += power;
    at = static_cast<std::size_t>(stop - text.data());
  }
  return at == text.size() ? std::optional(decimal) : std::nullopt;
}

// Two digits of a fixed place in a date, or more.
std::optional<int> digits_at(std::string_view text, std::size_t begin, std::size_t count) {
  int value = 0;
  for (const char c : text.substr(begin, count)) {
    if (!is_digit(c)) {
      return std::nullopt;
    }
    value = 10 * value + (c - '0');
  }
  return value;
}

}  // namespace

std::optional<std::int64_t> parse_decimal_seconds(std::string_view text) {
  std::optional<Decimal> decimal = parse_decimal(text);
  if (!decimal) {
    return std::nullopt;
  }
  int exponent = decimal->exponent + 9;  // from here on in nanoseconds
  std::string& digits = decimal->digits;
  bool round_up = false;
  while (exponent < 0 && !digits.empty()) {
    round_up = digits.back() >= '5';
    digits.pop_back();
    ++exponent;
  }
  round_up = round_up && exponent == 0;
  constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
  std::int64_t value = 0;
  const auto append = [&value](int digit) {
    const bool fits = value <= (kLargest - 9) / 10;
    value = fits ? 10 * value + digit : value;
    return fits;
  };
  for (const char c : digits) {
    if (!append(c - '0')) {
      return std::nullopt;
    }
  }
  for (; exponent > 0 && value != 0; --exponent) {
    if (!append(0)) {
      return std::nullopt;
    }
  }
  value += round_up ? 1 : 0;
  return decimal->negative ? -value : value;
}

std::optional<std::int64_t> parse_date_time(std::string_view text) {
  constexpr std::string_view kShape = "dddd-dd-dd dd:dd:dd";
  if (text.size() < kShape.size()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < kShape.size(); ++i) {
    const bool separator = text[i] == kShape[i] || (kShape[i] == ' ' && text[i] == 'T');
    if (kShape[i] == 'd' ? !is_digit(text[i]) : !separator) {
      return std::nullopt;
    }
  }
  const std::chrono::year_month_day date{
      std::chrono::year{*digits_at(text, 0, 4)},
      std::chrono::month{static_cast<unsigned>(*digits_at(text, 5, 2))},
      std::chrono::day{static_cast<unsigned>(*digits_at(text, 8, 2))}};
  const int hour = *digits_at(text, 11, 2);
  const int minute = *digits_at(text, 14, 2);
  const std::optional<std::int64_t> second = parse_decimal_seconds(text.substr(17));
  const bool in_range = date.ok() && date.year() >= std::chrono::year{1700} &&
                        date.year() < std::chrono::year{2262} && hour < 24 && minute < 60;
  if (!in_range || !second || *second >= 61 * kSecond) {
    return std::nullopt;
  }
  const std::int64_t days = std::chrono::sys_days{date}.time_since_epoch().count();
  return ((days * 24 + hour) * 60 + minute) * 60 * kSecond + *second;
}

std::string format_seconds(std::int64_t nanoseconds) {
  const bool negative = nanoseconds < 0;
  const std::uint64_t size = negative ? 0 - static_cast<std::uint64_t>(nanoseconds)
                                      : static_cast<std::uint64_t>(nanoseconds);
  const std::uint64_t fraction = size % kSecond;
  const std::string decimals = std::to_string(fraction);
  std::string text = negative ? "-" : "";
  text += std::to_string(size / kSecond);
  text += '.';
  text.append(9 - decimals.size(), '0');
  return text += decimals;
}

}  // namespace surefoot::io
