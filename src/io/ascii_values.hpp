// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Text of lines and words, and numbers in it, as ASCII PCD and PLY and the stamp files have them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_table.hpp"

namespace surefoot::io {

/// The bytes of a file as characters.
[[nodiscard]] inline std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Bytes of the mark that some editors put before UTF-8: 3, or none.
[[nodiscard]] inline std::size_t byte_order_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

/// Reads a text line by line and knows where it is. Lines end with LF or CRLF.
class LineReader {
 public:
  /// `lines_before`: of the file that the text is a part of.
  explicit LineReader(std::string_view text, std::size_t lines_before = 0)
      : text_(text),
        offset_(lines_before == 0 ? byte_order_mark(text) : 0),
        line_number_(lines_before) {}

  /// Moves to the next line; false at the end of the text.
  [[nodiscard]] bool next(std::string_view& line);
  /// Number of the line given last, from 1.
  [[nodiscard]] std::size_t line_number() const { return line_number_; }
  /// Where the next line begins [bytes].
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  std::string_view text_;
  std::size_t offset_;
  std::size_t line_number_;
};

/// Throws ReadError: "line 7: what".
[[noreturn]] void fail_at_line(std::size_t line, const std::string& what);

/// Whether a word is digits alone.
[[nodiscard]] bool is_whole(std::string_view word);

/// Takes the first word off the text; empty when only white space is left.
[[nodiscard]] std::string_view take_word(std::string_view& text);
/// All words of a line.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);

/// Whole unsigned number, or false.
[[nodiscard]] bool parse_count(std::string_view word, std::size_t& count);
/// Finite number, NaN or infinity with nothing after it, or false.
[[nodiscard]] bool parse_real(std::string_view word, double& value);
/// Writes the number in `word` as `type` (native byte order) to `out`; false where the word is not
/// a number of that type or does not fit it.
[[nodiscard]] bool store_number(std::string_view word, ScalarType type, std::byte* out);

/// What can be shown of a word in a message: printable and not longer than 40 characters.
[[nodiscard]] std::string in_quotes(std::string_view word);

}  // namespace surefoot::io
