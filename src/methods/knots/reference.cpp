// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "surefoot/reference.hpp"

#include <map>
#include <utility>
#include <vector>

#include "methods/knots/known_front_end.hpp"
#include "methods/knots/whole_way.hpp"

namespace surefoot {

namespace {

constexpr int kPasses = 3;

const Config& checked(const Config& config) {
  if (config.method == "surefoot") return config;
  throw ConfigError("method: " + config.method + ": a reference is made by surefoot alone");
}

}  // namespace

struct Reference::State {
  State(const Config& config, int threads)
      : session{checked(config), Workers(threads)},
        odometry(config, threads),
        choice(map_choice(config.knots)) {}

  void keep(const Scan& scan, Estimate estimate);
  [[nodiscard]] std::vector<Estimate> answers() const;

  Session session;
  Odometry odometry;
  PointChoice choice;
  std::map<int, WholeWay> ways;  // by segment
  std::vector<int> unrefined;
  struct Added {
    Estimate estimate;
    std::optional<std::size_t> scan;  // of its segment's way
  };
  std::vector<Added> added;  // that were not rejected
};

Reference::Reference(const Config& config, int threads)
    : state_(std::make_unique<State>(config, threads)) {}
Reference::~Reference() = default;
Reference::Reference(Reference&&) noexcept = default;
Reference& Reference::operator=(Reference&&) noexcept = default;

Estimate Reference::add_scan(const Scan& scan) {
  Estimate estimate = state_->odometry.add_scan(scan);
  if (estimate.status != Status::rejected) state_->keep(scan, estimate);
  return estimate;
}

/// By the time that goes on where the scans' clock was set back, as replay()'s odometry asks.
void Reference::State::keep(const Scan& scan, Estimate estimate) {
  const std::int64_t ahead_ns = odometry.ahead_ns();
  estimate.trajectory = estimate.trajectory.delayed(ahead_ns);
  Added& now = added.emplace_back(Added{estimate, {}});
  if (!estimate.trusted()) return;
  const PreparedScan whole = preprocess(scan, session.config.preprocess);
  PreparedScan kept;
  kept.start_ns = whole.start_ns + ahead_ns;
  kept.end_ns = whole.end_ns + ahead_ns;
  for (const std::uint32_t i : choice.choose(whole, session.workers)) {
    kept.points.push_back(whole.points[i]);
    if (!whole.taus.empty()) kept.taus.push_back(whole.taus[i]);
  }
  WholeWay& way = ways.try_emplace(estimate.segment, session).first->second;
  if (way.add(std::move(kept), estimate)) now.scan = way.size() - 1;
}

bool Reference::refine(const std::function<bool(double)>& goes_on) {
  const double all = static_cast<double>(state_->ways.size()) * kPasses;
  int done = 0;
  state_->unrefined.clear();
  for (auto& [segment, way] : state_->ways) {
    for (int pass = 0; pass < kPasses; ++pass) {
      if (goes_on && !goes_on(done++ / all)) return false;
      if (way.size() < 2 || way.refine()) continue;
      if (pass == 0) state_->unrefined.push_back(segment);
    }
  }
  return true;
}

std::vector<int> Reference::unrefined() const { return state_->unrefined; }

/// What the passes moved, moves what lies between two scans of a way, too.
std::vector<Estimate> Reference::State::answers() const {
  std::vector<Estimate> answers;
  std::map<int, Pose> carried;  // T_new_old where the last one of a segment was moved
  for (const Added& one : added) {
    Estimate& answer = answers.emplace_back(one.estimate);
    Pose& T_new_old = carried[answer.segment];
    if (one.scan) {
      const WholeWay& way = ways.at(answer.segment);
      const Pose before = answer.trajectory.at(0.5);
      answer.trajectory = way.trajectory(*one.scan);
      answer.covariance = way.covariance(*one.scan);
      T_new_old = answer.trajectory.at(0.5) * before.inverse();
    } else {
      answer.trajectory = answer.trajectory.moved(T_new_old);
    }
  }
  return answers;
}

Odometry Reference::replay() const {
  const auto known = std::make_shared<const KnownAnswers>(
      KnownAnswers{state_->answers(), state_->odometry.level()});
  return Odometry(
      state_->session.config, state_->session.workers.threads(),
      [known](const Session& session) { return std::make_unique<KnownFrontEnd>(session, known); });
}

}  // namespace surefoot
