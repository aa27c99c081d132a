// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace surefoot::command_line {

/// The known word that is most like it; empty: none has much in common with it.
[[nodiscard]] std::string nearest_word(const std::string& word,
                                       const std::vector<std::string>& known);

/// "no subcommand is called 'runn'; did you mean 'run'? There are: run, info", for `kind`
/// "subcommand". Nothing is suggested that has little in common with the word.
[[nodiscard]] std::string unknown_word(const std::string& kind, const std::string& word,
                                       const std::vector<std::string>& known);

}  // namespace surefoot::command_line
