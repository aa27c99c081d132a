// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "surefoot/estimate.hpp"

namespace surefoot {

std::string_view to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::first_scan:
      return "first_scan";
    case Status::degenerate:
      return "degenerate";
    case Status::too_few_matches:
      return "too_few_matches";
    case Status::diverged:
      return "diverged";
    case Status::lost:
      return "lost";
    case Status::rejected:
      return "rejected";
  }
  return "unknown";
}

}  // namespace surefoot
