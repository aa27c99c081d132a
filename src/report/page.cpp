// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/page.hpp"

#include <stdexcept>

namespace surefoot::report {

std::string html_text(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      default:
        html += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return html;
}

std::string make_page(std::string_view page_template, std::string_view title,
                      std::string_view json) {
  const std::size_t data = page_template.find(kDataPlaceholder);
  if (data == std::string_view::npos || page_template.rfind(kDataPlaceholder) != data) {
    throw std::invalid_argument("the report's page has not exactly one place for the data");
  }
  std::string page(page_template.substr(0, data));
  if (const std::size_t at = page.find(kTitlePlaceholder); at != std::string::npos) {
    page.replace(at, kTitlePlaceholder.size(), html_text(title));
  }
  page.append(json);
  return page.append(page_template.substr(data + kDataPlaceholder.size()));
}

}  // namespace surefoot::report
