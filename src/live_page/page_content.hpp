// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace surefoot::live_page {

/// The page, as web/ is bundled to.
[[nodiscard]] std::string_view page_content();

}  // namespace surefoot::live_page
