// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// docs/outputs.md, held to the names that are written.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "runs/loops_csv.hpp"
#include "runs/run_files.hpp"
#include "runs/scans_csv.hpp"

namespace surefoot::runs {
namespace {

std::string page() {
  std::ifstream stream(SUREFOOT_OUTPUTS_PAGE);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What stands below a heading, up to the next one.
std::string section(const std::string& heading) {
  const std::string text = page();
  const std::size_t begin = text.find("\n## " + heading + "\n");
  EXPECT_NE(begin, std::string::npos) << heading;
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

/// The names in the first cells of a section's table, each in backticks.
std::vector<std::string> first_cells(const std::string& heading) {
  std::vector<std::string> names;
  std::istringstream lines(section(heading));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string cell = line.substr(0, line.find('|', 1));
    for (std::size_t at = 0; (at = cell.find('`', at)) != std::string::npos;) {
      const std::size_t end = cell.find('`', at + 1);
      names.push_back(cell.substr(at + 1, end - at - 1));
      at = end + 1;
    }
  }
  return names;
}

std::vector<std::string> fields(std::string header) {
  header.pop_back();  // the line's end
  std::vector<std::string> names;
  std::istringstream words(header);
  for (std::string word; std::getline(words, word, ',');) names.push_back(word);
  return names;
}

TEST(OutputsPage, HasEveryFileOfARun) {
  const std::string text = section("A run's folder");
  for (const char* file : kRunFiles) {
    EXPECT_NE(text.find(std::string("`") + file + "`"), std::string::npos) << file;
  }
  EXPECT_NE(text.find(std::string("`") + kPiecesFile + "`"), std::string::npos);
  for (const char* files : {kSegmentFiles, kMapFrameFiles}) {
    EXPECT_NE(text.find(std::string("`") + files), std::string::npos) << files;
  }
}

TEST(OutputsPage, HasEveryColumnOfScansCsv) {
  std::vector<std::string> told = first_cells("scans.csv");
  std::vector<std::string> written = fields(scans_csv_header());
  // Stages stand beside each other on the page.
  std::sort(told.begin(), told.end());
  std::sort(written.begin(), written.end());
  EXPECT_EQ(told, written);
}

TEST(OutputsPage, HasEveryColumnOfLoopsCsv) {
  const std::vector<std::string> cells = first_cells("loops.csv");
  const std::set<std::string> told(cells.begin(), cells.end());
  for (const std::string& name : fields(join_csv_header())) {
    if (name != "map") {
      EXPECT_TRUE(told.contains(name)) << name;
    }
  }
  const std::vector<std::string> written = fields(loops_csv({}, {}, nullptr));
  EXPECT_EQ(told, std::set<std::string>(written.begin(), written.end()));
}

}  // namespace
}  // namespace surefoot::runs
