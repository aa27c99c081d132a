// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Several methods on several recordings: what was run, and what came out.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/evaluate.hpp"
#include "evaluation/verdict.hpp"

namespace surefoot::evaluation {

/// One run of one method on one recording, as it was measured from outside.
struct MeasuredRun {
  std::string folder = {};         ///< of the run's own output, relative to the comparison's
  int exit_code = -1;              ///< -1: ended by a signal, or never started
  int signal = 0;                  ///< that ended it; 0: none
  std::string error = {};          ///< why there is no result; empty if there is one
  double wall_seconds = 0.0;       ///< of the whole program, reading and writing included
  double processor_seconds = 0.0;  ///< of all its threads
  std::uint64_t peak_memory_bytes = 0;
  int jobs = 1;  ///< runs that shared the machine at most
  std::size_t scans = 0;
  std::size_t unreadable = 0;  ///< scans that the run could not read, not among those
  double median_ms = 0.0;      ///< per scan
  double p99_ms = 0.0;         ///< per scan
  std::map<std::string, std::size_t> statuses = {};  ///< how many scans had each, "ok" included
};

struct MethodResult {
  RunVerdict verdict = {};
  std::optional<Evaluation> evaluation = {};  ///< of the first run; none if there is no estimate
  /// The same after the first poses were made to coincide: attitude. Alignment by positions leaves
  /// the roll about a straight path open.
  std::optional<Evaluation> from_start = {};
  std::vector<MeasuredRun> runs = {};  ///< one a repeat
  bool repeats_agree = true;           ///< all trajectories are the same, byte for byte
};

struct ComparedMethod {
  std::string label = {};  ///< as given: "paper+deskew.segments=8"
  std::string method = {};
  std::vector<std::pair<std::string, std::string>> parameters = {};  ///< all of them, as used
};

struct ComparedRecording {
  std::string name = {};
  std::string path = {};
  std::string truth = {};                  ///< file of the reference
  std::string scene = {};                  ///< what it is a seed of; empty: it is one of a kind
  std::string fingerprint = {};            ///< of names, sizes and times of its files
  double truth_length = 0.0;               ///< [m] path of the reference; 0 if it cannot be read
  double truth_duration = 0.0;             ///< [s]
  std::vector<MethodResult> results = {};  ///< one for each method
};

struct Comparison {
  std::string version = {}, build = {};  ///< of the program
  std::string processor = {};
  int processor_cores = 0;
  int repeats = 1;
  std::vector<std::string> run_arguments = {};  ///< of every run, besides recording and parameters
  EvaluationOptions options = {};
  VerdictRules rules = {};
  std::string cover = "auto";  ///< what a run had to cover, as `--cover` names it
  std::vector<ComparedMethod> methods = {};
  std::vector<ComparedRecording> recordings = {};
};

/// Middle (of an even count the mean of the two) and ends of a figure over the repeats.
struct RepeatSpread {
  double median = 0.0, min = 0.0, max = 0.0;
};
[[nodiscard]] RepeatSpread spread_of(const MethodResult& result, double MeasuredRun::*figure);
[[nodiscard]] std::uint64_t peak_memory(const MethodResult& result);

/// The statuses that are not "ok", over the first run; a run's first scan is always "first_scan",
/// which is not counted.
[[nodiscard]] std::map<std::string, std::size_t> not_ok(const MethodResult& result);

/// The most runs that shared the machine while times were measured.
[[nodiscard]] int most_jobs(const Comparison& comparison);

}  // namespace surefoot::evaluation
