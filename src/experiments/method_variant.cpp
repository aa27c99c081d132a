// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/method_variant.hpp"

#include <algorithm>

#include "runs/config_file.hpp"

namespace surefoot::experiments {

MethodVariant parse_variant(const std::string& text) {
  MethodVariant variant{text, text.substr(0, text.find('+')), {}};
  if (variant.method.empty()) {
    throw ConfigError("--methods: '" + text + "': expected METHOD or METHOD+key=value+key=value");
  }
  for (std::size_t plus = text.find('+'); plus != std::string::npos;) {
    const std::size_t next = text.find('+', plus + 1);
    const std::string setting = text.substr(plus + 1, next - plus - 1);
    if (setting.find('=') == std::string::npos) {
      throw ConfigError("--methods: '" + text + "': expected key=value after '+', not '" + setting +
                        "'");
    }
    variant.settings.push_back(setting);
    plus = next;
  }
  return variant;
}

std::vector<MethodVariant> parse_variants(const std::vector<std::string>& texts) {
  std::vector<MethodVariant> variants;
  for (const std::string& text : texts) {
    const bool known = std::any_of(variants.begin(), variants.end(),
                                   [&](const MethodVariant& v) { return v.label == text; });
    if (known) throw ConfigError("--methods: '" + text + "' is named twice");
    variants.push_back(parse_variant(text));
  }
  return variants;
}

Config variant_config(const MethodVariant& variant, const std::vector<std::string>& common) {
  try {
    Config config = method_config(variant.method);
    runs::apply_settings(common, config);
    runs::apply_settings(variant.settings, config);
    validate(config);
    return config;
  } catch (const ConfigError& error) {
    throw ConfigError("method '" + variant.label + "': " + error.what());
  }
}

}  // namespace surefoot::experiments
