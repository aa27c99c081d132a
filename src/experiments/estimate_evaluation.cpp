// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/estimate_evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "evaluation/ape.hpp"
#include "evaluation/marked_table.hpp"
#include "evaluation/option_names.hpp"
#include "experiments/compare_results.hpp"
#include "io/counted.hpp"
#include "io/decimal_time.hpp"
#include "io/file_writer.hpp"
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
                  [[maybe_unused]] const ComparedPaths& paths,
                  [[maybe_unused]] const std::vector<Evaluation>& evaluations) {
#ifdef SUREFOOT_HAS_PICTURES
  std::vector<std::string> names;
  for (const Evaluation& evaluation : evaluations) names.push_back(evaluation.name);
  for (const std::filesystem::path& file : request.figures) {
    draw_views(paths, names, file);
  }
#else
  if (!request.figures.empty()) {
    throw std::runtime_error("--figure: this program was built without pictures");
  }
#endif
}

constexpr const char* kPoseErrors =
    "estimate,stamp,translation_m,horizontal_m,vertical_m,rotation_deg,tilt_deg,yaw_deg";

/// A line for each pose that has a partner. `paths` are aligned. Of a reference without rotations
/// those errors are left empty; without stamps the poses are numbered.
std::string pose_errors_csv(const runs::ReferenceTrajectory& reference,
                            const std::vector<Evaluation>& evaluations,
                            const std::vector<Trajectory>& paths,
                            const evaluation::AssociationOptions& association) {
  std::string text = std::string(kPoseErrors) + '\n';
  const bool numbered = reference.format == runs::TrajectoryFormat::kitti;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const auto pairs = evaluation::associate(reference.truth.poses, paths[k], association);
    const auto lengths = absolute_errors(pairs, evaluation::Relation::translation);
    const auto angles = absolute_errors(pairs, evaluation::Relation::rotation_angle);
    const auto split = absolute_split_errors(pairs);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const StampedPose& pose = pairs.estimate[i];
      const double up = pose.pose.translation.z() - pairs.reference[i].pose.translation.z();
      text += fmt::format("{},{},{:.6f},{:.6f},{:.6f},", evaluation::csv_field(evaluations[k].name),
                          numbered ? std::to_string(i) : io::format_seconds(pose.stamp_ns),
                          lengths[i], split[i].horizontal, up);
      text += reference.truth.has_rotations
                  ? fmt::format("{:.6f},{:.6f},{:.6f}\n", angles[i], split[i].tilt, split[i].yaw)
                  : ",,\n";
    }
  }
  return text;
}

/// What is read is not written over, whatever else may be.
void keep_inputs(const EvaluationRequest& request) {
  std::vector<std::filesystem::path> outputs = request.figures;
  if (!request.pose_errors.empty()) outputs.push_back(request.pose_errors);
  std::vector<std::filesystem::path> inputs = request.estimates;
  inputs.push_back(request.reference.path);
  for (const std::filesystem::path& output : outputs) {
    for (const std::filesystem::path& input : inputs) {
      std::error_code ignored;
      if (std::filesystem::equivalent(output, runs::trajectory_file(input), ignored)) {
        throw std::runtime_error(output.string() + ": is what is evaluated; choose another name");
      }
    }
  }
}

