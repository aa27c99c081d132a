// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The words for the choices of an evaluation: the program's flags take them, its files tell them.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "evaluation/alignment.hpp"
#include "evaluation/association.hpp"
#include "evaluation/rpe.hpp"

namespace surefoot::evaluation {

template <typename Choice, std::size_t count>
using ChoiceNames = std::array<std::pair<std::string_view, Choice>, count>;

inline constexpr ChoiceNames<AlignmentMethod, 7> kAlignmentNames = {
    {{"none", AlignmentMethod::none},
     {"origin", AlignmentMethod::origin},
     {"yaw", AlignmentMethod::yaw_translation},
     {"se3", AlignmentMethod::rigid},
     {"poses", AlignmentMethod::poses},
     {"sim3", AlignmentMethod::similarity},
     {"scale", AlignmentMethod::scale}}};

/// The pairings of stamped poses; index follows from files without stamps.
inline constexpr ChoiceNames<AssociationMethod, 2> kPairingNames = {
    {{"nearest", AssociationMethod::nearest}, {"interpolate", AssociationMethod::interpolate}}};

inline constexpr ChoiceNames<DeltaUnit, 4> kDeltaUnitNames = {{{"frames", DeltaUnit::frames},
                                                               {"m", DeltaUnit::metres},
                                                               {"s", DeltaUnit::seconds},
                                                               {"deg", DeltaUnit::degrees}}};

/// The word for a choice; "" for one that has none.
template <typename Choice, std::size_t count>
[[nodiscard]] constexpr std::string_view name_of(const ChoiceNames<Choice, count>& names,
                                                 Choice choice) {
  for (const auto& [name, value] : names) {
    if (value == choice) return name;
  }
  return "";
}

}  // namespace surefoot::evaluation
