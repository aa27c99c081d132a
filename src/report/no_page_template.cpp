// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Takes the place of the bundled pages where there is no Node.js to bundle them with.
#include "report/page.hpp"

namespace surefoot::report {

std::string_view page_template() { return {}; }
std::string_view tiles_page() { return {}; }

}  // namespace surefoot::report
