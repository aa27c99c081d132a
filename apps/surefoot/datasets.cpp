// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot datasets: the public data sets that --dataset knows, and what it does for each.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "io/datasets.hpp"

namespace surefoot::app {
namespace {

std::string place(const Pose& pose) {
  const Eigen::Vector3d angles = roll_pitch_yaw(pose.rotation) * (180.0 / EIGEN_PI);
  const Eigen::Vector3d& at = pose.translation;
  return fmt::format("{:.4f} {:.4f} {:.4f} m, {:.2f} {:.2f} {:.2f} deg", at.x(), at.y(), at.z(),
                     angles.x(), angles.y(), angles.z());
}

void print_fact(const char* name, const std::string& value) {
  if (!value.empty()) fmt::print("  {:<10} {}\n", name, value);
}

void print(const io::Dataset& set) {
  fmt::print("{}: {}\n", set.name, set.what);
  print_fact("topic", fmt::format("{}", fmt::join(set.topics, ", ")));
  if (set.stamp_at == io::StampAt::end) print_fact("stamps", "name the end of a sweep");
  if (set.rows > 0) {
    print_fact("times", fmt::format("by columns, {} of {} points", set.columns, set.rows));
  }
  if (set.derive_times == io::DeriveTimes::azimuth) {
    print_fact("times", fmt::format("by azimuth, from {:g} deg", set.cut_azimuth_deg));
  }
  if (set.T_base_lidar) print_fact("extrinsic", "T_base_lidar " + place(*set.T_base_lidar));
  print_fact("truth", set.truth_file);
  if (set.T_lidar_truth) print_fact("truth of", "T_lidar_truth " + place(*set.T_lidar_truth));
  print_fact("note", set.remark);
  print_fact("tried", set.tried);
}

}  // namespace

void add_datasets_command(CLI::App& app, int&) {
  const auto name = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("datasets", "Tell of the public data sets that --dataset knows");
  command->add_option("name", *name, "one of them (all)")
      ->check(command_line::one_of(io::dataset_names()));
  command->callback([name] {
    for (const io::Dataset& set : io::datasets()) {
      if (name->empty() || *name == set.name) print(set);
    }
  });
}

}  // namespace surefoot::app
