// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The tables of docs/equations.md (the paper's) and docs/method.md (Surefoot's own) against the
// code: every row's tag, function and test exist, every equation has a row, every tag in the code
// has one.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "docs/source_files.hpp"

namespace surefoot {
namespace {

constexpr int kPaperEquations = 34;
constexpr int kOwnEquations = 41;

struct Row {
  std::string equation;  // "(6)", "[K6]" or "Algorithm 1"
  std::string tag, function, file, test, test_file;
};

/// Text between the first pair of backticks of a cell.
std::string code_of(const std::string& cell) {
  const auto begin = cell.find('`');
  const auto end = begin == std::string::npos ? begin : cell.find('`', begin + 1);
  return end == std::string::npos ? "" : cell.substr(begin + 1, end - begin - 1);
}

/// Target of a cell's link, from the project's root; "" if it does not begin with "../".
std::string link_of(const std::string& cell) {
  const auto begin = cell.find("](../");
  const auto end = begin == std::string::npos ? begin : cell.find(')', begin);
  return end == std::string::npos ? "" : cell.substr(begin + 5, end - begin - 5);
}

bool is_row(const std::string& line) {
  static const std::regex equation("^\\| (\\(\\d+\\)|\\[K\\d+\\]|Algorithm 1) \\|");
  return std::regex_search(line, equation);
}

void read_rows(const std::string& page, std::vector<Row>& rows) {
  std::istringstream lines(test::read_project_file(page));
  for (std::string line; std::getline(lines, line);) {
    if (!is_row(line)) continue;
    std::vector<std::string> cells;
    std::istringstream columns(line.substr(1));
    for (std::string cell; std::getline(columns, cell, '|');) cells.push_back(cell);
    if (cells.size() < 7) {
      ADD_FAILURE() << "a row of " << cells.size() << " cells: " << line;
      continue;
    }
    const std::string equation = cells[0].substr(1, cells[0].size() - 2);
    rows.push_back({equation, code_of(cells[1]), code_of(cells[3]), link_of(cells[4]),
                    code_of(cells[5]), link_of(cells[6])});
  }
}

/// The rows of both tables.
const std::vector<Row>& table() {
  static const std::vector<Row> rows = [] {
    std::vector<Row> both;
    for (const char* page : {"docs/equations.md", "docs/method.md"}) read_rows(page, both);
    return both;
  }();
  return rows;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The equation that a tag marks: "(6)" of "[Eq 6]", "[K6]" of itself.
std::string equation_of(const std::string& tag) {
  if (tag.rfind("[Eq ", 0) != 0) return tag;
  return "(" + tag.substr(4, tag.size() - 5) + ")";
}

TEST(EquationsTable, EveryEquationAndTheAlgorithmHaveARow) {
  std::set<std::string> equations, expected = {"Algorithm 1"};
  for (const Row& row : table()) equations.insert(row.equation);
  for (int n = 1; n <= kPaperEquations; ++n) expected.insert("(" + std::to_string(n) + ")");
  for (int n = 1; n <= kOwnEquations; ++n) expected.insert("[K" + std::to_string(n) + "]");
  EXPECT_EQ(equations, expected);
}

TEST(EquationsTable, EveryOwnEquationIsWrittenDown) {
  const std::string page = test::read_project_file("docs/method.md");
  for (int n = 1; n <= kOwnEquations; ++n) {
    const std::string tag = "[K" + std::to_string(n) + "]";
    EXPECT_TRUE(contains(page, "    " + tag + "\n")) << tag << " ends no line of docs/method.md";
  }
}

TEST(EquationsTable, EveryRowsFileCarriesItsTagAndItsFunction) {
  for (const Row& row : table()) {
    ASSERT_FALSE(row.tag.empty() || row.function.empty() || row.file.empty()) << row.equation;
    const std::string text = test::read_project_file(row.file);
    ASSERT_FALSE(text.empty()) << row.equation << ": no file " << row.file;
    EXPECT_TRUE(contains(text, row.tag)) << row.file << " does not carry " << row.tag;
    const auto scope = row.function.rfind("::");
    const std::string name =
        scope == std::string::npos ? row.function : row.function.substr(scope + 2);
    EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + name + "\\b")))
        << row.file << " has no " << name;
  }
}

TEST(EquationsTable, TagsAreTheEquationsOwn) {
  for (const Row& row : table()) {
    // (2) is a type and (3) two ways of taking it apart: they have the tags that their rows name.
    if (row.equation == "(2)" || row.equation == "(3)" || row.equation == "Algorithm 1") continue;
    EXPECT_EQ(equation_of(row.tag), row.equation);
  }
}

TEST(EquationsTable, EveryRowsTestExists) {
  for (const Row& row : table()) {
    const std::string text = test::read_project_file(row.test_file);
    ASSERT_FALSE(text.empty()) << row.equation << ": no file " << row.test_file;
    const auto dot = row.test.find('.');
    ASSERT_NE(dot, std::string::npos) << row.equation << ": " << row.test;
    const std::string suite = row.test.substr(0, dot), name = row.test.substr(dot + 1);
    EXPECT_TRUE(
        std::regex_search(text, std::regex("TEST(_P|_F)?\\(" + suite + ",\\s+" + name + "\\)")))
        << row.test_file << " has no test " << row.test;
  }
}

TEST(EquationsTable, EveryTagInTheCodeHasARowThatNamesItsFile) {
  static const std::regex tag("\\[(Eq |K)[0-9]+\\]");
  std::set<std::string> known;
  for (const Row& row : table()) known.insert(row.equation + row.file);
  int tags = 0;
  for (const char* folder : {"src", "include", "apps"}) {
    for (const auto& [path, text] : test::source_files(folder)) {
      for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it, ++tags) {
        EXPECT_TRUE(known.count(equation_of(it->str()) + path))
            << path << " carries " << it->str() << ", which no row says";
      }
    }
  }
  EXPECT_GE(tags, kPaperEquations + kOwnEquations - 2);
}

}  // namespace
}  // namespace surefoot
