// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/ablation_figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "report/ratio_figure.hpp"

namespace surefoot::experiments {

namespace {

report::RatioRow row_of(const evaluation::AblationRow& row, const evaluation::Ablation& ablation) {
  report::RatioRow drawn{.group = row.change.contribution,
                         .label = row.change.change,
                         .remark = row.change.equations,
                         .median = row.median.value_or(std::numeric_limits<double>::infinity()),
                         .notable = !is_below_spread(row, ablation)};
  for (const std::optional<double>& ratio : row.ratios) {
    if (ratio) drawn.ratios.push_back(*ratio);
  }
  drawn.figures = {!row.median                  ? "\u2013"
                   : std::isfinite(*row.median) ? fmt::format("{:.2f}", *row.median)
                                                : "lost",
                   std::to_string(row.worse), std::to_string(row.better), std::to_string(row.lost)};
  return drawn;
}

}  // namespace

void draw_ablation(const evaluation::Ablation& ablation, const std::string& method,
                   const std::filesystem::path& folder) {
  report::RatioFigure figure{
      .title = fmt::format("{}: what each contribution is worth", method),
      .axis = fmt::format("APE over that of the method as it is, {} recordings",
                          ablation.recordings.size()),
      .figure_names = {"median", "2\u00d7 worse", "2\u00d7 better", "lost"},
      .spread = ablation.spread};
  for (const evaluation::AblationRow& row : ablation.rows) {
    figure.rows.push_back(row_of(row, ablation));
  }
  std::filesystem::create_directories(folder);
  for (const char* name : {"ablation.svg", "ablation.pdf", "ablation.png"}) {
    report::draw_ratio_figure(figure, folder / name);
  }
}

}  // namespace surefoot::experiments
