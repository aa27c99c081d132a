// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The project's own files as text, for tests that read them.
#pragma once

#include <string>
#include <vector>

namespace surefoot::test {

struct SourceFile {
  std::string path;  ///< from the project's root, with slashes: "src/odometry/deskew.cpp"
  std::string text;
};

/// The C++ sources and headers below a folder of the project, ordered by path.
[[nodiscard]] std::vector<SourceFile> source_files(const std::string& folder);
/// Text of a file of the project; empty if there is none.
[[nodiscard]] std::string read_project_file(const std::string& path);
/// What a file includes in quotes.
[[nodiscard]] std::vector<std::string> quoted_includes(const std::string& text);

}  // namespace surefoot::test
