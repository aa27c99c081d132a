// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "recordings/recording_maker.hpp"

namespace surefoot::recordings {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json json_of(const simulation::Scene& scene) {
  Json route = Json::array();
  for (const Eigen::Vector3d& corner : scene.route) route.push_back(json_of(corner));
  return {{"name", scene.name},
          {"description", scene.description},
          {"triangles", scene.mesh.triangles.size()},
          {"moving_objects", scene.moving.size()},
          {"corner_rounding_m", scene.corner_rounding},
          {"route_m", route}};
}

Json json_of(const simulation::GaitModel& gait) {
  const std::array<const char*, simulation::kBodyAxes> names = {"surge_m",  "sway_m",    "bounce_m",
                                                                "roll_rad", "pitch_rad", "yaw_rad"};
  Json harmonics;
  for (std::size_t axis = 0; axis < names.size(); ++axis) {
    Json list = Json::array();
    for (const simulation::Harmonic& harmonic : gait.harmonics[axis]) {
      list.push_back({{"order", harmonic.order},
                      {"amplitude", harmonic.amplitude},
                      {"phase_rad", harmonic.phase}});
    }
    harmonics[names[axis]] = list;
  }
  return {{"name", gait.name},
          {"speed_m_s", gait.speed},
          {"stride_hz", gait.stride_frequency},
          {"body_height_m", gait.body_height},
          {"harmonics", harmonics},
          {"footfall_phases", gait.footfalls},
          {"impact_bounce_m", gait.impact_bounce},
          {"impact_tilt_rad", gait.impact_tilt},
          {"impact_hz", {gait.impact_low_hz, gait.impact_high_hz}},
          {"stride_variation", gait.stride_variation},
          {"amplitude_variation", gait.amplitude_variation},
          {"wander_tilt_rad", gait.wander_tilt},
          {"wander_position_m", gait.wander_position},
          {"wander_step_s", gait.wander_step},
          {"speed_variation", gait.speed_variation},
          {"stumbles_per_minute", gait.stumbles_per_minute},
          {"stumble_tilt_rad", gait.stumble_tilt},
          {"stumble_drop_m", gait.stumble_drop},
          {"pauses_per_minute", gait.pauses_per_minute}};
}

Json json_of(const simulation::LidarModel& lidar) {
  Json lasers = Json::array();
  for (const simulation::Laser& laser : lidar.lasers) {
    lasers.push_back({{"offset_ns", laser.offset_ns},
                      {"elevation_rad", laser.elevation},
                      {"azimuth_offset_rad", laser.azimuth_offset},
                      {"vertical_origin_m", laser.vertical_origin},
                      {"ring", laser.ring}});
  }
  return {{"name", lidar.name},
          {"sequence_ns", lidar.sequence_ns},
          {"turn_ns", lidar.turn_ns},
          {"azimuth_unit_rad", lidar.azimuth_unit},
          {"sequences_per_azimuth", lidar.sequences_per_azimuth},
          {"radial_origin_m", lidar.radial_origin},
          {"range_m", {lidar.min_range, lidar.max_range}},
          {"half_detection_range_m", lidar.half_detection_range},
          {"range_sigma_m", lidar.range_sigma},
          {"range_unit_m", lidar.range_unit},
          {"divergence_rad", {lidar.divergence_horizontal, lidar.divergence_vertical}},
          {"pulse_length_m", lidar.pulse_length},
          {"lasers_in_firing_order", lasers}};
}

}  // namespace

std::string scene_json(const RecordingRequest& request, const simulation::Scene& scene,
                       const simulation::GaitModel& gait, const simulation::LidarModel& lidar,
                       const simulation::ScannerOptions& options, std::uint64_t scans) {
  const Json document = {
      {"surefoot", SUREFOOT_VERSION},
      {"seed", request.seed},
      {"layout", request.layout.value_or(request.seed)},
      {"scans", scans},
      {"start_ns", options.start_ns},
      {"truth", "gt.tum: T_map_lidar every 2.5 ms and at the start, middle and end of every scan"},
      {"gait_scale", request.gait_scale},
      {"mount",
       {{"offset_m", json_of(request.mount_offset)},
        {"roll_pitch_yaw_deg", json_of(request.mount_tilt_deg)}}},
      {"rays_per_beam", simulation::footprint_rays(options.footprint).size()},
      {"dual_return", options.dual_return},
      {"robot_body_in_view", options.robot_body},
      {"rain", options.air.rain},
      {"dust", options.air.dust},
      {"people", request.people},
      {"route_given", !request.route_file.empty()},
      {"scene", json_of(scene)},
      {"robot", json_of(gait)},
      {"lidar", json_of(lidar)}};
  // A file's name may hold any byte.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace surefoot::recordings
