// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/ablation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace surefoot::evaluation {

namespace {

constexpr double kLost = std::numeric_limits<double>::infinity();
constexpr double kFactor = 2.0;  // beyond which a recording counts as worse or better

// Dozens of changes are looked at: at 95 % one or two of them would differ by chance.
constexpr double kConfidence = 0.99;
constexpr int kDraws = 10'000;

/// The middle one; of an even count the geometric mean of the two in the middle.
double geometric_median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double low = values[(values.size() - 1) / 2], high = values[values.size() / 2];
  return low == high ? low : std::sqrt(low * high);
}

AblationRow make_row(const Comparison& comparison, const AblationChange& change,
                     std::size_t method) {
  AblationRow row{.change = change};
  for (const ComparedRecording& recording : comparison.recordings) {
    const MethodResult& result = recording.results[method];
    const bool whole = result.verdict.outcome == Outcome::whole && result.evaluation.has_value();
    row.errors.push_back(whole ? result.evaluation->absolute.front().statistics.rmse : kLost);
    row.outcomes.push_back(whole ? "" : result.verdict.text);
  }
  return row;
}

/// Of a recording, over the references; `left_out` is none of them, or one.
double usual_error(const Ablation& ablation, std::size_t recording, std::size_t left_out) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < ablation.references; ++i) {
    if (i != left_out) errors.push_back(ablation.rows[i].errors[recording]);
  }
  if (errors.empty()) return ablation.rows[left_out].errors[recording];  // it is the only one
  return geometric_median(std::move(errors));
}

void add_ratios(const Ablation& ablation, std::size_t index, AblationRow& row) {
  std::vector<double> ratios;
  for (std::size_t r = 0; r < row.errors.size(); ++r) {
    const double usual = usual_error(ablation, r, index);
    row.lost += row.errors[r] == kLost ? 1 : 0;
    row.ratios.emplace_back();
    if (usual == kLost || usual <= 0.0) continue;
    const double ratio = row.errors[r] / usual;
    row.ratios.back() = ratio;
    ratios.push_back(ratio);
    row.worse += ratio > kFactor && ratio != kLost ? 1 : 0;
    row.better += ratio < 1.0 / kFactor ? 1 : 0;
  }
  if (ratios.empty()) return;
  row.low = *std::min_element(ratios.begin(), ratios.end());
  row.high = *std::max_element(ratios.begin(), ratios.end());
  row.median = geometric_median(std::move(ratios));
}

/// The factor within which a median ratio lies with the confidence of kConfidence, if chance alone
/// decides which reference a recording's ratio is of. Drawn, always in the same way.
double spread_of_medians(const Ablation& ablation) {
  std::vector<std::vector<double>> chances;  // by recording: the references' ratios
  for (std::size_t r = 0; r < ablation.recordings.size(); ++r) {
    std::vector<double> ratios;
    for (std::size_t m = 0; m < ablation.references; ++m) {
      const std::optional<double>& ratio = ablation.rows[m].ratios[r];
      if (ratio) ratios.push_back(*ratio);
    }
    if (!ratios.empty()) chances.push_back(std::move(ratios));
  }
  if (chances.empty()) return 1.0;
  std::mt19937_64 random(1);
  std::vector<double> factors;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<double> drawn;
    for (const auto& ratios : chances) drawn.push_back(ratios[random() % ratios.size()]);
    const double median = geometric_median(std::move(drawn));
    factors.push_back(std::max(median, 1.0 / median));
  }
  std::sort(factors.begin(), factors.end());
  return factors[static_cast<std::size_t>(kConfidence * kDraws)];
}

}  // namespace

Ablation ablate(const Comparison& comparison, const std::vector<AblationChange>& changes,
                std::size_t references) {
  if (references == 0 || references > changes.size() ||
      changes.size() != comparison.methods.size()) {
    throw std::invalid_argument("an ablation needs a reference, and a change for each method");
  }
  Ablation ablation{.references = references};
  for (std::size_t m = 0; m < changes.size(); ++m) {
    ablation.rows.push_back(make_row(comparison, changes[m], m));
  }
  for (std::size_t m = 0; m < changes.size(); ++m) add_ratios(ablation, m, ablation.rows[m]);
  for (std::size_t r = 0; r < comparison.recordings.size(); ++r) {
    ablation.recordings.push_back(comparison.recordings[r].name);
    ablation.usual.push_back(usual_error(ablation, r, references));
  }
  ablation.spread = spread_of_medians(ablation);
  return ablation;
}

bool is_below_spread(const AblationRow& row, const Ablation& ablation) {
  return !row.median || std::max(*row.median, 1.0 / *row.median) <= ablation.spread;
}

}  // namespace surefoot::evaluation
