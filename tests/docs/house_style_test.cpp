// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What clang-format cannot hold of the style that CONTRIBUTING.md describes, and names that mean
// one thing each.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "docs/source_files.hpp"

namespace surefoot {
namespace {

using test::SourceFile;

std::vector<SourceFile> all_sources() {
  std::vector<SourceFile> files;
  for (const char* folder : {"include", "src", "apps", "benchmarks", "bindings", "tests"}) {
    for (SourceFile& file : test::source_files(folder)) files.push_back(std::move(file));
  }
  return files;
}

/// Every match of a pattern's first group.
std::vector<std::string> found(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> result;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    result.push_back((*match)[1]);
  }
  return result;
}

TEST(HouseStyle, EnumeratorsAreSnakeCase) {
  const std::regex body(R"(enum class \w+[^{;]*\{([^}]*)\})");
  const std::regex constant(R"((?:^|[\s,{])(k[A-Z]\w*))");
  for (const SourceFile& file : all_sources()) {
    for (const std::string& enumerators : found(file.text, body)) {
      for (const std::string& name : found(enumerators, constant)) {
        ADD_FAILURE() << file.path << ": enumerator " << name;
      }
    }
  }
}

TEST(HouseStyle, StatementBelowItsConditionHasBraces) {
  const std::regex bare(R"(\n *((?:if|for|while) \([^\n]*\))\n *[a-z_:A-Z])");
  for (const SourceFile& file : all_sources()) {
    for (const std::string& head : found(file.text, bare)) {
      ADD_FAILURE() << file.path << ": " << head;
    }
  }
}

TEST(HouseStyle, TypesHaveOneMeaning) {
  const std::regex defined(R"(\n(?:struct|class|enum class) (\w+)[^;\n]*\{)");
  std::map<std::string, std::string> files_by_type;
  for (const char* folder : {"include", "src"}) {
    for (const SourceFile& file : test::source_files(folder)) {
      if (!file.path.ends_with(".hpp")) continue;
      for (const std::string& type : found(file.text, defined)) {
        const auto [at, added] = files_by_type.emplace(type, file.path);
        EXPECT_TRUE(added) << type << " is defined by " << at->second << " and by " << file.path;
      }
    }
  }
}

}  // namespace
}  // namespace surefoot
