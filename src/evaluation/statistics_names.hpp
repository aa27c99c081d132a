// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The names under which all outputs tell the statistics, in their order.
#pragma once

#include <array>
#include <utility>

#include "evaluation/statistics.hpp"

namespace surefoot::evaluation {

using StatisticName = std::pair<const char*, double Statistics::*>;
inline constexpr std::array<StatisticName, 7> kStatisticsNames = {{{"max", &Statistics::max},
                                                                   {"mean", &Statistics::mean},
                                                                   {"median", &Statistics::median},
                                                                   {"min", &Statistics::min},
                                                                   {"rmse", &Statistics::rmse},
                                                                   {"std", &Statistics::std},
                                                                   {"sse", &Statistics::sse}}};
// The figures of the tables that papers print.
inline constexpr std::array<StatisticName, 4> kPaperStatistics = {{{"Maximum", &Statistics::max},
                                                                   {"Mean", &Statistics::mean},
                                                                   {"RMSE", &Statistics::rmse},
                                                                   {"std", &Statistics::std}}};

}  // namespace surefoot::evaluation
