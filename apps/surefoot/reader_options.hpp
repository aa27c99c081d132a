// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The flags that say how a recording is to be read, for every command that reads one.
#pragma once

#include <CLI/App.hpp>

#include "io/recording.hpp"

namespace surefoot::app {

/// Adds the flags to a command; `options` must live until the command line is parsed.
void add_reader_options(CLI::App& command, io::OpenOptions& options);

}  // namespace surefoot::app
