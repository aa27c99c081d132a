// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How the program ends, every sub-command alike.
#pragma once

namespace surefoot::process {

inline constexpr int kDone = 0;
inline constexpr int kSomeFailed = 1;     ///< done, but something failed that the output names
inline constexpr int kBadInput = 2;       ///< wrong usage, bad input, or what cannot be written
inline constexpr int kCannotStart = 127;  ///< a child process; what shells give
inline constexpr int kInterrupted = 130;  ///< by Ctrl-C or SIGTERM; what shells give

}  // namespace surefoot::process
