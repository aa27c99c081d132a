// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot eval: how far estimated trajectories are from a reference.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands.hpp"
#include "evaluation/evaluate.hpp"
#include "evaluation/tables.hpp"
#include "evaluation_options.hpp"
#include "io/bags/bag_files.hpp"
#include "io/trajectory_files.hpp"
#include "io/truth_files.hpp"
#include "option_checks.hpp"
#include "process/exit_codes.hpp"
#include "runs/run_files.hpp"
#ifdef SUREFOOT_HAS_PICTURES
#include "experiments/compare_figures.hpp"
#endif

namespace surefoot::app {
namespace {

namespace fs = std::filesystem;
using evaluation::AssociationMethod;
using evaluation::DeltaUnit;
using evaluation::Evaluation;

constexpr const char* kTruthFile = "gt.tum";

enum class FileFormat { automatic, tum, kitti };
enum class TableFormat { text, json, csv, latex };

struct EvalOptions {
  std::string dataset;
  std::string truth_topic;
  fs::path reference;
  std::vector<fs::path> estimates;
  FileFormat format = FileFormat::automatic;
  evaluation::EvaluationOptions evaluation;
  TableFormat table = TableFormat::text;
  std::vector<fs::path> figures;  ///< to draw: .svg or .png
};

/// The trajectory in a run's folder, the truth in a recording's; any other path as it is.
fs::path trajectory_file(const fs::path& path) {
  for (const char* name : {runs::kTrajectoryFile, kTruthFile}) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored) && fs::exists(path / name, ignored)) return path / name;
  }
  return path;
}

/// What an estimate is called: its file without extension, or the run's folder.
std::string name_of(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return path.stem().string();
  const fs::path whole = fs::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

/// The first line that is no comment, or of names; empty where there is none.
std::string first_row(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return {};  // its reader says what it is
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    const bool comment = begin != std::string::npos && line[begin] == '#';
    const bool names =
        begin != std::string::npos && std::isalpha(static_cast<unsigned char>(line[begin]));
    if (begin != std::string::npos && !comment && !names) return line;
  }
  return {};
}

std::size_t columns_of(const fs::path& file) {
  std::string row = first_row(file);
  std::replace(row.begin(), row.end(), ',', ' ');
  std::istringstream words(row);
  std::size_t count = 0;
  for (std::string word; words >> word;) ++count;
  return count;
}

bool has_commas(const fs::path& file) { return first_row(file).find(',') != std::string::npos; }

/// By the number of values in the first row: TUM has 8, KITTI 12.
FileFormat format_of(const fs::path& file) {
  return columns_of(file) == 12 ? FileFormat::kitti : FileFormat::tum;
}

/// Whether the reference is a bag, or a table that is neither TUM's nor KITTI's.
bool is_table(const fs::path& file, bool find_format) {
  std::error_code ignored;
  if (!find_format || !fs::exists(file, ignored)) return false;
  if (io::is_bag_file(file) || fs::is_directory(file, ignored)) return true;
  const std::size_t columns = columns_of(file);
  return columns == 4 || columns == 9 || columns == 13 || has_commas(file);
}

/// KITTI's poses have no stamps; they get their row's number, which is never compared.
Trajectory read_trajectory(const fs::path& file, FileFormat format) {
  if (format == FileFormat::tum) return io::read_tum(file);
  Trajectory trajectory;
  for (const Pose& pose : io::read_kitti_poses(file)) {
    trajectory.push_back({static_cast<std::int64_t>(trajectory.size()), pose});
  }
  return trajectory;
}

/// The names, or the whole paths where these are not unique.
std::vector<std::string> names_of(const std::vector<fs::path>& files) {
  std::map<std::string, int> uses;
  for (const fs::path& file : files) ++uses[name_of(file)];
  std::vector<std::string> names;
  for (const fs::path& file : files) {
    const std::string name = name_of(file);
    names.push_back(uses[name] == 1 ? name : file.string());
  }
  return names;
}

std::string table_of(const std::vector<Evaluation>& evaluations, TableFormat format) {
  switch (format) {
    case TableFormat::json:
      return evaluation::to_json(evaluations);
    case TableFormat::csv:
      return evaluation::to_csv(evaluations);
    case TableFormat::latex:
      return evaluation::to_latex(evaluations);
    case TableFormat::text:
      break;
  }
  return evaluation::to_text(evaluations);
}

void draw_figures([[maybe_unused]] const EvalOptions& options,
                  [[maybe_unused]] const Trajectory& reference,
                  [[maybe_unused]] const std::vector<Evaluation>& evaluations,
                  [[maybe_unused]] const std::vector<Trajectory>& paths) {
#ifdef SUREFOOT_HAS_PICTURES
  std::vector<std::string> names;
  for (const Evaluation& evaluation : evaluations) names.push_back(evaluation.name);
  for (const fs::path& file : options.figures) {
    experiments::draw_views(reference, names, paths, file);
  }
#else
  if (!options.figures.empty()) {
    throw std::runtime_error("--figure: this program was built without pictures");
  }
#endif
}

