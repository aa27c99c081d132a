// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/pcd_header.hpp"

#include <limits>
#include <optional>

#include "io/ascii_values.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

using Words = std::vector<std::string_view>;

// No driver's points have as many fields; a header of millions would take gigabytes.
constexpr std::size_t kMostFields = 1000;
constexpr std::size_t kLongestPcdLine = 100'000;

[[noreturn]] void refuse_line(std::size_t line, const std::string& what) {
  throw ReadError("PCD header line " + std::to_string(line) + ": " + what);
}

std::optional<ScalarType> scalar_type(std::string_view type, std::size_t size) {
  struct Known {
    char letter;
    std::size_t size;
    ScalarType type;
  };
  static constexpr Known kKnown[] = {{'I', 1, ScalarType::i8},  {'I', 2, ScalarType::i16},
                                     {'I', 4, ScalarType::i32}, {'I', 8, ScalarType::i64},
                                     {'U', 1, ScalarType::u8},  {'U', 2, ScalarType::u16},
                                     {'U', 4, ScalarType::u32}, {'U', 8, ScalarType::u64},
                                     {'F', 4, ScalarType::f32}, {'F', 8, ScalarType::f64}};
  for (const Known& known : kKnown) {
    if (type.size() == 1 && type[0] == known.letter && size == known.size) {
      return known.type;
    }
  }
  return std::nullopt;
}

// The header's lines as words, before they are checked against each other.
class HeaderLines {
 public:
  explicit HeaderLines(std::string_view file) : reader_(file), file_size_(file.size()) {}

  PcdHeader parse() {
    std::string_view line;
    while (reader_.next(line)) {
      if (line.size() > kLongestPcdLine) {
        refuse_line(reader_.line_number(), std::to_string(line.size()) +
                                               " characters; expected at most " +
                                               std::to_string(kLongestPcdLine));
      }
      Words words = words_of(line);
      if (words.empty() || words[0].front() == '#') {
        continue;
      }
      if (words[0] == "DATA") {
        header_.data = data_kind(words);
        finish();
        return header_;
      }
      take(words);
    }
    throw ReadError("PCD header: " + std::to_string(reader_.line_number()) +
                    " lines without a DATA line; expected a PCD 0.7 file");
  }

 private:
  void take(Words& words) {
    const std::string_view key = words[0];
    const Words values(words.begin() + 1, words.end());
    if (key == "FIELDS" || key == "COLUMNS") {
      names_ = values;
    } else if (key == "SIZE") {
      sizes_ = numbers(values, "SIZE");
    } else if (key == "TYPE") {
      types_ = values;
    } else if (key == "COUNT") {
      counts_ = numbers(values, "COUNT");
    } else if (key == "WIDTH") {
      width_ = one_number(values, "WIDTH");
    } else if (key == "HEIGHT") {
      height_ = one_number(values, "HEIGHT");
    } else if (key == "POINTS") {
      points_ = one_number(values, "POINTS");
    } else if (key != "VERSION" && key != "VIEWPOINT") {
      refuse_line(reader_.line_number(), in_quotes(key) + " is no PCD 0.7 keyword");
    }
  }

  std::vector<std::size_t> numbers(const Words& words, const char* key) const {
    std::vector<std::size_t> values;
    for (const std::string_view word : words) {
      std::size_t value = 0;
      if (!parse_count(word, value)) {
        refuse_line(reader_.line_number(),
                    std::string(key) + " has " + in_quotes(word) + "; expected a whole number");
      }
      values.push_back(value);
    }
    return values;
  }

  std::size_t one_number(const Words& words, const char* key) const {
    if (words.size() != 1) {
      refuse_line(reader_.line_number(), std::string(key) + " has " + std::to_string(words.size()) +
                                             " values; expected one");
    }
    return numbers(words, key).front();
  }

  PcdData data_kind(const Words& words) const {
    const std::string_view kind = words.size() == 2 ? words[1] : std::string_view{};
    if (kind == "ascii") {
      return PcdData::ascii;
    }
    if (kind == "binary") {
      return PcdData::binary;
    }
    if (kind == "binary_compressed") {
      return PcdData::binary_compressed;
    }
    refuse_line(reader_.line_number(),
                "DATA is " + in_quotes(kind) + "; expected ascii, binary or binary_compressed");
  }

  void finish() {
    header_.lines = reader_.line_number();
    header_.data_offset = reader_.offset();
    add_fields();
    add_size();
  }

  void add_fields() {
    const std::size_t n = names_.size();
    if (counts_.empty()) {
      counts_.assign(n, 1);
    }
    if (n == 0 || sizes_.size() != n || types_.size() != n || counts_.size() != n) {
      refuse_line(header_.lines, std::to_string(n) + " FIELDS, " + std::to_string(sizes_.size()) +
                                     " SIZE, " + std::to_string(types_.size()) + " TYPE and " +
                                     std::to_string(counts_.size()) +
                                     " COUNT values; expected as many of each, at least one");
    }
    if (n > kMostFields) {
      refuse_line(header_.lines,
                  std::to_string(n) + " FIELDS; expected at most " + std::to_string(kMostFields));
    }
    std::size_t elements = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::optional<ScalarType> type = scalar_type(types_[i], sizes_[i]);
      if (!type) {
        refuse_line(header_.lines, "field " + in_quotes(names_[i]) + " has TYPE " +
                                       in_quotes(types_[i]) + " SIZE " + std::to_string(sizes_[i]) +
                                       "; expected I or U of 1, 2, 4, 8 or F of 4, 8");
      }
      // Every element takes a byte at least, so that one point is never larger than the file.
      if (counts_[i] == 0 || counts_[i] > file_size_ - elements) {
        refuse_line(header_.lines,
                    "field " + in_quotes(names_[i]) + " has COUNT " + std::to_string(counts_[i]) +
                        "; expected 1 or more, and no more " + "than the file can hold");
      }
      elements += counts_[i];
      header_.fields.push_back({std::string(names_[i]), *type, counts_[i], header_.point_step});
      header_.point_step += counts_[i] * sizes_[i];
    }
  }

  void add_size() {
    if (!width_ && !points_) {
      refuse_line(header_.lines, "neither WIDTH nor POINTS given");
    }
    if (width_) {
      const std::size_t height = height_.value_or(1);
      if (height != 0 && *width_ > std::numeric_limits<std::size_t>::max() / height) {
        refuse_line(header_.lines, "WIDTH " + std::to_string(*width_) + " x HEIGHT " +
                                       std::to_string(height) + " is not a number of points");
      }
      header_.points = *width_ * height;
      if (header_.points == 0 && points_) header_.points = *points_;  // of no grid
      if (points_ && *points_ != header_.points) {
        refuse_line(header_.lines, "POINTS " + std::to_string(*points_) +
                                       " but WIDTH x HEIGHT is " + std::to_string(header_.points));
      }
    } else {
      header_.points = *points_;
    }
  }

  LineReader reader_;
  std::size_t file_size_;
  PcdHeader header_;
  Words names_, types_;
  std::vector<std::size_t> sizes_, counts_;
  std::optional<std::size_t> width_, height_, points_;
};

}  // namespace

PcdHeader parse_pcd_header(std::string_view file) { return HeaderLines(file).parse(); }

}  // namespace surefoot::io
