// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Evaluations as JSON objects, for files that hold more than evaluations.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "evaluation/evaluate.hpp"

namespace surefoot::evaluation {

/// Every figure in full precision; keys carry units where they are not SI.
[[nodiscard]] nlohmann::ordered_json json_of(const Evaluation& evaluation);
/// What an evaluation was asked for, in the words of the program's flags.
[[nodiscard]] nlohmann::ordered_json json_of(const EvaluationOptions& options);
/// Text with two spaces a level; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace surefoot::evaluation
