// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Estimates from anywhere against one reference.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "evaluation/evaluate.hpp"
#include "runs/trajectory_inputs.hpp"

namespace surefoot::experiments {

struct EvaluationRequest {
  runs::ReferenceRequest reference;
  std::vector<std::filesystem::path> estimates;
  std::string estimate_topic;  ///< of those that are bags; empty: the only one with poses
  evaluation::EvaluationOptions evaluation;
  std::vector<std::filesystem::path> figures;  ///< of the aligned paths: .svg, .pdf or .png
  std::filesystem::path pose_errors;           ///< a CSV of every pose's errors; empty: none
  bool overwrite = false;                      ///< whatever files have the figures' names
};

struct EvaluationListener {
  std::function<void(const std::string& text)> note;
  /// Of an estimate that cannot be evaluated: it is left out, the others go on.
  std::function<void(const std::string& text)> complain;
};

/// Throws io::ReadError, std::runtime_error where the reference is none or no figure can be drawn.
[[nodiscard]] std::vector<evaluation::Evaluation> evaluate_estimates(
    const EvaluationRequest& request, const EvaluationListener& listener);

}  // namespace surefoot::experiments
