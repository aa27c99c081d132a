// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "evaluation/comparison.hpp"

namespace surefoot::evaluation {

/// compare.json: everything about a comparison, the tables included; docs/evaluation.md lists keys
/// and units.
[[nodiscard]] std::string to_json(const Comparison& comparison);

}  // namespace surefoot::evaluation
