// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What commands read besides recordings: parameters, the files of a run, meshes, pose graphs.
#include <stdexcept>

#include "fuzz/targets.hpp"
#include "fuzz/whole_way.hpp"
#include "io/recording.hpp"
#include "mapping/g2o_file.hpp"
#include "runs/config_file.hpp"
#include "runs/csv_table.hpp"
#include "runs/loops_csv.hpp"
#include "runs/run_yaml.hpp"
#include "runs/scans_csv.hpp"
#include "simulation/mesh_file.hpp"
#include "surefoot/config.hpp"

namespace surefoot::fuzz {
namespace {

std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void read_parameters(Bytes bytes) {
  static const MemoryFile file;
  const std::string name = file.holding(bytes);
  try {
    const std::string method = runs::method_of_file(name);
    Config config = method_config(method.empty() ? "surefoot" : method);
    runs::load_config_file(name, config);
  } catch (const ConfigError&) {
  }
}
Seeds parameter_seeds() {
  return {"method: paper\ndeskew:\n  segments: 4\npreprocess.max_range: 50 # m\n",
          "method: surefoot\nparameters: {knots: {levels: 4}}\n"};
}

void read_run_folder(Bytes bytes) {
  static const MemoryFile file;
  const std::string name = file.holding(bytes);
  const auto attempt = [](auto&& read) {
    try {
      read();
    } catch (const io::ReadError&) {
    }
  };
  attempt([&] { (void)runs::read_run_yaml(name); });
  attempt([&] { (void)runs::read_csv_table(name); });
  attempt([&] {
    const report::ScanTable scans = runs::read_scans_csv(name);
    (void)runs::count_statuses(scans);
    (void)runs::read_loops_csv(name, scans);
  });
}
Seeds run_folder_seeds() {
  runs::RunDescription run;
  run.input = "a \"walk\"";
  run.notes = {"one", "two"};
  run.options = {{"topic", "/t"}};
  const Estimate estimate;
  const runs::StepTimes times;
  return {runs::run_yaml_text(run),
          runs::scans_csv_header() + runs::scans_csv_line({0, "a,\"b\"\n", estimate, times}),
          "a,b\n\"x\"\"y\",2\n"};
}

// The first byte chooses the format.
void read_mesh(Bytes bytes) {
  if (bytes.empty()) return;
  static const MemoryFile file;
  constexpr simulation::TriangleMesh (*kReaders[])(const std::filesystem::path&) = {
      simulation::read_ply, simulation::read_obj, simulation::read_ascii_grid};
  const auto choice = std::to_integer<std::size_t>(bytes.front()) % std::size(kReaders);
  try {
    (void)kReaders[choice](file.holding(bytes.subspan(1)));
  } catch (const std::runtime_error&) {
  }
}
Seeds mesh_seeds() {
  const std::string head =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  return {
      std::string(1, '\0') + "ply\nformat ascii 1.0\n" + head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
      std::string(1, '\0') + "ply\nformat binary_little_endian 1.0\n" + head +
          std::string(36, '\0') + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13),
      "\1v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1/1 2/2/2 -1 -2\n",
      "\2ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9\n1 2\n3 -9\n"};
}

void read_pose_graph(Bytes bytes) {
  try {
    (void)mapping::format_g2o(mapping::parse_g2o(text_of(bytes)));
  } catch (const std::invalid_argument&) {
  }
}
Seeds pose_graph_seeds() {
  return {
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 0 0 0 0 0 1\n"
      "EDGE_SE3:QUAT 0 1 1 0 0 0 0 0 1 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n",
      "EDGE3 0 1 1 0 0 0 0 0.1 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n"};
}

constexpr Target kProgramTargets[] = {{"parameters", read_parameters, parameter_seeds},
                                      {"run_folder", read_run_folder, run_folder_seeds},
                                      {"mesh", read_mesh, mesh_seeds},
                                      {"pose_graph", read_pose_graph, pose_graph_seeds}};

}  // namespace

std::span<const Target> program_targets() { return kProgramTargets; }

}  // namespace surefoot::fuzz
