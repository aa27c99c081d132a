// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Evaluations as text: for people, for programs and for papers.
#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluate.hpp"

namespace surefoot::evaluation {

/// For the terminal: one block for each estimate.
[[nodiscard]] std::string to_text(const std::vector<Evaluation>& evaluations);
/// A JSON array with every figure in full precision; keys carry units where they are not SI.
[[nodiscard]] std::string to_json(const std::vector<Evaluation>& evaluations);
/// One line for each estimate and error: estimate,error,unit,count,max,mean,...; RFC 4180.
[[nodiscard]] std::string to_csv(const std::vector<Evaluation>& evaluations);
/// A tabular (booktabs) of the absolute translation error [m]: max, mean, RMSE, std for each
/// estimate, with the smallest bold and the second underlined. An estimate that covers less of the
/// reference than `full_coverage` [0, 1] is marked with its coverage and takes no part in that.
[[nodiscard]] std::string to_latex(const std::vector<Evaluation>& evaluations,
                                   double full_coverage = 0.95);

}  // namespace surefoot::evaluation
