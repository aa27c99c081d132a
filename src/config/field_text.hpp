// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Parameters as text, there and back.
#pragma once

#include <string>
#include <string_view>

#include "config/config_fields.hpp"

namespace surefoot {

/// The shortest text that reads back to the same number.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(int value);

/// "1 .. 64", or the words: "scan | map".
[[nodiscard]] std::string range_text(const ConfigField& field, Config& config);
[[nodiscard]] std::string value_text(const ConfigField& field, Config& config);
/// Throws ConfigError, and changes nothing, if the text is no value in the field's range.
void assign(const ConfigField& field, Config& config, std::string_view text);

}  // namespace surefoot