/// An estimate that cannot be evaluated is told and left out; the others go on.
int evaluate_all(EvalOptions options) {
  const io::Dataset* set = options.dataset.empty() ? nullptr : &io::dataset_named(options.dataset);
  if (set == nullptr || set->truth != io::TruthOf::oxts) {
    options.reference = trajectory_file(options.reference);
  }
  const std::vector<std::string> names = names_of(options.estimates);
  for (fs::path& estimate : options.estimates) estimate = trajectory_file(estimate);
  const bool find_format = options.format == FileFormat::automatic;
  FileFormat format = find_format ? format_of(options.reference) : options.format;
  io::Truth truth;
  const bool foreign = set != nullptr || is_table(options.reference, find_format);
  if (foreign) {
    truth = io::read_truth(options.reference, set, options.truth_topic);
    format = truth.has_stamps ? FileFormat::tum : FileFormat::kitti;
    options.evaluation.positions_only = !truth.has_rotations;
    fmt::print(stderr, "note: {}: {}\n", options.reference.string(), truth.what);
  } else {
    truth.poses = read_trajectory(options.reference, format);
  }
  if (format == FileFormat::kitti) {
    options.evaluation.association.method = AssociationMethod::index;
    if (options.evaluation.stretches.unit == DeltaUnit::seconds) {
      throw std::runtime_error("--delta-unit s needs stamps, which KITTI's files do not have");
    }
  }
  const Trajectory& reference = truth.poses;
  std::vector<Evaluation> evaluations;
  std::vector<Trajectory> paths;  // aligned
  for (std::size_t i = 0; i < options.estimates.size(); ++i) {
    try {
      Trajectory estimate = read_trajectory(options.estimates[i], format);
      if (foreign) {
        for (StampedPose& pose : estimate) pose.pose = pose.pose * truth.T_lidar_truth;
      }
      evaluations.push_back(
          evaluation::evaluate(names[i], reference, estimate, options.evaluation));
      paths.push_back(evaluation::aligned(estimate, evaluations.back().alignment));
    } catch (const std::exception& error) {
      fmt::print(stderr, "surefoot: {}: {}\n", names[i], error.what());
    }
  }
  if (evaluations.empty()) return process::kBadInput;
  draw_figures(options, reference, evaluations, paths);
  fmt::print("{}", table_of(evaluations, options.table));
  return evaluations.size() == options.estimates.size() ? process::kDone : process::kSomeFailed;
}

void add_format_option(CLI::App& command, FileFormat& format) {
  add_choice<FileFormat>(
      command, "--format", format, "Of all files: auto, tum or kitti",
      {{"auto", FileFormat::automatic}, {"tum", FileFormat::tum}, {"kitti", FileFormat::kitti}});
}

}  // namespace

void add_eval_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<EvalOptions>();
  CLI::App* command =
      app.add_subcommand("eval", "Compare trajectories with a reference (TUM or KITTI files)");
  command
      ->add_option("reference", options->reference,
                   "The true trajectory, or a recording with a gt.tum")
      ->required();
  command
      ->add_option("estimates", options->estimates,
                   "One trajectory or more, or folders that surefoot run has written")
      ->required();
  add_format_option(*command, options->format);
  command
      ->add_option("--dataset", options->dataset,
                   "The reference is this data set's: its file, its columns, and where what it "
                   "tells sits on the LiDAR; 'surefoot datasets' tells of each")
      ->check(one_of(io::dataset_names()))
      ->type_name("NAME");
  command->add_option("--truth-topic", options->truth_topic,
                      "Topic of the reference, where that is a bag");
  add_pairing_options(*command, options->evaluation.association);
  add_error_options(*command, options->evaluation);
  command
      ->add_option("--figure", options->figures,
                   "Draw the aligned trajectories to this .svg, .pdf or .png file; may be repeated")
      ->allow_extra_args(false);
  CLI::Option_group* output = command->add_option_group("output");
  const auto add_table = [&](const char* flag, TableFormat format, const char* help) {
    output->add_flag_callback(
        flag, [options, format] { options->table = format; }, help);
  };
  add_table("--json", TableFormat::json, "Print every figure as JSON");
  add_table("--csv", TableFormat::csv, "Print a line for each estimate and error");
  add_table("--latex", TableFormat::latex, "Print a table for a paper");
  output->require_option(0, 1);
  command->callback([options, &exit_code] { exit_code = evaluate_all(*options); });
}

}  // namespace surefoot::app
