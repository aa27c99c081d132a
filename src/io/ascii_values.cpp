// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/ascii_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "io/recording.hpp"

namespace surefoot::io {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f\n";

// std::from_chars knows no plus sign.
std::string_view without_plus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return plus ? word.substr(1) : word;
}

template <typename T>
bool parse_whole_word(std::string_view word, T& value) {
  word = without_plus(word);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc{} && stop == end && !word.empty();
}

template <typename T>
void store(T value, std::byte* out) {
  std::memcpy(out, &value, sizeof(T));
}

// Who prints all columns alike writes 3.0.
template <typename T>
bool store_integer(std::string_view word, std::byte* out) {
  constexpr double kExact =
      9007199254740992.0;  // 2^53: greater ones have no fraction to be without
  T value{};
  double real{};
  if (!parse_whole_word(word, value)) {
    if (!parse_real(word, real) || real != std::trunc(real)) return false;
    const double least = std::max(static_cast<double>(std::numeric_limits<T>::min()), -kExact);
    const double most = std::min(static_cast<double>(std::numeric_limits<T>::max()), kExact);
    if (real < least || real > most) return false;
    value = static_cast<T>(real);
  }
  store(value, out);
  return true;
}

// A float may be written with more range than it has: 1e-50 is 0, 1e50 is infinite.
template <typename T>
bool store_real(std::string_view word, std::byte* out) {
  double value{};
  if (!parse_real(word, value)) {
    // As Microsoft's C library writes what is no number.
    const bool none = word.ends_with("#IND") || word.ends_with("#QNAN") || word.ends_with("#SNAN");
    if (!none) return false;
    value = std::numeric_limits<double>::quiet_NaN();
  }
  store(static_cast<T>(value), out);
  return true;
}

}  // namespace

void fail_at_line(std::size_t line, const std::string& what) {
  throw ReadError("line " + std::to_string(line) + ": " + what);
}

bool is_whole(std::string_view word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

bool LineReader::next(std::string_view& line) {
  if (offset_ >= text_.size()) {
    return false;
  }
  const std::size_t end = text_.find('\n', offset_);
  const std::size_t stop = end == std::string_view::npos ? text_.size() : end;
  line = text_.substr(offset_, stop - offset_);
  if (!line.empty() && line.back() == '\r') {
    line.remove_suffix(1);
  }
  offset_ = end == std::string_view::npos ? text_.size() : end + 1;
  ++line_number_;
  return true;
}

std::string_view take_word(std::string_view& text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    text = {};
    return {};
  }
  const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
    words.push_back(word);
  }
  return words;
}

bool parse_count(std::string_view word, std::size_t& count) {
  return parse_whole_word(word, count);
}

bool parse_real(std::string_view word, double& value) { return parse_whole_word(word, value); }

bool store_number(std::string_view word, ScalarType type, std::byte* out) {
  switch (type) {
    case ScalarType::i8:
      return store_integer<std::int8_t>(word, out);
    case ScalarType::u8:
      return store_integer<std::uint8_t>(word, out);
    case ScalarType::i16:
      return store_integer<std::int16_t>(word, out);
    case ScalarType::u16:
      return store_integer<std::uint16_t>(word, out);
    case ScalarType::i32:
      return store_integer<std::int32_t>(word, out);
    case ScalarType::u32:
      return store_integer<std::uint32_t>(word, out);
    case ScalarType::i64:
      return store_integer<std::int64_t>(word, out);
    case ScalarType::u64:
      return store_integer<std::uint64_t>(word, out);
    case ScalarType::f32:
      return store_real<float>(word, out);
    case ScalarType::f64:
      return store_real<double>(word, out);
  }
  return false;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, kLongest)) {
    if (c >= ' ' && c <= '~') {
      text += c;
    } else {
      constexpr char kHex[] = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(c);
      text += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return text + (word.size() > kLongest ? "...'" : "'");
}

}  // namespace surefoot::io
