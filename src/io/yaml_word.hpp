// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace surefoot::io {

/// A text as YAML has it: in quotes, unless it can only be read as a text, as ROS's names and most
/// files' are.
[[nodiscard]] std::string yaml_word(std::string_view text);

}  // namespace surefoot::io
