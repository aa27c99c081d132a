// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "config/method.hpp"

namespace surefoot::test {

/// A method's own parameters as the table has them.
template <typename Parameters>
Parameters default_parameters() {
  return own_parameters<Parameters>(Config());
}

}  // namespace surefoot::test
