// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot/localizer.hpp over what the program itself localises with.
#include "mapping/map_localizer.hpp"
#include "mapping/map_on_disk.hpp"
#include "mapping/placed_scans.hpp"
#include "surefoot/localizer.hpp"

namespace surefoot {

struct Localizer::State {
  mapping::MapLocalizer localizer;
  mapping::PlacedScans placed;
  std::optional<Pose> T_world_lidar;  // of the last scan, where it was trusted

  void add(const Estimate& estimate, const mapping::ScanPoints& points) {
    T_world_lidar.reset();
    if (!estimate.trusted()) return;
    localizer.add(placed.next(estimate), points);
    T_world_lidar = estimate.T_world_lidar;
  }
};

Localizer::Localizer(const std::filesystem::path& map)
    : state_(new State{mapping::MapLocalizer(mapping::load_map(map), {}), {}, {}}) {}
Localizer::~Localizer() = default;
Localizer::Localizer(Localizer&&) noexcept = default;
Localizer& Localizer::operator=(Localizer&&) noexcept = default;

void Localizer::add(const Estimate& estimate, const DeskewedScan& scan) {
  state_->add(estimate, mapping::ready(scan));
}

void Localizer::add(const Estimate& estimate, const Odometry& odometry) {
  state_->add(estimate, [&]() -> const DeskewedScan& { return odometry.deskewed_scan(); });
}

std::optional<Pose> Localizer::T_map_lidar() const {
  const std::optional<Pose>& T_map_world = state_->localizer.T_map_world();
  if (!T_map_world || !state_->T_world_lidar) return std::nullopt;
  return *T_map_world * *state_->T_world_lidar;
}

std::optional<Pose> Localizer::T_map_world() const { return state_->localizer.T_map_world(); }

const std::string& Localizer::message() const { return state_->localizer.message(); }

}  // namespace surefoot
