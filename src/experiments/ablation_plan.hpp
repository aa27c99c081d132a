// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What `surefoot ablate` switches: each contribution of a method by itself.
#pragma once

#include <string>
#include <vector>

#include "evaluation/ablation.hpp"
#include "experiments/method_variant.hpp"

namespace surefoot::experiments {

/// The method as it is, harmless changes of it, then one change after the other.
struct AblationPlan {
  std::vector<MethodVariant> variants;
  std::vector<evaluation::AblationChange> changes;  ///< what each variant is
  std::size_t references = 0;                       ///< the method as it is and harmless changes
};

/// The methods that have contributions to switch.
[[nodiscard]] const std::vector<std::string>& ablated_methods();
/// Throws ConfigError naming the methods there are.
[[nodiscard]] AblationPlan ablation_plan(const std::string& method);

}  // namespace surefoot::experiments
