// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot::process {

/// Call it first of all. Afterwards no file that is opened takes the place of a closed standard
/// stream, and to write to the standard error never fails: where nobody can read a message, it is
/// no reason to end a run, be it a closed one or a pipe whose reader has gone. What cannot be
/// printed to the standard output is an error still, and so is a file that may not grow.
void guard_standard_streams();

/// Ends the process as one whose reader has gone (`surefoot ... | head`) ends unguarded: quietly,
/// by SIGPIPE.
[[noreturn]] void end_without_reader();

}  // namespace surefoot::process
