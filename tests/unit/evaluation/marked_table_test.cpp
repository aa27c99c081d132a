// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/marked_table.hpp"

#include <gtest/gtest.h>

namespace surefoot::evaluation {
namespace {

Cell value(double number, bool competes = true) {
  return {std::to_string(static_cast<int>(number)), number, competes};
}

Table table_of(std::vector<Cell> cells) {
  Table table{.title = "T", .head_names = {"Sequence", "Figure"}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    table.columns.push_back(std::string(1, 'm').append(std::to_string(i)));
  }
  table.rows.push_back({{"hall", "error"}, std::move(cells)});
  return table;
}

std::string places(const Table& table) {
  std::string text;
  for (const Cell& cell : table.rows[0].cells) {
    text += cell.place == Place::none ? '-' : cell.place == Place::first ? '1' : '2';
  }
  return text;
}

TEST(Rank, SmallestFirstAndEqualValuesShareAPlace) {
  const std::pair<std::vector<Cell>, const char*> cases[] = {
      {{value(3), value(1), value(2)}, "-12"},
      {{value(1), value(1), value(2)}, "112"},
      {{value(1), value(2), value(2)}, "122"},
      {{value(5)}, "1"},
      {{value(0, false), value(4), value(3)}, "-21"},
      {{Cell{"stopped", std::nullopt, true}, value(4)}, "-1"},
      {{Cell{"-"}, Cell{"-"}}, "--"}};
  for (const auto& [cells, expected] : cases) {
    Table table = table_of(cells);
    rank_rows(table);
    EXPECT_EQ(places(table), expected);
  }
}

TEST(Rank, ByColumn) {
  Table table = table_of({value(3), value(1)});
  table.rows.push_back({{"hall", "other"}, {value(2), value(2)}});
  rank_columns(table);
  EXPECT_EQ(places(table), "21");
  EXPECT_EQ(table.rows[1].cells[0].place, Place::first);
  EXPECT_EQ(table.rows[1].cells[1].place, Place::second);
}

TEST(MarkedTable, MarkdownIsPaddedAndMarked) {
  Table table = table_of({value(12), value(3), Cell{"stopped at 41 %"}});
  table.rows.push_back({{"hall", "a|b"}, {value(7), value(8), Cell{"–"}}});
  rank_rows(table);
  EXPECT_EQ(to_markdown(table),
            "| Sequence | Figure |        m0 |       m1 |              m2 |\n"
            "|----------|--------|----------:|---------:|----------------:|\n"
            "| hall     | error  | <u>12</u> |    **3** | stopped at 41 % |\n"
            "|          | a\\|b   |     **7** | <u>8</u> |               – |\n");
}

TEST(MarkedTable, ATerminalsMarksTakeNoRoom) {
  Table table = table_of({value(12), value(3)});
  rank_rows(table);
  const std::string text = to_markdown(table, terminal_marks());
  EXPECT_NE(text.find("|  \033[4m12\033[0m |   \033[1m3\033[0m |"), std::string::npos) << text;
}

TEST(MarkedTable, LatexMarksAndEscapes) {
  Table table = table_of({value(12), value(3)});
  table.rows[0].heads = {"a_b & c", "100 %"};
  table.rows.push_back({{"other", "error"}, {value(1), value(1)}});
  rank_rows(table);
  EXPECT_EQ(to_latex(table),
            "% T\n\\begin{tabular}{llrr}\n\\toprule\nSequence & Figure & m0 & m1 \\\\\n\\midrule\n"
            "a\\_b \\& c & 100 \\% & \\underline{12} & \\textbf{3} \\\\\n\\midrule\n"
            "other & error & \\textbf{1} & \\textbf{1} \\\\\n\\bottomrule\n\\end{tabular}\n");
  EXPECT_EQ(latex_text("\\~^"), "\\textbackslash{}\\~{}\\^{}");
  EXPECT_EQ(latex_text("\u2248 0.1|<a>"), "$\\approx$ 0.1\\textbar{}\\textless{}a\\textgreater{}");
  EXPECT_EQ(latex_text("\u00e4\u2013\u2249"), "\u00e4\u2013\u2249");
}

TEST(MarkedTable, CsvHasALineForEachCell) {
  Table table = table_of({value(12), Cell{"a, \"b\""}});
  table.rows[0].cells[0].value = 12.345678901234567;
  rank_rows(table);
  EXPECT_EQ(to_csv(table),
            "T,hall,error,m0,12.345678901234567,12,1\nT,hall,error,m1,,\"a, \"\"b\"\"\",\n");
  Table two = table_of({value(12), value(3)});
  rank_rows(two);
  EXPECT_EQ(to_csv(two), "T,hall,error,m0,12,12,2\nT,hall,error,m1,3,3,1\n");
}

}  // namespace
}  // namespace surefoot::evaluation
