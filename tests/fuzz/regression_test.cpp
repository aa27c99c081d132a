// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The fuzz targets without a fuzzer: every seed whole, cut everywhere, and with bytes changed.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "fuzz/targets.hpp"

namespace surefoot::fuzz {
namespace {

void read(const Target& target, const std::string& content) {
  EXPECT_NO_THROW(target.read({reinterpret_cast<const std::byte*>(content.data()), content.size()}))
      << target.name;
}

TEST(FuzzRegression, SeedsCutsAndChanges) {
  std::mt19937 random(1);
  for (const Target& target : targets()) {
    for (const std::string& seed : target.seeds()) {
      read(target, seed);
      for (std::size_t size = 0; size < seed.size(); size += 1 + seed.size() / 500) {
        read(target, seed.substr(0, size));
      }
      for (int i = 0; i < 2000; ++i) {
        std::string changed = seed;
        for (int change = 0; change <= i % 4; ++change) {
          changed[random() % changed.size()] = static_cast<char>(random() % 256);
        }
        read(target, changed);
      }
    }
  }
}

// What campaigns have found worth keeping, findings among it.
TEST(FuzzRegression, KeptCorpora) {
  namespace fs = std::filesystem;
  const fs::path kept = fs::path(SUREFOOT_SOURCE_DIR) / "tests" / "fuzz" / "corpus";
  int files = 0;
  for (const Target& target : targets()) {
    std::error_code none;  // of some targets nothing was worth keeping
    for (const fs::directory_entry& file : fs::directory_iterator(kept / target.name, none)) {
      std::ifstream stream(file.path(), std::ios::binary);
      read(target, {std::istreambuf_iterator<char>(stream), {}});
      ++files;
    }
  }
  EXPECT_GT(files, 0) << kept << ": moved or left out";
}

}  // namespace
}  // namespace surefoot::fuzz
