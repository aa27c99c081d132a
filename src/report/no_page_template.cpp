// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Takes the place of the bundled page where there is no Node.js to bundle it with.
#include "report/page.hpp"

namespace surefoot::report {

std::string_view page_template() { return {}; }

}  // namespace surefoot::report
