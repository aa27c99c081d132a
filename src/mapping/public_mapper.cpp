// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot/mapper.hpp over what the program itself maps with.
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mapping/finished_walk.hpp"
#include "mapping/map_on_disk.hpp"
#include "mapping/placed_scans.hpp"
#include "mapping/walk_mapper.hpp"
#include "surefoot/mapper.hpp"

namespace surefoot {

struct Mapper::State {
  mapping::WalkMapper mapper{mapping::MapperOptions{}};
  mapping::PlacedScans placed;
  Trajectory measured;  // T_world_lidar
  mapping::WalkClock clock;
  std::optional<mapping::FinishedWalk> finished;

  [[nodiscard]] const mapping::FinishedWalk& walk() const {
    if (!finished) throw std::logic_error("Mapper: expected finish() before this");
    return *finished;
  }
};

Mapper::Mapper() : state_(std::make_unique<State>()) {}
Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

void Mapper::add(const Estimate& estimate, const DeskewedScan& scan) {
  if (state_->finished) throw std::logic_error("Mapper: add() after finish()");
  if (!estimate.trusted()) return;
  state_->mapper.add(state_->placed.next(estimate), scan);
  (void)state_->clock.next(estimate.stamp_ns);
  state_->measured.push_back({estimate.stamp_ns, estimate.T_world_lidar});
}

void Mapper::finish() {
  if (state_->finished) throw std::logic_error("Mapper: finish() was called before");
  state_->mapper.finish();
  state_->finished.emplace(state_->mapper);
  state_->finished->drop_moved();
}

JoinReport Mapper::join(const std::filesystem::path& map) {
  (void)state_->walk();
  const mapping::MapJoin join = state_->finished->join(mapping::load_map(map));
  return {join.joint.has_value(), join.loops.size(), join.taken, join.message};
}

Trajectory Mapper::trajectory() const {
  Trajectory all;
  for (const mapping::FramePoses& part : state_->walk().corrected(state_->measured)) {
    all.insert(all.end(), part.poses.begin(), part.poses.end());
  }
  return all;
}

std::optional<Pose> Mapper::T_map_world(std::int64_t stamp_ns) const {
  return state_->walk().correction(state_->clock.at(stamp_ns));
}

std::size_t Mapper::loops() const {
  (void)state_->walk();
  return state_->mapper.taken();
}

std::size_t Mapper::compared() const {
  (void)state_->walk();
  return state_->mapper.loops().size();
}

void Mapper::save(const std::filesystem::path& file) const {
  mapping::store_map(file, state_->walk().map());
}

}  // namespace surefoot
