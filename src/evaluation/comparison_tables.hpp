// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A comparison as the tables that papers print: recordings down, methods across.
#pragma once

#include <string>
#include <vector>

#include "evaluation/comparison.hpp"
#include "evaluation/marked_table.hpp"

namespace surefoot::evaluation {

/// With several recordings of a scene, first what they have in common, see seeds.hpp. Then
/// absolute error; relative error, height, attitude and drift; time and memory; what is missing or
/// went wrong. A run that is not whole has its verdict in the place of its errors and is ranked
/// nowhere.
[[nodiscard]] std::vector<Table> comparison_tables(const Comparison& comparison);

/// What has to be known to read them, one sentence each: the alignment, shared processors, repeats,
/// every failure with its reason.
[[nodiscard]] std::vector<std::string> comparison_notes(const Comparison& comparison);

/// Of these the ones that name failed runs and repeats that differ.
[[nodiscard]] std::vector<std::string> trouble_notes(const Comparison& comparison);
/// The one that says how estimates were aligned.
[[nodiscard]] std::string alignment_note(const EvaluationOptions& options);

/// The relative error's name in the tables, and what turns its RMSE [m] into the figure shown.
[[nodiscard]] std::string relative_figure_name(const PairOptions& stretches);
[[nodiscard]] double relative_factor(const PairOptions& stretches);

/// Whole files of all tables. Markdown and LaTeX have the notes, too.
[[nodiscard]] std::string tables_markdown(const Comparison& comparison,
                                          const Marks& marks = markdown_marks());
[[nodiscard]] std::string tables_latex(const Comparison& comparison);
[[nodiscard]] std::string tables_csv(const Comparison& comparison);

}  // namespace surefoot::evaluation
