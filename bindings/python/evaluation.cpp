// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Errors as `surefoot eval` gives them.
#include <pybind11/stl.h>

#include <stdexcept>

#include "arrays.hpp"
#include "bindings.hpp"
#include "evaluation/ape.hpp"
#include "evaluation/evaluate.hpp"
#include "evaluation/option_names.hpp"
#include "evaluation/tables.hpp"
#include "poses.hpp"
#include "words.hpp"

namespace surefoot::python {

namespace {

using evaluation::AssociatedTrajectories;
using evaluation::EvaluationOptions;
using evaluation::Relation;
using evaluation::Statistics;

constexpr std::array<std::pair<std::string_view, Relation>, 4> kRelations = {
    {{"translation", Relation::translation},
     {"rotation_angle", Relation::rotation_angle},
     {"rotation_part", Relation::rotation_part},
     {"full", Relation::full}}};

/// Statistics with what they are of.
struct Errors {
  Statistics statistics;
  std::vector<double> errors;
  std::string unit;
  std::vector<std::int64_t> stamps_ns;
  evaluation::TrajectoryAlignment alignment;
};

/// What is compared, in copies: while the interpreter's lock is released, as it is for as long as
/// these live, another thread may add to the originals.
struct Compared {
  Compared(const NamedTrajectory& reference_given, const NamedTrajectory& estimate_given)
      : reference(reference_given.poses), estimate(estimate_given.poses) {}