/// Names that tell another format, and files of others, before all the work.
void check_files(const EvaluationRequest& request) {
  keep_inputs(request);
  const std::filesystem::path& table = request.pose_errors;
  if (!table.empty()) {
    io::require_ending(table, {".csv"});
    const auto status = std::filesystem::symlink_status(table);
    const bool is_there = std::filesystem::exists(status);
    if (is_there && !std::filesystem::is_regular_file(status)) {
      throw std::runtime_error(table.string() +
                               ": is there already and is no file; choose another name");
    }
    if (is_there && !request.overwrite && !io::is_file_beginning(table, kPoseErrors)) {
      throw std::runtime_error(
          table.string() +
          ": is there already and is no table of poses' errors; choose another "
          "name, or --overwrite");
    }
  }
#ifdef SUREFOOT_HAS_PICTURES
  for (const std::filesystem::path& file : request.figures) {
    (void)report::page_format_of(file);
    report::require_picture_or_nothing(file, report::PictureKind::figure, request.overwrite);
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

/// Options that somebody gave and that say nothing beside the others.
void tell_idle(const evaluation::EvaluationOptions& given, bool by_row,
               const EvaluationListener& listener) {
  using Method = evaluation::AssociationMethod;
  const evaluation::EvaluationOptions usual;
  const evaluation::AssociationOptions& pairs = given.association;
  const auto idle = [&](bool is_given, const char* flag, const char* why) {
    if (is_given) listener.note(std::string(flag) + " counts for nothing here: " + why);
  };
  const bool gives_gap = pairs.max_gap != usual.association.max_gap;
  const bool gives_difference = pairs.max_difference != usual.association.max_difference;
  if (by_row) {
    const char* const why = "KITTI's files, which have no stamps, are paired by row";
    idle(pairs.method != usual.association.method, "--pair", why);
    idle(gives_difference, "--max-diff", why);
    idle(gives_gap, "--max-gap", why);
    idle(pairs.offset != usual.association.offset, "--offset", why);
  } else {
    idle(gives_gap && pairs.method != Method::interpolate, "--max-gap",
         "it is for --pair interpolate");
    idle(gives_difference && pairs.method != Method::nearest, "--max-diff",
         "it is for --pair nearest");
  }
  const evaluation::PairOptions& stretches = given.stretches;
  idle(!stretches.all_pairs && stretches.tolerance != usual.stretches.tolerance,
       "--delta-tolerance", "it is for --all-pairs");
  idle(given.alignment_poses != 0 && given.alignment == evaluation::AlignmentMethod::none,
       "--align-poses", "nothing is aligned");
}

/// Of what is asked for and no estimate so short has.
void tell_left_out(const Evaluation& evaluation, const evaluation::EvaluationOptions& options,
                   const EvaluationListener& listener) {
  if (evaluation.relative.empty()) {
    const evaluation::PairOptions& stretches = options.stretches;
    listener.note(fmt::format("{}: has no stretch of {:g} {}, so there is no relative error",
                              evaluation.name, stretches.delta,
                              evaluation::name_of(evaluation::kDeltaUnitNames, stretches.unit)));
  }
  if (options.segment_lengths.empty()) return;
  for (const evaluation::SegmentError& segment : evaluation.segments.by_length) {
    if (segment.count > 0) continue;
    listener.note(fmt::format("{}: has no segment of {:g} m, so there is no error of these",
                              evaluation.name, segment.length));
  }
}

void tell_open_turn(const std::string& name, const runs::ReferenceTrajectory& reference,
                    const Trajectory& estimate, const evaluation::EvaluationOptions& options,
                    const EvaluationListener& listener) {
  if (options.positions_only) return;
  const auto pairs = evaluation::associate(reference.truth.poses, estimate, options.association);
  if (!evaluation::leaves_turn_open(pairs, options.alignment, options.alignment_poses)) return;
  listener.note(name +
                ": a stay, a nearly straight way or one no wider than its errors; the positions "
                "hardly decide a turn, so that rotation errors may be anything; --align poses "
                "takes the rotations, too");
}

/// What one should know of an estimate before believing its figures.
void tell_of(const std::filesystem::path& file, const std::string& name, const Trajectory& estimate,
             const EvaluationListener& listener) {
  if (const std::string text = runs::unfinished_text(file); !text.empty()) {
    listener.note(name + ": " + text);
  }
  if (const std::size_t segments = runs::segments_of(file); segments > 1) {
    listener.note(name + ": " + std::to_string(segments) +
                  " segments, each in a frame of its own, are laid on the reference as one");
  }
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < estimate.size(); ++i) {
    if (estimate[i].stamp_ns == estimate[i - 1].stamp_ns) ++repeated;
  }
  if (repeated == 0) return;
  listener.note(fmt::format("{}: {} {} the stamp of the one before", name,
                            io::counted(repeated, "pose"), repeated == 1 ? "has" : "have"));
}

}  // namespace

std::vector<Evaluation> evaluate_estimates(const EvaluationRequest& request,
                                           const EvaluationListener& listener) {
  check_files(request);
  const runs::ReferenceTrajectory reference = runs::read_reference(request.reference);
  if (reference.is_foreign) {
    listener.note(reference.file.string() + ": " + reference.truth.what);
  }
  if (!request.reference.topic.empty() && !io::is_bag_input(reference.file, {})) {
    listener.note("--truth-topic counts for nothing here: " + reference.file.string() +
                  " is no bag");
  }
  const auto is_bag = [](const std::filesystem::path& estimate) {
    return io::is_bag_input(runs::trajectory_file(estimate), {});
  };
  if (!request.estimate_topic.empty() &&
      std::none_of(request.estimates.begin(), request.estimates.end(), is_bag)) {
    listener.note("--topic counts for nothing here: no estimate is a bag");
  }
  evaluation::EvaluationOptions options = request.evaluation;
  tell_idle(options, reference.format == runs::TrajectoryFormat::kitti, listener);
  adapt(options, reference);
  const std::vector<std::string> names = runs::estimate_names(request.estimates);
  std::vector<Evaluation> evaluations;
  ComparedPaths paths{.truth = reference.truth.poses, .estimates = {}, .begins = {}};
  for (std::size_t i = 0; i < request.estimates.size(); ++i) {
    try {
      const Trajectory estimate =
          runs::read_estimate(request.estimates[i], reference, request.estimate_topic);
      const bool by_row = options.association.method == evaluation::AssociationMethod::index;
      tell_of(request.estimates[i], names[i], by_row ? Trajectory{} : estimate, listener);
      evaluations.push_back(
          evaluation::evaluate(names[i], reference.truth.poses, estimate, options));
      tell_left_out(evaluations.back(), options, listener);
      tell_open_turn(names[i], reference, estimate, options, listener);
      paths.estimates.push_back(evaluation::aligned(estimate, evaluations.back().alignment));
      paths.begins.push_back(runs::segment_begins(request.estimates[i]));
    } catch (const std::exception& error) {
      listener.complain(names[i] + ": " + error.what());
    }
  }
  if (!evaluations.empty() && !request.pose_errors.empty()) {
    io::write_whole_file(
        request.pose_errors,
        pose_errors_csv(reference, evaluations, paths.estimates, options.association));
  }
  if (!evaluations.empty()) draw_figures(request, paths, evaluations);
  return evaluations;
}

}  // namespace surefoot::experiments
