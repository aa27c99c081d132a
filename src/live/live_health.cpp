// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/live_health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "surefoot/quantile.hpp"

namespace surefoot::live {
namespace {

std::string latency_text(const LiveFigures& figures) {
  const std::vector<double>& latencies = figures.latencies_ms;
  if (latencies.empty()) return "no scan was used";
  return fmt::format("from last packet to pose {:.1f} ms median, {:.1f} ms p99, {:.1f} ms at most",
                     quantile(latencies, 0.5), quantile(latencies, 0.99),
                     *std::max_element(latencies.begin(), latencies.end()));
}

constexpr double kLongestSilence = 1.0;  // [s]: ten revolutions of most sensors

void judge(const LiveFigures& figures, io::Diagnostic& diagnostic) {
  using Level = io::Diagnostic::Level;
  if (figures.silent_s > kLongestSilence) {
    diagnostic.level = Level::error;
    diagnostic.message = fmt::format("no scan for {:.0f} s; ", figures.silent_s);
  } else if (figures.is_paused) {
    diagnostic.level = Level::warn;
    diagnostic.message = "paused; ";
  } else if (figures.dropped > 0) {
    diagnostic.level = Level::warn;
  }
  diagnostic.message += state_text(figures);
}

}  // namespace

std::string state_text(const LiveFigures& figures) {
  const std::string paused =
      figures.paused > 0 ? fmt::format(", {} paused", figures.paused) : std::string();
  return fmt::format("{} scans, {} dropped{}; {}", figures.used, figures.dropped, paused,
                     latency_text(figures));
}

io::Diagnostic health_of(const LiveFigures& figures, std::int64_t stamp_ns) {
  io::Diagnostic diagnostic;
  diagnostic.stamp_ns = stamp_ns;
  diagnostic.name = "surefoot: live";
  judge(figures, diagnostic);
  const auto add = [&](const char* key, auto value) {
    diagnostic.values.emplace_back(key, fmt::format("{}", value));
  };
  add("scans used", figures.used);
  add("scans dropped", figures.dropped);
  add("received", figures.received);
  add("lost before they were received", figures.lost);
  constexpr std::array<std::pair<const char*, double>, 3> kShares = {
      {{"latency p50 [ms]", 0.5}, {"latency p99 [ms]", 0.99}, {"latency max [ms]", 1.0}}};
  for (const auto& [key, share] : kShares) {
    if (!figures.latencies_ms.empty()) add(key, quantile(figures.latencies_ms, share));
  }
  return diagnostic;
}

HealthPublisher::HealthPublisher(std::shared_ptr<io::BagWriter> messages)
    : messages_(std::move(messages)),
      topic_(messages_->add_topic("/diagnostics", io::diagnostics_definition())) {}

void HealthPublisher::tell(const LiveFigures& figures) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kPeriod = std::chrono::seconds(1);
  if (Clock::now() - told_ < kPeriod) return;
  told_ = Clock::now();
  const std::int64_t now_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                                  std::chrono::system_clock::now().time_since_epoch())
                                  .count();
  const io::Diagnostic diagnostic = health_of(figures, now_ns);
  messages_->write(topic_, diagnostic.stamp_ns,
                   io::format_diagnostic(diagnostic, messages_->flavour()));
}

}  // namespace surefoot::live
