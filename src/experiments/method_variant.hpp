// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A method by name with some of its parameters changed: "paper+deskew.segments=8".
#pragma once

#include <string>
#include <vector>

#include "surefoot/config.hpp"

namespace surefoot::experiments {

struct MethodVariant {
  std::string label;                  ///< as it was written
  std::string method;                 ///< "paper"
  std::vector<std::string> settings;  ///< "deskew.segments=8"
};

/// Splits the text at every '+'. Whether there is such a method and such a parameter is seen by
/// variant_config(). Throws ConfigError.
[[nodiscard]] MethodVariant parse_variant(const std::string& text);
/// One variant for each text. Throws ConfigError, also for a variant that is named twice.
[[nodiscard]] std::vector<MethodVariant> parse_variants(const std::vector<std::string>& texts);

/// The variant's parameters: the method's, then `common` ("key=value"), then its own. Throws
/// ConfigError naming the variant.
[[nodiscard]] Config variant_config(const MethodVariant& variant,
                                    const std::vector<std::string>& common);

}  // namespace surefoot::experiments
