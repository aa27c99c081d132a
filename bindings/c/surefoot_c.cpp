// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// No exception crosses: it becomes a return value and a text.
#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>

#include "shared/scan_view.hpp"
#include "surefoot.h"
#include "surefoot/odometry.hpp"

struct surefoot_config {
  surefoot::Config config;
};

struct surefoot_odometry {
  surefoot::Odometry odometry;
  surefoot::Estimate last;
  bool any = false;
};

namespace {

thread_local std::string last_error;  // NOLINT: one a thread
thread_local std::string last_text;   // NOLINT: likewise

/// Throws where one of a call's arguments is missing.
template <typename... Pointers>
void require_given(const char* call, const Pointers*... arguments) {
  if (((arguments == nullptr) || ...)) {
    throw std::invalid_argument(std::string(call) + ": got NULL for what has to be there");
  }
}

/// As the program's --set: not what the method does not read, which would change nothing.
void require_parameter(const surefoot::Config& config, const std::string& name) {
  (void)surefoot::get_parameter(config, name);  // that there is one at all
  if (surefoot::reads_parameter(config, name)) return;
  throw surefoot::ConfigError(name + ": method " + config.method + " does not read it");
}

/// What `call` returns, or `failed`.
template <typename Result, typename Call>
Result guarded(Result failed, const Call& call) {
  try {
    return call();
  } catch (const std::exception& error) {
    last_error = error.what();
  } catch (...) {
    last_error = "unknown error";
  }
  return failed;
}

template <typename T>
surefoot::bindings::StridedView<T> view_of(const surefoot_column& column, std::size_t size) {
  if (column.first == nullptr || size == 0) return {};
  return {column.first, size, column.stride};
}

void write_pose(const surefoot::Pose& pose, double* out) {
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>{out} = pose.matrix();
}

void write_estimate(const surefoot::Estimate& estimate, surefoot_estimate& out) {
  out.status = static_cast<std::int32_t>(estimate.status);
  out.segment = estimate.segment;
  out.wrong_probability = estimate.wrong_probability;
  out.trusted = estimate.trusted() ? 1 : 0;
  out.stamp_ns = estimate.stamp_ns;
  write_pose(estimate.T_world_lidar, out.T_world_lidar);
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>{out.covariance} = estimate.covariance;
  Eigen::Map<surefoot::Twist>{out.twist} = estimate.twist;
  out.points = estimate.points;
  out.registered_points = estimate.registered_points;
}

static_assert(static_cast<int>(surefoot::Status::ok) == SUREFOOT_OK);
static_assert(static_cast<int>(surefoot::Status::first_scan) == SUREFOOT_FIRST_SCAN);
static_assert(static_cast<int>(surefoot::Status::degenerate) == SUREFOOT_DEGENERATE);
static_assert(static_cast<int>(surefoot::Status::too_few_matches) == SUREFOOT_TOO_FEW_MATCHES);
static_assert(static_cast<int>(surefoot::Status::diverged) == SUREFOOT_DIVERGED);
static_assert(static_cast<int>(surefoot::Status::lost) == SUREFOOT_LOST);
static_assert(static_cast<int>(surefoot::Status::rejected) == SUREFOOT_REJECTED);

}  // namespace

extern "C" {

const char* surefoot_version(void) { return SUREFOOT_VERSION; }

const char* surefoot_last_error(void) { return last_error.c_str(); }

surefoot_config* surefoot_config_new(const char* method) {
  return guarded<surefoot_config*>(nullptr, [&] {
    return new surefoot_config{surefoot::method_config(method == nullptr ? "surefoot" : method)};
  });
}

void surefoot_config_free(surefoot_config* config) { delete config; }

int surefoot_config_set(surefoot_config* config, const char* name, const char* value) {
  return guarded(1, [&] {
    require_given("surefoot_config_set", config, name, value);
    require_parameter(config->config, name);
    surefoot::set_parameter(config->config, name, value);
    return 0;
  });
}

const char* surefoot_config_get(const surefoot_config* config, const char* name) {
  return guarded<const char*>(nullptr, [&] {
    require_given("surefoot_config_get", config, name);
    last_text = surefoot::get_parameter(config->config, name);
    return last_text.c_str();
  });
}

surefoot_odometry* surefoot_odometry_new(const surefoot_config* config, int threads) {
  return guarded<surefoot_odometry*>(nullptr, [&] {
    const surefoot::Config chosen =
        config == nullptr ? surefoot::method_config("surefoot") : config->config;
    return new surefoot_odometry{surefoot::Odometry(chosen, std::max(threads, 1)), {}, false};
  });
}

void surefoot_odometry_free(surefoot_odometry* odometry) { delete odometry; }

int surefoot_add_scan(surefoot_odometry* odometry, const surefoot_scan* scan,
                      surefoot_estimate* estimate) {
  return guarded(1, [&] {
    require_given("surefoot_add_scan", odometry, scan);
    surefoot::bindings::ScanView view;
    view.stamp_ns = scan->stamp_ns;
    view.points = view_of<Eigen::Vector3f>(scan->points, scan->size);
    view.times_ns = view_of<std::int32_t>(scan->times_ns, scan->size);
    view.intensities = view_of<float>(scan->intensities, scan->size);
    view.rings = view_of<std::uint16_t>(scan->rings, scan->size);
    odometry->last = odometry->odometry.add_scan(surefoot::bindings::scan_of(view));
    odometry->any = true;
    if (estimate != nullptr) write_estimate(odometry->last, *estimate);
    return 0;
  });
}

const char* surefoot_message(const surefoot_odometry* odometry) {
  return odometry == nullptr ? "" : odometry->last.message.c_str();
}

int surefoot_pose_at(const surefoot_odometry* odometry, int64_t instant_ns,
                     double T_world_lidar[16]) {
  return guarded(1, [&] {
    require_given("surefoot_pose_at", odometry, T_world_lidar);
    if (!odometry->any) throw std::logic_error("no scan was added yet");
    write_pose(odometry->last.pose_at(instant_ns), T_world_lidar);
    return 0;
  });
}

size_t surefoot_local_map(const surefoot_odometry* odometry, double* xyz, size_t capacity) {
  return guarded<std::size_t>(0, [&] {
    require_given("surefoot_local_map", odometry);
    if (capacity > 0) require_given("surefoot_local_map", xyz);
    const std::vector<Eigen::Vector3d> points = odometry->odometry.local_map();
    for (std::size_t i = 0; i < std::min(points.size(), capacity); ++i) {
      Eigen::Map<Eigen::Vector3d>{xyz + 3 * i} = points[i];
    }
    return points.size();
  });
}

}  // extern "C"
