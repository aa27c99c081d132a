// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The one table of parameters: name, place in Config, default, unit, range, help, source.
#pragma once

#include <span>
#include <variant>

#include "surefoot/config.hpp"

namespace surefoot {

/// Where a parameter lives in a Config.
using FieldSlot =
    std::variant<double*, int*, bool*, DeskewMode*, RegistrationMode*, Residual*, TargetKind*,
                 LevelMode*, IcpTarget*, CtIcpSampling*, CtIcpInitialization*>;

struct ConfigField {
  const char* name;
  FieldSlot (*slot)(Config&);
  const char* default_value;
  const char* unit;
  double min, max;  // numbers only
  const char* help;
  const char* source;
};

[[nodiscard]] std::span<const ConfigField> config_fields();

}  // namespace surefoot
