// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Who may include whom: the order that docs/architecture.md describes, read from the sources.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "docs/source_files.hpp"

namespace surefoot {
namespace {

using test::SourceFile;

/// The first folder of an include; "" for a file beside the one that includes it.
std::string folder_of(const std::string& include) {
  const auto slash = include.find('/');
  return slash == std::string::npos ? "" : include.substr(0, slash);
}

/// "odometry/deskew.hpp" and "src/odometry/deskew.cpp" are both of the step "deskew".
std::string stem_of(const std::string& path) {
  const auto slash = path.rfind('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  return name.substr(0, name.find('.'));
}

void expect_only(const std::string& folder, const std::set<std::string>& allowed) {
  const auto files = test::source_files(folder);
  EXPECT_FALSE(files.empty()) << folder;
  for (const auto& [path, text] : files) {
    for (const std::string& include : test::quoted_includes(text)) {
      EXPECT_TRUE(allowed.count(folder_of(include))) << path << " includes " << include;
    }
  }
}

bool includes(const std::string& layer, const std::string& other) {
  for (const auto& [path, text] : test::source_files("src/" + layer)) {
    for (const std::string& include : test::quoted_includes(text)) {
      if (folder_of(include) == other) return true;
    }
  }
  return false;
}

/// The layers of src, lower ones first, and what each includes besides itself and the public
/// headers: layers further up in this list alone, so that there is no circle. docs/architecture.md
/// draws them.
struct Layer {
  const char* folder;
  std::set<std::string> sees;
};
const std::vector<Layer> kLayers = {
    // The library.
    {"geometry", {}},
    {"config", {}},
    {"core", {"geometry"}},
    {"methods", {"geometry", "config", "core"}},
    // The components of the program.
    {"text", {}},
    {"sensors", {}},
    {"io", {"geometry", "text", "sensors"}},
    {"live", {"text", "io"}},
    {"ros1", {"text", "io", "live"}},
    {"ros2", {"text", "io", "live"}},
    {"mapping", {"geometry", "core"}},
    {"evaluation", {"geometry"}},
    {"simulation", {"geometry", "sensors"}},
    {"report", {"text"}},
    {"live_page", {"core", "live", "report"}},
    {"process", {}},
    {"command_line", {"text", "process"}},
    {"runs", {"geometry", "text", "io", "mapping", "evaluation", "report", "process"}},
    {"live_runs", {"text", "live", "runs"}},
    {"checks", {"geometry", "text", "io", "report", "runs"}},
    {"experiments", {"text", "io", "evaluation", "simulation", "report", "process", "runs"}},
    {"recordings", {"sensors", "io", "simulation", "report", "process"}},
};

TEST(IncludeOrder, PublicHeadersIncludeEachOtherOnly) {
  expect_only("include/surefoot", {"surefoot"});
}

TEST(IncludeOrder, EveryLayerSeesTheLayersBelowThatTheTableNames) {
  std::set<std::string> known;
  for (const Layer& layer : kLayers) {
    std::set<std::string> allowed = layer.sees;
    allowed.insert({"surefoot", layer.folder});
    expect_only("src/" + std::string(layer.folder), allowed);
    for (const std::string& below : layer.sees) {
      EXPECT_TRUE(known.count(below)) << layer.folder << " sees " << below << ", not below it";
      EXPECT_TRUE(includes(layer.folder, below)) << layer.folder << " sees nothing of " << below;
    }
    known.insert(layer.folder);
  }
  for (const auto& [path, text] : test::source_files("src")) {
    EXPECT_TRUE(known.count(folder_of(path.substr(4)))) << path << " lies in no layer";
  }
}

TEST(IncludeOrder, ProgramsSeeThePublicHeadersAndTheComponents) {
  std::set<std::string> allowed = {"", "surefoot"};
  for (const Layer& layer : kLayers) allowed.insert(layer.folder);
  for (const char* inside : {"core", "config", "methods"}) allowed.erase(inside);
  expect_only("apps", allowed);
  allowed.insert("shared");  // by the bindings
  expect_only("bindings", allowed);
}

/// The steps of a scan. What else lies in src/core are bricks that any step may use.
const std::set<std::string> kSteps = {"deskew",      "downsample", "health",
                                      "information", "level",      "preprocess"};
/// These know several steps.
const std::set<std::string> kConductors = {"odometry"};
/// A step that takes what another one returns includes its type; levelling thins its clouds.
const std::set<std::pair<std::string, std::string>> kHandovers = {{"deskew", "preprocess"},
                                                                  {"front_end", "preprocess"},
                                                                  {"level", "downsample"},
                                                                  {"upright", "downsample"}};

TEST(IncludeOrder, StepsOfTheOdometryDoNotIncludeEachOther) {
  std::set<std::string> seen;
  std::set<std::pair<std::string, std::string>> handovers;
  for (const auto& [path, text] : test::source_files("src/core")) {
    const std::string from = stem_of(path);
    seen.insert(from);
    if (kConductors.count(from)) continue;
    for (const std::string& include : test::quoted_includes(text)) {
      const std::string to = stem_of(include);
      if (folder_of(include) != "core" || from == to || !kSteps.count(to)) continue;
      if (kHandovers.count({from, to})) {
        handovers.insert({from, to});
      } else {
        ADD_FAILURE() << path << " includes the step " << include;
      }
    }
  }
  for (const std::string& step : kSteps) EXPECT_TRUE(seen.count(step)) << "no step " << step;
  EXPECT_EQ(handovers, kHandovers) << "an exception that is no longer needed should go";
}

TEST(IncludeOrder, TheLibraryPrintsNothingAndReadsNoClock) {
  static const std::regex forbidden(
      "<iostream>|<chrono>|<ctime>|std::(cout|cerr|clog|abort|exit|terminate)\\b"
      "|\\b(printf|fprintf|puts|getenv)\\(");
  for (const char* folder : {"src/geometry", "src/core", "src/config", "src/methods", "include"}) {
    for (const auto& [path, text] : test::source_files(folder)) {
      std::smatch found;
      EXPECT_FALSE(std::regex_search(text, found, forbidden)) << path << ": " << found.str();
    }
  }
}

}  // namespace
}  // namespace surefoot
