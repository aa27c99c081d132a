// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "memory.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

namespace surefoot::benchmarks {

double resident_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key; std::getline(status, key)) {
    double kibibytes = 0.0;
    if (key == "VmRSS:" && status >> kibibytes) return 1.024e-3 * kibibytes;
  }
  throw std::runtime_error("/proc/self/status has no line 'VmRSS:', this process's memory");
}

}  // namespace surefoot::benchmarks
