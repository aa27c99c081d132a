// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// An ablation as tables and files: changes down, figures or recordings across.
#pragma once

#include <string>
#include <vector>

#include "evaluation/ablation.hpp"
#include "evaluation/marked_table.hpp"

namespace surefoot::evaluation {

/// What each change does over all recordings; its error on each recording.
[[nodiscard]] std::vector<Table> ablation_tables(const Ablation& ablation);
/// What has to be known to read them, one sentence each; every failed run with its reason.
[[nodiscard]] std::vector<std::string> ablation_notes(const Ablation& ablation,
                                                      const Comparison& comparison);

/// Whole files. docs/evaluation.md lists keys and columns.
[[nodiscard]] std::string ablation_markdown(const Ablation& ablation, const Comparison& comparison);
[[nodiscard]] std::string ablation_csv(const Ablation& ablation);
[[nodiscard]] std::string ablation_json(const Ablation& ablation, const Comparison& comparison);

}  // namespace surefoot::evaluation