  Trajectory reference, estimate;
  py::gil_scoped_release release;
};

AssociatedTrajectories pairs_of(const Compared& compared, const std::string& pair, double max_diff,
                                double max_gap, double offset) {
  evaluation::AssociationOptions options;
  options.method = choice_of(evaluation::kPairingNames, "pair", pair);
  options.max_difference = max_diff;
  options.max_gap = max_gap;
  options.offset = offset;
  return associate(compared.reference, compared.estimate, options);
}

Errors ape(const NamedTrajectory& reference, const NamedTrajectory& estimate,
           const std::string& align, const std::string& relation, const std::string& pair,
           double max_diff, double max_gap, double offset, std::size_t align_poses) {
  const Compared compared(reference, estimate);
  AssociatedTrajectories pairs = pairs_of(compared, pair, max_diff, max_gap, offset);
  Errors result;
  result.alignment =
      find_alignment(pairs, choice_of(evaluation::kAlignmentNames, "align", align), align_poses);
  pairs.estimate = aligned(pairs.estimate, result.alignment);
  const Relation chosen = choice_of(kRelations, "relation", relation);
  result.errors = absolute_errors(pairs, chosen);
  result.unit = unit_of(chosen);
  result.statistics = evaluation::statistics_of(result.errors);
  for (const StampedPose& pose : pairs.estimate) result.stamps_ns.push_back(pose.stamp_ns);
  return result;
}

Errors rpe(const NamedTrajectory& reference, const NamedTrajectory& estimate, double delta,
           const std::string& delta_unit, const std::string& relation, bool all_pairs,
           double tolerance, bool pairs_from_reference, const std::string& pair, double max_diff,
           double max_gap, double offset) {
  const Compared compared(reference, estimate);
  const AssociatedTrajectories pairs = pairs_of(compared, pair, max_diff, max_gap, offset);
  const evaluation::PairOptions stretches{
      delta, choice_of(evaluation::kDeltaUnitNames, "delta_unit", delta_unit), all_pairs,
      tolerance};
  const auto found = find_pairs(pairs_from_reference ? pairs.reference : pairs.estimate, stretches);
  if (found.empty()) {
    throw std::invalid_argument("delta: no stretch of " + std::to_string(delta) + " " + delta_unit +
                                " among " + std::to_string(pairs.estimate.size()) + " poses");
  }
  const Relation chosen = choice_of(kRelations, "relation", relation);
  Errors result;
  result.errors = relative_errors(pairs, found, chosen);
  result.unit = unit_of(chosen);
  result.statistics = evaluation::statistics_of(result.errors);
  for (const auto& stretch : found) {
    result.stamps_ns.push_back(pairs.estimate[stretch.to].stamp_ns);
  }
  return result;
}

py::object evaluate(const NamedTrajectory& reference, const NamedTrajectory& estimate,
                    const std::string& align, double delta, const std::string& delta_unit,
                    bool all_pairs) {
  EvaluationOptions options;
  options.alignment = choice_of(evaluation::kAlignmentNames, "align", align);
  options.stretches.delta = delta;
  options.stretches.unit = choice_of(evaluation::kDeltaUnitNames, "delta_unit", delta_unit);
  options.stretches.all_pairs = all_pairs;
  std::string text;
  {
    const Compared compared(reference, estimate);
    text = evaluation::to_json(
        {evaluation::evaluate("estimate", compared.reference, compared.estimate, options)});
  }
  const py::object list = py::module_::import("json").attr("loads")(text);
  return list[py::int_(0)];
}

void bind_errors_class(py::module_& module) {
  const auto statistic = [](double Statistics::*part) {
    return [part](const Errors& self) { return self.statistics.*part; };
  };
  py::class_<Errors>(module, "Errors", "Errors of a kind with their statistics, in their unit.")
      .def_property_readonly(
          "errors", [](const Errors& self) { return array_of(self.errors); },
          "(N,) float64, one a pair or stretch.")
      .def_property_readonly(
          "stamps_ns", [](const Errors& self) { return array_of(self.stamps_ns); },
          "(N,) int64 [ns], of the estimate's pose (the stretch's last).")
      .def_readonly("unit", &Errors::unit, "'m', 'deg' or '' for a norm.")
      .def_property_readonly("rmse", statistic(&Statistics::rmse))
      .def_property_readonly("mean", statistic(&Statistics::mean))
      .def_property_readonly("median", statistic(&Statistics::median))
      .def_property_readonly("std", statistic(&Statistics::std))
      .def_property_readonly("min", statistic(&Statistics::min))
      .def_property_readonly("max", statistic(&Statistics::max))
      .def_property_readonly("sse", statistic(&Statistics::sse))
      .def_property_readonly(
          "T_reference_estimate", [](const Errors& self) { return matrix_of(self.alignment.pose); },
          "(4, 4) the alignment of the estimate to the reference [m].")
      .def_property_readonly("scale", [](const Errors& self) { return self.alignment.scale; })
      .def("__len__", [](const Errors& self) { return self.errors.size(); })
      .def("__repr__", [](const Errors& self) {
        return "<Errors: rmse " + std::to_string(self.statistics.rmse) + " " + self.unit +
               " over " + std::to_string(self.errors.size()) + ">";
      });
}

}  // namespace

void bind_evaluation(py::module_& module) {
  bind_errors_class(module);
  module.def("ape", &ape, py::arg("reference"), py::arg("estimate"), py::kw_only(),
             py::arg("align") = "se3", py::arg("relation") = "translation",
             py::arg("pair") = "nearest", py::arg("max_diff") = 0.01, py::arg("max_gap") = 0.5,
             py::arg("offset") = 0.0, py::arg("align_poses") = 0,
             R"(Absolute pose error, as evo defines it.

align: none, origin, yaw, se3, poses, sim3 or scale, from the first align_poses pairs (0: all)
relation: translation [m], rotation_angle [deg], rotation_part or full (norms)
pair: nearest (within max_diff [s]) or interpolate (the reference, over gaps of max_gap [s])
offset: added to the estimate's stamps [s])");
  module.def("rpe", &rpe, py::arg("reference"), py::arg("estimate"), py::kw_only(),
             py::arg("delta") = 1.0, py::arg("delta_unit") = "frames",
             py::arg("relation") = "translation", py::arg("all_pairs") = false,
             py::arg("tolerance") = 0.1, py::arg("pairs_from_reference") = false,
             py::arg("pair") = "nearest", py::arg("max_diff") = 0.01, py::arg("max_gap") = 0.5,
             py::arg("offset") = 0.0,
             R"(Relative pose error over stretches of length delta, as evo defines it.

delta_unit: frames, m, s or deg
all_pairs: a stretch from every pose, its length within the share `tolerance` of delta
pairs_from_reference: stretches are measured along the reference, not the estimate
The others as of ape().)");
  module.def("evaluate", &evaluate, py::arg("reference"), py::arg("estimate"), py::kw_only(),
             py::arg("align") = "se3", py::arg("delta") = 1.0, py::arg("delta_unit") = "frames",
             py::arg("all_pairs") = false,
             "All figures at once, as the dict that `surefoot eval --json` prints.");
}

}  // namespace surefoot::python
