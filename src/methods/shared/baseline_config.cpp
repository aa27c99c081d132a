// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/baseline_config.hpp"

#include <utility>

namespace surefoot {

Config baseline_config(std::string method) {
  Config config;
  config.method = std::move(method);
  config.preprocess.min_range = 0.0;
  config.preprocess.max_range = 1000.0;
  config.level.mode = LevelMode::none;
  return config;
}

}  // namespace surefoot
