// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/evaluation_json.hpp"

#include <nlohmann/json.hpp>

#include "evaluation/option_names.hpp"
#include "evaluation/statistics_names.hpp"

namespace surefoot::evaluation {

namespace {

nlohmann::ordered_json json_of(const NamedStatistics& named) {
  nlohmann::ordered_json json = {{"unit", named.unit}, {"count", named.statistics.count}};
  for (const auto& [name, member] : kStatisticsNames) json[name] = named.statistics.*member;
  return json;
}

/// Of no stretch there is no error.
nlohmann::ordered_json json_of(const SegmentError& segment) {
  const auto error = [&](double mean) {
    return segment.count > 0 ? nlohmann::ordered_json(mean) : nlohmann::ordered_json();
  };
  return {{"length_m", segment.length},
          {"count", segment.count},
          {"translation_percent", error(segment.translation_percent)},
          {"rotation_deg_per_m", error(segment.rotation_deg_per_m)}};
}

}  // namespace

nlohmann::ordered_json json_of(const Evaluation& evaluation) {
  const Pose& pose = evaluation.alignment.pose;
  nlohmann::ordered_json json = {
      {"estimate", evaluation.name},
      {"poses", evaluation.poses},
      {"pairs", evaluation.pairs},
      {"coverage", evaluation.coverage},
      {"alignment",
       {{"translation_m", {pose.translation.x(), pose.translation.y(), pose.translation.z()}},
        {"rotation_xyzw",
         {pose.rotation.x(), pose.rotation.y(), pose.rotation.z(), pose.rotation.w()}},
        {"scale", evaluation.alignment.scale}}},
      {"errors", nlohmann::ordered_json::object()},
      {"segments", nlohmann::ordered_json::array()},
      {"segments_all", json_of(evaluation.segments.all)},
      {"end_drift",
       {{"path_length_m", evaluation.drift.path_length},
        {"total_m", evaluation.drift.total},
        {"horizontal_m", evaluation.drift.horizontal},
        {"vertical_m", evaluation.drift.vertical},
        {"percent", evaluation.drift.percent}}}};
  for (const auto* errors : {&evaluation.absolute, &evaluation.relative}) {
    for (const NamedStatistics& named : *errors) json["errors"][named.name] = json_of(named);
  }
  json["segments_all"].erase("length_m");
  for (const SegmentError& segment : evaluation.segments.by_length) {
    json["segments"].push_back(json_of(segment));
  }
  return json;
}

nlohmann::ordered_json json_of(const EvaluationOptions& options) {
  const AssociationOptions& pairing = options.association;
  const PairOptions& stretches = options.stretches;
  return {{"pair", name_of(kPairingNames, pairing.method)},
          {"max_diff_s", pairing.max_difference},
          {"max_gap_s", pairing.max_gap},
          {"offset_s", pairing.offset},
          {"align", name_of(kAlignmentNames, options.alignment)},
          {"align_poses", options.alignment_poses},
          {"delta", stretches.delta},
          {"delta_unit", name_of(kDeltaUnitNames, stretches.unit)},
          {"all_pairs", stretches.all_pairs},
          {"delta_tolerance", stretches.tolerance},
          {"pairs_from_reference", options.stretches_from_reference},
          {"segments_m", options.segment_lengths}};
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace surefoot::evaluation
