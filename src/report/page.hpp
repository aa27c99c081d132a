// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The report as one HTML file.
#pragma once

#include <string>
#include <string_view>

namespace surefoot::report {

/// Where the data go in the page that web/ is bundled to, and where its title does.
inline constexpr std::string_view kDataPlaceholder = "{{surefoot-report-data}}";
inline constexpr std::string_view kTitlePlaceholder = "{{surefoot-report-title}}";

/// The page without data; empty in a program that was built without the page.
[[nodiscard]] std::string_view page_template();

/// A page that shows the tileset.json beside it; empty as above.
[[nodiscard]] std::string_view tiles_page();

/// Text as HTML shows it, whatever characters it has.
[[nodiscard]] std::string html_text(std::string_view text);

/// The page with `json` (of to_json()) and the title in it. Throws std::invalid_argument if the
/// template has not exactly one place for the data.
[[nodiscard]] std::string make_page(std::string_view page_template, std::string_view title,
                                    std::string_view json);

}  // namespace surefoot::report
