// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "soak.hpp"

#include <chrono>
#include <fstream>
#include <thread>

namespace surefoot::test {

std::size_t resident_kb(pid_t id) {
  std::ifstream status("/proc/" + std::to_string(id) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::stoul(line.substr(6));
  }
  return 0;
}

std::vector<std::string> malformed_datagrams(const std::vector<std::string>& packets,
                                             std::mt19937& random) {
  std::vector<std::string> malformed;
  for (std::size_t i = 0; i < 4096; ++i) {
    std::string bytes(i % 4 == 0 ? 1206 : random() % 1500, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    if (i % 4 == 1) bytes = packets[i % packets.size()].substr(0, random() % 1206);
    if (i % 64 == 2) bytes.clear();
    malformed.push_back(bytes);
  }
  return malformed;
}

void PatientSender::send(const std::string& bytes) {
  sender_.send(bytes);
  if (++sent_ % 64 != 0) return;
  while (sender_.waiting() > 1'000'000) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace surefoot::test
