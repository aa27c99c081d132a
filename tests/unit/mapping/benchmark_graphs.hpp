// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Pose graphs that the field measures itself by, from ../shared/data.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "mapping/g2o_file.hpp"

namespace surefoot::test {

inline std::optional<mapping::PoseGraph> benchmark_graph(const std::string& name) {
  std::ifstream file(std::filesystem::path(SUREFOOT_SHARED_DATA) / "pose_graphs" / name);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return mapping::parse_g2o(text.str());
}

}  // namespace surefoot::test
