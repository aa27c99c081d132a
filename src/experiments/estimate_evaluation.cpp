// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/estimate_evaluation.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "evaluation/option_names.hpp"
#include "io/recording.hpp"
#include "runs/run_folder.hpp"

#ifdef SUREFOOT_HAS_PICTURES
#include "experiments/compare_figures.hpp"
#include "report/canvas.hpp"
#include "report/picture_mark.hpp"
#endif

namespace surefoot::experiments {
namespace {

using evaluation::Evaluation;

void draw_figures([[maybe_unused]] const EvaluationRequest& request,
                  [[maybe_unused]] const Trajectory& reference,
                  [[maybe_unused]] const std::vector<Evaluation>& evaluations,
                  [[maybe_unused]] const std::vector<Trajectory>& paths) {
#ifdef SUREFOOT_HAS_PICTURES
  std::vector<std::string> names;
  for (const Evaluation& evaluation : evaluations) names.push_back(evaluation.name);
  for (const std::filesystem::path& file : request.figures) {
    draw_views(reference, names, paths, file);
  }
#else
  if (!request.figures.empty()) {
    throw std::runtime_error("--figure: this program was built without pictures");
  }
#endif
}

/// Names that tell no format, and files of others, before all the work.
void check_figures([[maybe_unused]] const EvaluationRequest& request) {
#ifdef SUREFOOT_HAS_PICTURES
  for (const std::filesystem::path& file : request.figures) {
    (void)report::page_format_of(file);
    report::require_picture_or_nothing(file, request.overwrite);
  }
#endif
}

/// What the reference does not have is not asked of it.
void adapt(evaluation::EvaluationOptions& options, const runs::ReferenceTrajectory& reference) {
  options.positions_only = !reference.truth.has_rotations;
  if (reference.format != runs::TrajectoryFormat::kitti) return;
  options.association.method = evaluation::AssociationMethod::index;
  if (options.stretches.unit == evaluation::DeltaUnit::seconds) {
    throw std::runtime_error("--delta-unit s needs stamps, which KITTI's files do not have");
  }
}

/// Of what is asked for and no estimate so short has; empty: there is all of it.
std::string left_out_text(const Evaluation& evaluation, const evaluation::PairOptions& stretches) {
  if (!evaluation.relative.empty()) return {};
  return fmt::format("{}: has no stretch of {:g} {}, so there is no relative error",
                     evaluation.name, stretches.delta,
                     evaluation::name_of(evaluation::kDeltaUnitNames, stretches.unit));
}

}  // namespace

std::vector<Evaluation> evaluate_estimates(const EvaluationRequest& request,
                                           const EvaluationListener& listener) {
  check_figures(request);
  const runs::ReferenceTrajectory reference = runs::read_reference(request.reference);
  if (reference.is_foreign) {
    listener.note(reference.file.string() + ": " + reference.truth.what);
  }
  if (!request.reference.topic.empty() && !io::is_bag_input(reference.file, {})) {
    listener.note("--truth-topic counts for nothing here: " + reference.file.string() +
                  " is no bag");
  }
  evaluation::EvaluationOptions options = request.evaluation;
  adapt(options, reference);
  const std::vector<std::string> names = runs::estimate_names(request.estimates);
  std::vector<Evaluation> evaluations;
  std::vector<Trajectory> paths;  // aligned
  for (std::size_t i = 0; i < request.estimates.size(); ++i) {
    try {
      const Trajectory estimate =
          runs::read_estimate(request.estimates[i], reference, request.estimate_topic);
      if (const std::string text = runs::unfinished_text(request.estimates[i]); !text.empty()) {
        listener.note(names[i] + ": " + text);
      }
      if (const std::size_t segments = runs::segments_of(request.estimates[i]); segments > 1) {
        listener.note(names[i] + ": " + std::to_string(segments) +
                      " segments, each in a frame of its own, are laid on the reference as one");
      }
      evaluations.push_back(
          evaluation::evaluate(names[i], reference.truth.poses, estimate, options));
      if (const std::string text = left_out_text(evaluations.back(), options.stretches);
          !text.empty()) {
        listener.note(text);
      }
      paths.push_back(evaluation::aligned(estimate, evaluations.back().alignment));
    } catch (const std::exception& error) {
      listener.complain(names[i] + ": " + error.what());
    }
  }
  if (!evaluations.empty()) draw_figures(request, reference.truth.poses, evaluations, paths);
  return evaluations;
}

}  // namespace surefoot::experiments
