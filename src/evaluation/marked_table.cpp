// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/marked_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace surefoot::evaluation {

namespace {

constexpr std::string_view kAlmost = "\u2248";  // no letter of LaTeX's

/// Letters of UTF-8 text: its bytes without those that continue a letter.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string padded(const std::string& text, std::size_t width, std::size_t shown, bool right) {
  const std::string space(width > shown ? width - shown : 0, ' ');
  return right ? space + text : text + space;
}

std::string marked(const Cell& cell, const Marks& marks) {
  if (cell.place == Place::first) return marks.first_open + cell.text + marks.first_close;
  if (cell.place == Place::second) return marks.second_open + cell.text + marks.second_close;
  return cell.text;
}

/// The heads of a row; the first is left out where it repeats the row's above.
std::vector<std::string> shown_heads(const Table& table, std::size_t row) {
  std::vector<std::string> heads = table.rows[row].heads;
  if (heads.size() > 1 && row > 0 && heads[0] == table.rows[row - 1].heads[0]) heads[0].clear();
  return heads;
}

/// A bar within a cell would end it.
std::string markdown_text(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, 1, '\\');
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// All lines of a Markdown table as fields, and how wide each is on the screen.
struct Grid {
  struct Field {
    std::string text;
    std::size_t shown;
  };
  std::vector<std::vector<Field>> lines;

  void add(std::vector<Field>& line, const std::string& text, std::size_t marks) const {
    const std::string clean = markdown_text(text);
    line.push_back({clean, letters(clean) - marks});
  }
  [[nodiscard]] std::size_t width(std::size_t column) const {
    std::size_t widest = 3;
    for (const auto& line : lines) widest = std::max(widest, line[column].shown);
    return widest;
  }
};

Grid make_grid(const Table& table, const Marks& marks, bool marks_are_shown) {
  Grid grid;
  std::vector<Grid::Field> names;
  for (const std::string& name : table.head_names) grid.add(names, name, 0);
  for (const std::string& name : table.columns) grid.add(names, name, 0);
  grid.lines.push_back(names);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::vector<Grid::Field> line;
    for (const std::string& head : shown_heads(table, row)) grid.add(line, head, 0);
    for (const Cell& cell : table.rows[row].cells) {
      const std::string text = marked(cell, marks);
      grid.add(line, text, marks_are_shown ? 0 : letters(text) - letters(cell.text));
    }
    grid.lines.push_back(line);
  }
  return grid;
}

std::string latex_cell(const Cell& cell) {
  const std::string text = latex_text(cell.text);
  if (cell.place == Place::first) return "\\textbf{" + text + "}";
  return cell.place == Place::second ? "\\underline{" + text + "}" : text;
}

std::string latex_line(const std::vector<std::string>& fields) {
  return fmt::format("{} \\\\\n", fmt::join(fields, " & "));
}

}  // namespace

void rank(std::span<Cell* const> cells) {
  std::vector<double> values;
  for (const Cell* cell : cells) {
    if (cell->competes && cell->value) values.push_back(*cell->value);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  for (Cell* cell : cells) {
    cell->place = Place::none;
    if (!cell->competes || !cell->value) continue;
    if (*cell->value == values[0]) cell->place = Place::first;
    if (values.size() > 1 && *cell->value == values[1]) cell->place = Place::second;
  }
}

void rank_rows(Table& table) {
  for (TableRow& row : table.rows) {
    std::vector<Cell*> cells;
    for (Cell& cell : row.cells) cells.push_back(&cell);
    rank(cells);
  }
}

void rank_columns(Table& table) {
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::vector<Cell*> cells;
    for (TableRow& row : table.rows) cells.push_back(&row.cells[column]);
    rank(cells);
  }
}

Marks markdown_marks() { return {"**", "**", "<u>", "</u>"}; }

Marks terminal_marks() { return {"\033[1m", "\033[0m", "\033[4m", "\033[0m"}; }

std::string to_markdown(const Table& table, const Marks& marks) {
  const bool marks_are_shown = marks.first_open.find('\033') == std::string::npos;
  const Grid grid = make_grid(table, marks, marks_are_shown);
  std::string text;
  for (std::size_t row = 0; row < grid.lines.size(); ++row) {
    std::string rule;
    for (std::size_t column = 0; column < grid.lines[row].size(); ++column) {
      const auto& [field, shown] = grid.lines[row][column];
      const std::size_t width = grid.width(column);
      const bool right = column >= table.head_names.size();
      text += fmt::format("| {} ", padded(field, width, shown, right));
      rule += fmt::format("|{:-<{}}{}", "", width + 1, right ? ':' : '-');
    }
    text += "|\n";
    if (row == 0) text += rule + "|\n";
  }
  return text;
}

std::string to_latex(const Table& table) {
  std::vector<std::string> names;
  for (const std::string& name : table.head_names) names.push_back(latex_text(name));
  for (const std::string& name : table.columns) names.push_back(latex_text(name));
  std::string latex = fmt::format("% {}\n\\begin{{tabular}}{{{}{}}}\n\\toprule\n", table.title,
                                  std::string(table.head_names.size(), 'l'),
                                  std::string(table.columns.size(), 'r'));
  latex += latex_line(names) + "\\midrule\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::vector<std::string> fields;
    for (const std::string& head : shown_heads(table, row)) fields.push_back(latex_text(head));
    const bool grouped = table.head_names.size() > 1;
    if (grouped && row > 0 && table.rows[row].heads[0] != table.rows[row - 1].heads[0]) {
      latex += "\\midrule\n";
    }
    for (const Cell& cell : table.rows[row].cells) fields.push_back(latex_cell(cell));
    latex += latex_line(fields);
  }
  return latex + "\\bottomrule\n\\end{tabular}\n";
}

std::string to_csv(const Table& table) {
  std::string csv;
  for (const TableRow& row : table.rows) {
    for (std::size_t column = 0; column < row.cells.size(); ++column) {
      const Cell& cell = row.cells[column];
      csv += csv_field(table.title);
      for (const std::string& head : row.heads) csv += ',' + csv_field(head);
      csv += ',' + csv_field(table.columns[column]) + ',';
      if (cell.value) csv += fmt::format("{}", *cell.value);
      csv += ',' + csv_field(cell.text) + ',';
      if (cell.place != Place::none) csv += cell.place == Place::first ? '1' : '2';
      csv += '\n';
    }
  }
  return csv;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string latex_text(const std::string& text) {
  std::string escaped;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (std::string("&%$#_{}").find(c) != std::string::npos) {
      escaped += std::string("\\") + c;
    } else if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      escaped += std::string("\\") + c + "{}";
    } else if (c == '|' || c == '<' || c == '>') {  // other signs in LaTeX's usual font encoding
      escaped += c == '|' ? "\\textbar{}" : c == '<' ? "\\textless{}" : "\\textgreater{}";
    } else if (text.compare(at, kAlmost.size(), kAlmost) == 0) {
      escaped += "$\\approx$";
      at += kAlmost.size() - 1;
    } else {
      escaped += c;
    }
  }
  return escaped;
}

}  // namespace surefoot::evaluation
