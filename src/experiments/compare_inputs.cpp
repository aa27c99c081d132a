// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/compare_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "io/file_writer.hpp"
#include "process/child_process.hpp"
#include "process/interrupt.hpp"
#include "runs/run_truth.hpp"
#include "simulation/standard_suite.hpp"
#include "text/printable.hpp"

namespace surefoot::experiments {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSuiteMark = "complete";  // written when every recording of the suite is

fs::path absolute_path(const fs::path& path) {
  fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();  // without a final '/'
}

/// Where the truth is, or would be.
fs::path truth_of(const fs::path& recording) {
  if (fs::path found = runs::truth_beside(recording); !found.empty()) return found;
  return (fs::is_directory(recording) ? recording : recording.parent_path()) / runs::kTruthFile;
}

bool is_set_name(const std::string& suite) { return simulation::find_suite_set(suite) != nullptr; }

/// Where a suite's recordings are: the folder that was given, or the one within the output folder.
fs::path suite_folder(const CompareOptions& options, const std::string& suite) {
  if (!is_set_name(suite)) return suite;
  return options.output / fmt::format("suite-{}-{}", suite, SUREFOOT_VERSION);
}

/// Folders with a truth, in the order of their names.
std::vector<fs::path> suite_recordings(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    std::string sets;
    for (const simulation::SuiteSet& set : simulation::kSuiteSets) {
      sets += fmt::format("{}, ", set.name);
    }
    throw std::runtime_error(fmt::format(
        "--suite {}: no such folder; expected {}or a folder of recordings", folder.string(), sets));
  }
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory() && fs::exists(entry.path() / runs::kTruthFile)) {
      found.push_back(absolute_path(entry.path()));
    }
  }
  if (found.empty()) {
    throw std::runtime_error(
        fmt::format("--suite {}: no folder in it has a {}", folder.string(), runs::kTruthFile));
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Of a set that is not made yet, those that it will hold.
std::vector<fs::path> recordings_of(const CompareOptions& options, const std::string& suite) {
  const fs::path folder = suite_folder(options, suite);
  const simulation::SuiteSet* set = simulation::find_suite_set(suite);
  if (set == nullptr || fs::exists(folder / kSuiteMark)) return suite_recordings(folder);
  std::vector<fs::path> planned;
  for (const simulation::SuiteEntry& entry : set->entries()) {
    planned.push_back(absolute_path(folder / simulation::suite_folder_name(entry)));
  }
  std::sort(planned.begin(), planned.end());
  return planned;
}

void check_given(const CompareOptions& options) {
  if (options.recordings.empty() && options.suites.empty()) {
    throw std::runtime_error(
        "nothing to compare: expected recordings (before --truth and --suite, which take all that "
        "follows), or --suite");
  }
  if (!options.truths.empty() && options.truths.size() != options.recordings.size()) {
    throw std::runtime_error(fmt::format("--truth: {} files for {} recordings; expected one each",
                                         options.truths.size(), options.recordings.size()));
  }
  for (const auto* paths : {&options.recordings, &options.truths}) {
    for (const fs::path& path : *paths) {
      if (!fs::exists(path)) throw std::runtime_error(path.string() + ": no such file or folder");
    }
  }
  for (const std::string& suite : options.suites) {
    if (!is_set_name(suite)) (void)suite_recordings(suite);
  }
}

}  // namespace

std::string folder_name(const std::string& text) {
  std::string name = text;
  for (char& c : name) {
    const bool fit = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                     std::string_view("-_.+=").find(c) != std::string_view::npos;
    if (!fit) c = '_';
  }
  if (name.empty() || name.front() == '.') name.insert(0, 1, '_');
  return name;
}

namespace {

/// The last part of each path, as `spelt` has it, after its parent's where several end alike.
std::vector<std::string> unique_names(const std::vector<fs::path>& paths,
                                      std::string (*spelt)(const std::string& text)) {
  std::map<std::string, int> uses;
  const auto last = [spelt](const fs::path& path) { return spelt(path.filename().string()); };
  for (const fs::path& path : paths) ++uses[last(path)];
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const fs::path& path : paths) {
    std::string name = last(path);
    if (uses[name] > 1) name = spelt(path.parent_path().filename().string()) + '-' + name;
    const std::string stem = name;
    for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}-{}", stem, i);
    names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<std::string> folder_names(const std::vector<fs::path>& paths) {
  return unique_names(paths, folder_name);
}

std::vector<std::string> shown_names(const std::vector<fs::path>& paths) {
  return unique_names(paths, [](const std::string& text) { return text::printable(text); });
}

std::vector<CompareInput> find_inputs(const CompareOptions& options) {
  check_given(options);
  std::vector<fs::path> paths, truths;
  for (std::size_t i = 0; i < options.recordings.size(); ++i) {
    paths.push_back(absolute_path(options.recordings[i]));
    truths.push_back(options.truths.empty() ? truth_of(paths.back())
                                            : absolute_path(options.truths[i]));
  }
  for (const std::string& suite : options.suites) {
    for (const fs::path& path : recordings_of(options, suite)) {
      paths.push_back(path);
      truths.push_back(truth_of(path));
    }
  }
  const std::vector<std::string> names = folder_names(paths), titles = shown_names(paths);
  std::vector<CompareInput> inputs;
  std::set<std::string> known;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (!known.insert(paths[i].string()).second) {
      throw std::runtime_error(paths[i].string() + ": is given twice");
    }
    CompareInput& input = inputs.emplace_back();
    input.name = names[i];
    input.path = paths[i];
    input.truth = truths[i];
    input.title = titles[i];
  }
  return inputs;
}

namespace {

/// Makes the set in the folder unless it is there; false if it was interrupted.
bool make_suite(const std::string& seeds, const fs::path& folder, int jobs, bool quiet) {
  if (fs::exists(folder / kSuiteMark)) return true;
#ifdef SUREFOOT_HAS_SIMULATION
  if (!quiet) {
    fmt::print(stderr, "making the recordings of the suite '{}' in {} (a few GB)\n", seeds,
               folder.string());
  }
  fs::create_directories(folder);
  const fs::path log = folder / "suite.log";
  const process::InterruptGuard interrupt;
  process::ChildProcess child(
      {"suite", "-o", folder.string(), "--seeds", seeds, "--jobs", std::to_string(jobs)}, log);
  std::optional<process::ProcessEnd> end;
  for (bool told = false; !(end = child.poll());) {
    if (interrupt.interrupted() && !std::exchange(told, true)) child.send(SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (interrupt.interrupted()) return false;
  if (end->exit_code != 0) {
    throw std::runtime_error(
        fmt::format("--suite {}: {}; see {}", seeds, process::describe(*end), log.string()));
  }
  io::write_whole_file(folder / kSuiteMark, "");
  return true;
#else
  (void)jobs;
  (void)quiet;
  throw std::runtime_error(fmt::format(
      "--suite {}: this program was built without the simulation that makes it", seeds));
#endif
}

}  // namespace

bool make_suites(const CompareOptions& options) {
  check_given(options);
  return std::all_of(options.suites.begin(), options.suites.end(), [&](const std::string& suite) {
    return !is_set_name(suite) ||
           make_suite(suite, suite_folder(options, suite), options.jobs, options.quiet);
  });
}

}  // namespace surefoot::experiments
