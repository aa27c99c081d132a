// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One function a sub-command, one file each. A function adds its sub-command to the program and
// does the work in CLI11's callback; an exception becomes a message and exit code 2 in main(),
// `exit_code` is for work that finished and has something to tell (1: some of it failed).
#pragma once

#include <CLI/App.hpp>

namespace surefoot::app {

inline void add_commands(CLI::App& app, int& exit_code) {
  (void)app;
  (void)exit_code;
}

}  // namespace surefoot::app
