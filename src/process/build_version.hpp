// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot::process {

/// Of this program: its release, and in a checkout the commit, "0.1.0+7234c20"
/// (cmake/build_version.cmake).
const char* build_version();

}  // namespace surefoot::process
