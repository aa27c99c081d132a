// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot merge: saved maps of one place as one map.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "commands.hpp"
#include "io/counted.hpp"
#include "map_outcome.hpp"
#include "process/exit_codes.hpp"
#include "process/progress.hpp"
#include "runs/map_merge_run.hpp"

namespace surefoot::app {

namespace {

namespace fs = std::filesystem;

struct MergeArguments {
  std::vector<fs::path> maps;
  fs::path output;
  bool overwrite = false;
  bool leave_out = false;
};

int merge(const MergeArguments& arguments) {
  process::Progress progress("pieces", false);
  const runs::MergeOutcome outcome = runs::merge_saved_maps(
      arguments.maps, arguments.output, arguments.overwrite, arguments.leave_out,
      [&](std::size_t done, std::size_t all) {
        progress.update(done, static_cast<double>(done) / static_cast<double>(all));
      });
  progress.finish();
  for (const runs::MergedMap& map : outcome.maps) {
    if (map.joined) {
      fmt::print("{}: joined by {} of {} compared; {} seen by both; {}\n", map.path.string(),
                 io::counted(map.taken, "loop"), io::counted(map.compared, "place"),
                 io::counted(map.near, "place"), place_in_map(*map.begin));
      if (map.held < map.pieces) {
        fmt::print("{}: {} of its {} are held to it; the others are left out\n", map.path.string(),
                   map.held, io::counted(map.pieces, "piece"));
      }
    } else {
      fmt::print("{}: not joined, of {} compared: {}\n", map.path.string(),
                 io::counted(map.compared, "place"), map.message);
    }
  }
  if (outcome.written) {
    fmt::print("results: {}, {} of way\n", arguments.output.string(),
               io::counted(outcome.pieces, "piece"));
    return outcome.joined() ? process::kDone : process::kSomeFailed;
  }
  fmt::print(stderr, "surefoot: no joint map is written; loops.csv in {} says what was compared\n",
             arguments.output.string());
  return process::kSomeFailed;
}

}  // namespace

void add_merge_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command =
      app.add_subcommand("merge", "Join maps of surefoot map that show the same places into one");
  command
      ->add_option("maps", arguments->maps,
                   "two or more: map.surefoot or its folder; the joint map is in the first's frame")
      ->required()
      ->expected(-2);
  command->add_option("-o,--output", arguments->output, "folder for map.surefoot and loops.csv")
      ->required();
  command->add_flag("--overwrite", arguments->overwrite,
                    "write also where such files lie already; one of the maps may be among them");
  command->add_flag("--leave-out", arguments->leave_out,
                    "write the joint map also where some cannot be joined, without these");
  command->callback([arguments, &exit_code] { exit_code = merge(*arguments); });
}

}  // namespace surefoot::app
