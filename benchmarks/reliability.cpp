// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// reliability: what the odometry says of itself when something goes wrong, fault by fault and walk
// by walk, and how often what it says is so. Without --keep it prints; docs/reliability.md has the
// commands. Exit codes: 0, 2 for bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "fault_runs.hpp"
#include "kept_run.hpp"

namespace surefoot::benchmarks {

namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> walks;
  std::vector<std::string> faults;  // by name; none: all
  std::uint64_t scans = simulation::kFaultyScans;
  std::string keep;     // folder
  std::string samples;  // file
  std::string commit;
  std::vector<std::string> set;  // parameters
};

/// A run in figures.
struct Outcome {
  int ok = 0, degenerate = 0, untrusted = 0, false_ok = 0;
  int segments = 1;
  std::optional<double> error;        // [m] at the last trusted scan, in the frame of before
  std::optional<double> right_again;  // [s] from the fault's first scan
};

Outcome outcome_of(const std::vector<JudgedScan>& judged) {
  Outcome outcome;
  std::size_t right_from = judged.size();
  for (std::size_t n = 0; n < judged.size(); ++n) {
    const JudgedScan& scan = judged[n];
    const Status status = scan.estimate.status;
    outcome.ok += status == Status::ok ? 1 : 0;
    outcome.degenerate += status == Status::degenerate ? 1 : 0;
    outcome.untrusted += scan.estimate.trusted() ? 0 : 1;
    outcome.false_ok += scan.false_ok() ? 1 : 0;
    outcome.segments = std::max(outcome.segments, scan.estimate.segment + 1);
    const bool told = scan.estimate.trusted() && scan.since_fault;
    if (told) outcome.error = scan.since_fault->distance;
    const bool right = told && !scan.since_fault->wrong();
    if (!right) right_from = judged.size();
    if (right && right_from == judged.size()) right_from = n;
  }
  if (right_from < judged.size()) {
    const std::uint64_t begin = simulation::kFaultBegins;
    outcome.right_again = right_from > begin ? 0.1 * static_cast<double>(right_from - begin) : 0.0;
  }
  if (!judged.back().since_fault) outcome.error.reset();
  return outcome;
}

/// How often poses of which a probability is told are wrong.
struct Bin {
  int scans = 0;
  int wrong = 0;
  double told = 0.0;  // sum
};
/// By powers of ten, where small ones matter: from up to 1e-4 to more than a half.
constexpr std::array<double, 7> kBinEnds = {1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.5, 1.0};
using Bins = std::array<Bin, kBinEnds.size()>;

void count(const std::vector<JudgedScan>& judged, Bins& bins) {
  for (const JudgedScan& scan : judged) {
    const double told = scan.estimate.wrong_probability;
    if (scan.estimate.status != Status::ok || !scan.over_ten || !(told <= 1.0)) continue;
    const auto end = std::lower_bound(kBinEnds.begin(), kBinEnds.end(), told);
    Bin& bin = bins[static_cast<std::size_t>(end - kBinEnds.begin())];
    ++bin.scans;
    bin.told += told;
    bin.wrong += scan.over_ten->wrong() ? 1 : 0;
  }
}

class Report {
 public:
  explicit Report(const Options& options) : options_(options) {
    if (!options.samples.empty()) {
      samples_.open(options.samples);
      samples_ << "walk,fault,scan,status,wrong,disturbed";
      for (const EvidenceField& field : kEvidenceFields) samples_ << ',' << field.name;
      samples_ << '\n';
    }
  }

