// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/compare_figures.hpp"

#include "evaluation/ape.hpp"
#include "report/series_figure.hpp"
#include "report/trajectory_figure.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::experiments {

using report::FigurePanel;
using report::FigureView;
using report::TrajectoryFigure;

namespace {

constexpr const char* kExtensions[] = {".svg", ".pdf", ".png"};

std::vector<std::string> remarks_of(const evaluation::Comparison& comparison,
                                    const evaluation::ComparedRecording& recording) {
  std::vector<std::string> remarks;
  for (std::size_t m = 0; m < recording.results.size(); ++m) {
    const std::string& text = recording.results[m].verdict.text;
    if (!text.empty()) remarks.push_back(comparison.methods[m].label + ": " + text);
  }
  return remarks;
}

TrajectoryFigure figure_of(const CompareResults& results, FigureView view) {
  TrajectoryFigure figure;
  for (const auto& method : results.comparison.methods) figure.names.push_back(method.label);
  for (std::size_t r = 0; r < results.paths.size(); ++r) {
    const evaluation::ComparedRecording& recording = results.comparison.recordings[r];
    const ComparedPaths& paths = results.paths[r];
    if (paths.truth.empty()) continue;
    std::vector<bool> cut;
    for (const evaluation::MethodResult& result : recording.results) {
      cut.push_back(result.verdict.outcome == evaluation::Outcome::diverged);
    }
    figure.panels.push_back({view, recording.name, paths.truth, paths.estimates, cut,
                             remarks_of(results.comparison, recording), paths.begins});
  }
  return figure;
}

/// Of the poses that have a partner those with which another segment begins.
std::vector<std::size_t> begins_among(const Trajectory& paired, const Trajectory& estimate,
                                      const std::vector<std::size_t>& begins) {
  std::vector<std::size_t> result;
  auto next = begins.begin();
  for (std::size_t i = 0; i < paired.size(); ++i) {
    const auto first = next;
    while (next != begins.end() && estimate[*next].stamp_ns <= paired[i].stamp_ns) ++next;
    if (next != first) result.push_back(i);
  }
  return result;
}

/// Position errors of an aligned estimate; empty where no pose has a partner.
report::TimeSeries errors_of(const Trajectory& truth, const Trajectory& estimate,
                             const std::vector<std::size_t>& begins,
                             const evaluation::AssociationOptions& options) {
  report::TimeSeries series;
  if (truth.empty() || estimate.empty()) return series;
  try {
    const evaluation::AssociatedTrajectories pairs =
        evaluation::associate(truth, estimate, options);
    series.values = absolute_errors(pairs, evaluation::Relation::translation);
    for (const StampedPose& pose : pairs.reference) {
      series.times.push_back(seconds(pose.stamp_ns - truth.front().stamp_ns));
    }
    series.begins = begins_among(pairs.estimate, estimate, begins);
  } catch (const std::exception&) {
    return {};  // which the comparison has told already
  }
  return series;
}

report::SeriesFigure error_figure_of(const CompareResults& results) {
  report::SeriesFigure figure{.quantity = "position error [m]"};
  for (const auto& method : results.comparison.methods) figure.names.push_back(method.label);
  for (std::size_t r = 0; r < results.paths.size(); ++r) {
    const evaluation::ComparedRecording& recording = results.comparison.recordings[r];
    const ComparedPaths& paths = results.paths[r];
    if (paths.truth.empty()) continue;
    report::SeriesPanel panel{.title = recording.name,
                              .remarks = remarks_of(results.comparison, recording)};
    for (std::size_t m = 0; m < paths.estimates.size(); ++m) {
      panel.curves.push_back(errors_of(paths.truth, paths.estimates[m], paths.begins[m],
                                       results.comparison.options.association));
    }
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

}  // namespace

void draw_comparison(const CompareResults& results, const std::filesystem::path& folder) {
  const std::pair<const char*, FigureView> views[] = {{"trajectories_3d", FigureView::space},
                                                      {"trajectories_side", FigureView::side},
                                                      {"trajectories_top", FigureView::top}};
  for (const auto& [name, view] : views) {
    const TrajectoryFigure figure = figure_of(results, view);
    if (figure.panels.empty()) return;
    std::filesystem::create_directories(folder);
    for (const char* extension : kExtensions) {
      report::draw_trajectory_figure(figure, folder / (std::string(name) + extension));
    }
  }
  const report::SeriesFigure errors = error_figure_of(results);
  for (const char* extension : kExtensions) {
    report::draw_series_figure(errors, folder / (std::string("errors_over_time") + extension));
  }
}

void draw_views(const ComparedPaths& paths, const std::vector<std::string>& names,
                const std::filesystem::path& file) {
  TrajectoryFigure figure{names, {}};
  const std::pair<const char*, FigureView> views[] = {{"Trajectories", FigureView::space},
                                                      {"Side view", FigureView::side},
                                                      {"Top view", FigureView::top}};
  for (const auto& [name, view] : views) {
    figure.panels.push_back({view, name, paths.truth, paths.estimates, {}, {}, paths.begins});
  }
  report::draw_trajectory_figure(figure, file);
}

}  // namespace surefoot::experiments
