// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "evaluation/ablation.hpp"

namespace surefoot::experiments {

/// ablation.svg, .pdf and .png: a row for each change, a dot for each recording; the folder is
/// made. Throws std::runtime_error.
void draw_ablation(const evaluation::Ablation& ablation, const std::string& method,
                   const std::filesystem::path& folder);

}  // namespace surefoot::experiments
