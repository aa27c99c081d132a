// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// fit_verdict SAMPLES...: the weights of src/methods/knots/verdict_weights.hpp, from what
// `reliability --samples` has written of runs that were never declared lost. docs/reliability.md.
//
// A pose is told wrong against that of ten scans before; which of the ten went wrong is not. So the
// likelihood is that of [K28], a noisy or over ten scans' hazards [K27], and no weight may be
// negative: nothing that speaks against a pose may ever speak for it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "surefoot/estimate.hpp"

namespace surefoot::benchmarks {

namespace {

constexpr std::size_t kFields = kEvidenceFields.size();
// Before the evidence: walk, fault, scan, status, wrong, disturbed.
constexpr std::size_t kColumns = 6;
using Weights = std::array<double, kFields + 1>;  // the offset last

struct Sample {
  std::array<double, kFields> evidence{};
  double hazard = 0.0;
  double slope = 0.0;  // of the loss by the hazard's logit
};

/// What is told of a pose, and the scans since that it is held against.
struct Window {
  std::size_t first = 0, last = 0;  // both included
  bool wrong = false;
  bool disturbed = false;  // a fault has begun
};

struct Data {
  std::vector<Sample> samples;
  std::vector<Window> windows;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

void read(const std::string& file, Data& data) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line) || cells_of(line).size() != kFields + kColumns) {
    throw std::runtime_error(file + ": expected what reliability --samples writes");
  }
  std::string run;
  std::size_t first = data.samples.size();  // of the segment
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != kFields + kColumns) {
      throw std::runtime_error(file + ": a line of another length");
    }
    if (cells[0] + ',' + cells[1] != run || cells[3] == "first_scan") first = data.samples.size();
    run = cells[0] + ',' + cells[1];
    if (cells[3] != "ok" && cells[3] != "degenerate") continue;
    Sample sample;
    for (std::size_t i = 0; i < kFields; ++i) sample.evidence[i] = std::stod(cells[kColumns + i]);
    data.samples.push_back(sample);
    const std::size_t last = data.samples.size() - 1;
    if (cells[4] == "-") continue;
    data.windows.push_back(
        {std::max(first, last >= 9 ? last - 9 : 0), last, cells[4] == "1", cells[5] == "1"});
  }
}

/// What a pose counts. Right ones under a fault are as rare as wrong ones are; so much of both that
/// the wrong ones are `base` of all.
struct Counts {
  double disturbed = 1.0;
  double sum = 0.0;  // of all

  [[nodiscard]] double of(const Window& window) const {
    return window.wrong || window.disturbed ? disturbed : 1.0;
  }
};

Counts count(const Data& data, double base) {
  double wrong = 0.0, rare = 0.0, calm = 0.0;
  for (const Window& window : data.windows) {
    wrong += window.wrong ? 1.0 : 0.0;
    (window.wrong || window.disturbed ? rare : calm) += 1.0;
  }
  if (calm == 0.0 || wrong <= base * rare) throw std::runtime_error("no wrong or no calm poses");
  Counts counts{base * calm / (wrong - base * rare), 0.0};
  counts.sum = calm + counts.disturbed * rare;
  fmt::print(
      "// {} poses: {} under a fault or wrong, {} of them wrong and weighed as one in {:.0f}\n",
      data.windows.size(), rare, wrong, 1.0 / base);
  return counts;
}

/// Of the loss, by the weights.
Weights gradient(Data& data, const Weights& weights, const Counts& counts) {
  for (Sample& sample : data.samples) {
    double sum = weights.back();
    for (std::size_t i = 0; i < kFields; ++i) sum += weights[i] * sample.evidence[i];
    sample.hazard = 1.0 / (1.0 + std::exp(-sum));
    sample.slope = 0.0;
  }
  for (const Window& window : data.windows) {
    double right = 1.0;
    for (std::size_t i = window.first; i <= window.last; ++i) right *= 1.0 - data.samples[i].hazard;
    right = std::clamp(right, 1e-12, 1.0 - 1e-12);
    const double factor = counts.of(window) * (window.wrong ? -right / (1.0 - right) : 1.0);
    for (std::size_t i = window.first; i <= window.last; ++i) {
      data.samples[i].slope += factor * data.samples[i].hazard;
    }
  }
  Weights sum{};
  for (const Sample& sample : data.samples) {
    for (std::size_t i = 0; i < kFields; ++i) sum[i] += sample.slope * sample.evidence[i];
    sum.back() += sample.slope;
  }
  return sum;
}

/// By Adam's steps, which need no scale of the evidence to be known.
Weights fit(Data& data, double base) {
  constexpr int kSteps = 3000;
  constexpr double kRate = 0.05, kFirst = 0.9, kSecond = 0.999, kRidge = 1e-3;
  const Counts counts = count(data, base);
  const double scale = 1.0 / (base * counts.sum);
  Weights weights{}, mean{}, square{};
  weights.back() = -5.0;
  for (int step = 1; step <= kSteps; ++step) {
    const Weights g = gradient(data, weights, counts);
    for (std::size_t i = 0; i <= kFields; ++i) {
      const double slope = scale * g[i] + (i < kFields ? kRidge * weights[i] : 0.0);
      mean[i] += (1.0 - kFirst) * (slope - mean[i]);
      square[i] += (1.0 - kSecond) * (slope * slope - square[i]);
      const double rate = kRate * std::min(1.0, 2.0 - 2.0 * step / kSteps);
      weights[i] -= rate * mean[i] / (1.0 - std::pow(kFirst, step)) /
                    (std::sqrt(square[i] / (1.0 - std::pow(kSecond, step))) + 1e-9);
      if (i < kFields) weights[i] = std::max(weights[i], 0.0);
    }
  }
  return weights;
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  using namespace surefoot;
  using namespace surefoot::benchmarks;
  std::vector<std::string> files;
  double base = 0.01;
  CLI::App app{"Fits the weights of the verdict"};
  app.add_option("SAMPLES", files, "What reliability --samples has written")->required();
  app.add_option("--base", base, "Share of wrong poses in the mix that the probability is for")
      ->check(CLI::Range(1e-6, 0.5))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    Data data;
    for (const std::string& file : files) read(file, data);
    const Weights weights = fit(data, base);
    for (std::size_t i = 0; i < kFields; ++i) {
      fmt::print(".{} = {:.3f},\n", kEvidenceFields[i].name, weights[i]);
    }
    fmt::print("inline constexpr double kVerdictOffset = {:.3f};\n", weights.back());
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "fit_verdict: {}\n", error.what());
    return 2;
  }
}
