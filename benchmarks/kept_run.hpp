// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The command line of a benchmark whose results are kept beside the command that made them.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>

namespace surefoot::benchmarks {

/// Parses and runs; the command is handed on as it was given. Returns 0, or 2 for bad input.
inline int run_kept(CLI::App& app, int argc, char** argv, const std::string& name,
                    const std::function<void(const std::string& command)>& run) {
  std::string command = "build/release/benchmarks/" + name;
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  try {
    app.parse(argc, argv);
    run(command);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 2;
  }
}

}  // namespace surefoot::benchmarks
