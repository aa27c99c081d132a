// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "commands.hpp"

namespace {
// Exit codes: 0 done, 1 done but with failures that the output names, 2 wrong usage or bad input.
constexpr int kBadInput = 2;
}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Surefoot: LiDAR odometry for robots that walk"};
  app.require_subcommand(1);
  int exit_code = 0;
  surefoot::app::add_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surefoot: %s\n", error.what());
    return kBadInput;
  }
  return exit_code;
}