  void add(const std::string& walk, const simulation::Fault& fault,
           const std::vector<JudgedScan>& judged) {
    const Outcome o = outcome_of(judged);
    const auto shown = [](const std::optional<double>& value, const char* format) {
      return value ? fmt::format(fmt::runtime(format), *value) : std::string("–");
    };
    rows_ += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", walk, fault.name, judged.size(), o.ok,
                         o.degenerate, o.untrusted, o.false_ok, o.segments,
                         shown(o.error, "{:.3f}"), shown(o.right_again, "{:.1f}"));
    fmt::print(
        "{:18} {:20} {:4} ok, {:3} false, {:3} degenerate, {:3} not trusted, {} segments, "
        "{:>8} m, right after {:>4} s\n",
        walk, fault.name, o.ok, o.false_ok, o.degenerate, o.untrusted, o.segments,
        shown(o.error, "{:.3f}"), shown(o.right_again, "{:.1f}"));
    std::fflush(stdout);
    false_ok_ += o.false_ok;
    ok_ += o.ok;
    count(judged, bins_);
    add_samples(walk, fault, judged);
  }

  void finish(const std::string& command) const {
    fmt::print("{} of {} ok are false\n", false_ok_, ok_);
    std::string bins = "told up to,scans,mean told,wrong,share wrong\n";
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      const Bin& bin = bins_[i];
      const double n = std::max(bin.scans, 1);
      bins += fmt::format("{:g},{},{:.5f},{},{:.5f}\n", kBinEnds[i], bin.scans, bin.told / n,
                          bin.wrong, bin.wrong / n);
    }
    fmt::print("{}", bins);
    if (options_.keep.empty()) return;
    write("reliability.csv", command,
          "walk,fault,scans,ok,degenerate,untrusted,false_ok,segments,error_m,right_again_s\n" +
              rows_);
    write("reliability_bins.csv", command, bins);
  }

 private:
  void add_samples(const std::string& walk, const simulation::Fault& fault,
                   const std::vector<JudgedScan>& judged) {
    if (!samples_.is_open()) return;
    for (std::size_t n = 0; n < judged.size(); ++n) {
      const Estimate& estimate = judged[n].estimate;
      const std::optional<MotionError>& since = judged[n].since_fault;
      const bool calm =
          n < simulation::kFaultBegins || fault.name == simulation::fault_catalogue().front().name;
      const bool told = estimate.status == Status::ok && judged[n].over_ten;
      const bool wrong = told && judged[n].over_ten->wrong();
      // Right against ten scans before, at a place that is wrong since the fault: neither.
      const bool right = told && !wrong && (calm || !since || !since->wrong());
      samples_ << fmt::format("{},{},{},{},{},{}", walk, fault.name, n, to_string(estimate.status),
                              wrong   ? "1"
                              : right ? "0"
                                      : "-",
                              calm ? 0 : 1);
      for (const EvidenceField& field : kEvidenceFields) {
        samples_ << fmt::format(",{:.4f}", estimate.evidence.*field.member);
      }
      samples_ << '\n';
    }
  }

  void write(const char* name, const std::string& command, const std::string& text) const {
    const fs::path file = fs::path(options_.keep) / name;
    std::ofstream out(file);
    out << "# commit: " << options_.commit << "\n# command: " << command << '\n' << text;
    if (!out) throw std::runtime_error(file.string() + ": cannot be written");
  }

  const Options& options_;
  std::ofstream samples_;
  std::string rows_;
  Bins bins_{};
  int false_ok_ = 0, ok_ = 0;
};

bool wanted(const Options& options, const simulation::Fault& fault) {
  const auto& names = options.faults;
  return names.empty() || std::find(names.begin(), names.end(), fault.name) != names.end();
}

void run(const Options& options, const std::string& command) {
  for (const std::string& name : options.faults) {
    const auto& all = simulation::fault_catalogue();
    const auto named = [&](const simulation::Fault& fault) { return fault.name == name; };
    if (std::none_of(all.begin(), all.end(), named)) {
      throw std::invalid_argument("no fault is called '" + name + "'");
    }
  }
  Config config;
  for (const std::string& text : options.set) {
    const std::size_t at = text.find('=');
    set_parameter(config, text.substr(0, at), text.substr(std::min(at + 1, text.size())));
  }
  const FaultWalk elsewhere({"playground", 99, ""});
  Report report(options);
  for (const std::string& text : options.walks) {
    const FaultWalk walk(WalkSpec::parse(text));
    for (const simulation::Fault& fault : simulation::fault_catalogue()) {
      if (!wanted(options, fault)) continue;
      report.add(walk.spec().name(), fault,
                 run_fault(walk, elsewhere, fault, options.scans, config));
    }
  }
  report.finish(command);
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  surefoot::benchmarks::Options options;
  // Scenes and seeds that the verdict was not fitted on.
  options.walks = {"plaza:61",   "foyer:62",  "forest-path:63", "rubble:64",
                   "hilltop:65", "campus:66", "stairwell:67"};
  CLI::App app{"What the odometry says of itself when something goes wrong"};
  app.add_option("--walk", options.walks, "SCENE:SEED[:ROBOT]")->capture_default_str();
  app.add_option("--fault", options.faults, "Names of faults; none: all");
  app.add_option("--scans", options.scans, "Of every run")
      ->check(CLI::Range(40, 650))
      ->capture_default_str();
  app.add_option("--set", options.set, "NAME=VALUE: a parameter of the odometry");
  app.add_option("--keep", options.keep, "Folder for reliability.csv and reliability_bins.csv");
  app.add_option("--samples", options.samples, "File for the evidence of every scan");
  app.add_option("--commit", options.commit, "Named in what is kept");
  const auto run = [&](const std::string& command) { surefoot::benchmarks::run(options, command); };
  return surefoot::benchmarks::run_kept(app, argc, argv, "reliability", run);
}
