// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "process.hpp"

namespace surefoot::test {

/// That these files are there in both runs' folders, and the same byte for byte.
inline void expect_same_files(const std::filesystem::path& a, const std::filesystem::path& b,
                              const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    EXPECT_FALSE(file_content(a / file).empty()) << a / file;
    EXPECT_EQ(file_content(a / file), file_content(b / file)) << file;
  }
}

}  // namespace surefoot::test
