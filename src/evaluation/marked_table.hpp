// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A table whose best and second best entries are marked, for terminals, web pages and papers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace surefoot::evaluation {

enum class Place { none, first, second };

struct Cell {
  std::string text;                  ///< as shown, without marks
  std::optional<double> value = {};  ///< the number behind the text, where there is one
  bool competes = false;             ///< takes part in the ranking; needs a value
  Place place = Place::none;         ///< set by rank()
};

struct TableRow {
  std::vector<std::string> heads = {};  ///< what the row is about: one text for each head column
  std::vector<Cell> cells = {};         ///< one for each of the other columns
};

struct Table {
  std::string title;
  std::vector<std::string> head_names = {};
  std::vector<std::string> columns = {};
  std::vector<TableRow> rows = {};
};

/// Gives the smallest of the competing values the first place and the next larger one the second;
/// equal values share a place.
void rank(std::span<Cell* const> cells);
/// rank() within each row, or within each column.
void rank_rows(Table& table);
void rank_columns(Table& table);

/// What is written before and after an entry of first or second place.
struct Marks {
  std::string first_open, first_close, second_open, second_close;
};
[[nodiscard]] Marks markdown_marks();  ///< **bold** and <u>underlined</u>
[[nodiscard]] Marks terminal_marks();  ///< the same by ANSI's control sequences

/// Markdown, padded so that it can be read as it is. A first head equal to the one above is left
/// empty.
[[nodiscard]] std::string to_markdown(const Table& table, const Marks& marks = markdown_marks());
/// A tabular (booktabs) with \textbf and \underline; the title is a comment above it.
[[nodiscard]] std::string to_latex(const Table& table);
/// A line for each cell, without a line of names: title, heads, column, value in full precision
/// (empty where there is none), text, place (1, 2 or empty); RFC 4180.
[[nodiscard]] std::string to_csv(const Table& table);

/// Text as a field of CSV, quoted where that is needed; and as LaTeX that shows the same.
[[nodiscard]] std::string csv_field(const std::string& text);
[[nodiscard]] std::string latex_text(const std::string& text);

}  // namespace surefoot::evaluation
