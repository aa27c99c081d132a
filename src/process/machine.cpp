// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "process/machine.hpp"

#include <fstream>
#include <thread>

namespace surefoot::process {

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    // x86 has "model name"; many ARM boards have "Model" or "Hardware" only.
    for (const char* key : {"model name", "Model", "Hardware"}) {
      if (line.rfind(key, 0) != 0) continue;
      const std::size_t colon = line.find(": ");
      if (colon != std::string::npos) return line.substr(colon + 2);
    }
  }
  return "unknown";
}

int processor_cores() { return static_cast<int>(std::thread::hardware_concurrency()); }

}  // namespace surefoot::process
