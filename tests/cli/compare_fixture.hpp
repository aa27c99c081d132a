// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Two short recordings to compare methods on, and what compare.json says of them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {

namespace fs = std::filesystem;
using nlohmann::json;

class Compare : public testing::Test {
 protected:
  void SetUp() override {
    write_bend_recording(scratch_.path() / "left", 0.6, kScans);
    write_bend_recording(scratch_.path() / "right", -0.8, kScans);
  }

  [[nodiscard]] ProcessResult compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    arguments.insert(arguments.end(), {"--delta", "0.5"});
    return run_surefoot(arguments, scratch_.path());
  }
  [[nodiscard]] json results(const std::string& folder) const {
    return json::parse(file_content(scratch_.path() / folder / "compare.json"), nullptr, false);
  }
  [[nodiscard]] std::string content(const std::string& file) const {
    return file_content(scratch_.path() / file);
  }
  /// When each file below a folder was written.
  [[nodiscard]] std::map<std::string, fs::file_time_type> times(const std::string& folder) const {
    std::map<std::string, fs::file_time_type> found;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_.path() / folder)) {
      if (entry.is_regular_file()) found[entry.path().string()] = entry.last_write_time();
    }
    return found;
  }

  /// The cell of a table in compare.json.
  static json cell(const json& results, std::size_t table, const std::string& sequence,
                   const std::string& figure, const std::string& method) {
    for (const json& row : results["tables"][table]["rows"]) {
      if (row["sequence"] != sequence || row["figure"] != figure) continue;
      for (const json& entry : row["cells"]) {
        if (entry["method"] == method) return entry;
      }
    }
    ADD_FAILURE() << "no cell " << sequence << ", " << figure << ", " << method;
    return {};
  }

  static json result(const json& results, const std::string& recording, const std::string& method) {
    for (const json& each : results["recordings"]) {
      if (each["name"] != recording) continue;
      for (const json& entry : each["results"]) {
        if (entry["method"] == method) return entry;
      }
    }
    ADD_FAILURE() << "no result " << recording << ", " << method;
    return {};
  }

  /// Everything about errors and verdicts, nothing about times.
  static json errors_of(const json& results) {
    json errors;
    for (const json& recording : results["recordings"]) {
      for (const json& each : recording["results"]) {
        errors.push_back({recording["name"], each["method"], each["outcome"], each["evaluation"],
                          each["evaluation_from_start"]});
      }
    }
    return errors;
  }

  static constexpr std::size_t kScans = 12;
  ScratchFolder scratch_;
};

}  // namespace surefoot::test
