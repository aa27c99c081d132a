// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/message_source.hpp"

#include <algorithm>

namespace surefoot::io {

void MessageSource::note(std::string_view text) {
  constexpr std::size_t kMostNotes = 20;
  if (notes_.size() < kMostNotes) notes_.emplace_back(text);
}

std::string plain_type_name(std::string_view name) {
  std::string plain;
  while (!name.empty()) {  // its parts, but "msg" and "dds_"
    const std::size_t end = std::min(name.find_first_of("/:"), name.size());
    const std::string_view part = name.substr(0, end);
    if (!part.empty() && part != "msg" && part != "dds_") {
      if (!plain.empty()) plain.push_back('/');
      plain.append(part);
    }
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  if (plain.ends_with('_')) plain.pop_back();  // DDS has it behind the names of types
  return plain;
}

}  // namespace surefoot::io
