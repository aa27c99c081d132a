// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The one list of methods: a new one is declared here and named in registry.cpp.
#pragma once

namespace surefoot {

struct Method;

[[nodiscard]] const Method& knots_method();  ///< Surefoot's own, the default
[[nodiscard]] const Method& paper_method();

// The systems to compare with.
[[nodiscard]] const Method& kiss_icp_method();
[[nodiscard]] const Method& icp_method();
[[nodiscard]] const Method& genz_icp_method();
[[nodiscard]] const Method& floam_method();
[[nodiscard]] const Method& ct_icp_method();

}  // namespace surefoot
