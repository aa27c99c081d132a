// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/error_model.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/se3.hpp"

namespace surefoot {

namespace {

// Of what a pose is let go of, this share counts as held back all the same: it is noisy, and at a
// run not far enough.
constexpr double kStillHeld = 0.5;

/// The residuals' variance as a share of the one that was assumed (reduced chi squared).
double residual_variance(const KnotRegistration& found, double independence) {
  return found.rigid.weighted_squares / (independence * std::max(found.rigid.count, 1));
}

}  // namespace

ErrorModel::ErrorModel(const Config::Knots& config)
    : independence_(config.independence),
      usual_rate_(config.usual_rate),
      dependence_(1.0 / config.independence) {}

ToldScan ErrorModel::tell(const KnotRegistration& found, const ScanTrajectory& trajectory,
                          const VelocityModel& model) const {
  const std::int64_t mid_ns = trajectory.mid_ns();
  const Eigen::Quaterniond rotation = trajectory.at(0.5).rotation;
  // Who stands has no gait.
  const auto let_go = [&](const Twist& held_back) -> Twist {
    return model.walking() * held_back_.let_go(held_back, rotation);
  };
  KnotWindow window = found.window;
  for (std::size_t k = 0; k < window.knots.size(); ++k) {
    window.knots[k] = displaced(window.knots[k], let_go(found.held_back[k]));
  }
  const Twist held_back = found.held_back_at(mid_ns), fluctuation = model.fluctuation();
  const Twist still_held = held_back - kStillHeld * let_go(held_back);
  const Matrix6 independent = residual_variance(found, independence_) * found.covariance_at(mid_ns);
  const Matrix6 in_all = dependence_.mean() * independent +
                         held_back_in_all_.covariance(held_back, fluctuation, rotation);
  // [K22]
  return {window.trajectory(trajectory.start_ns(), trajectory.end_ns()),
          dependence_.applied(independent, rotation) +
              held_back_.covariance(still_held, fluctuation, rotation),
          std::sqrt(in_all.diagonal().head<3>().maxCoeff())};
}

void ErrorModel::learn(const KnotRegistration& found, const ScanTrajectory& trajectory,
                       int agreed) {
  const Eigen::Quaterniond rotation = trajectory.at(0.5).rotation;
  const Twist held_back = found.held_back_at(trajectory.mid_ns());
  dependence_.learn(found, rotation, usual_rate_);
  for (HeldBack* usual : {&held_back_, &held_back_in_all_}) {
    usual->learn(held_back, rotation, std::max(usual_rate_, 1.0 / agreed));
  }
}

}  // namespace surefoot
