// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/check_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string_view>

#include "io/file_writer.hpp"
#include "report/page.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::checks {
namespace {

using report::html_text;

// What every page of check's begins with, and no other page.
constexpr std::string_view kMark = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="generator" content="surefoot check">)";

constexpr const char* kHead = R"(<meta name="viewport" content="width=device-width">
<title>{}</title><style>
:root {{ color-scheme: light dark; --line: #8884; --dot: #1f6fb2; --bad: #c0392b; --good: #1e8449; }}
@media (prefers-color-scheme: dark) {{ :root {{ --dot: #6db3f2; --bad: #ff7b6b; --good: #58d68d; }} }}
body {{ font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }}
h1 {{ font-size: 1.4rem; }} h2 {{ font-size: 1.05rem; margin: 1.6rem 0 .3rem; }}
.verdict {{ font-size: 1.2rem; font-weight: 600; }}
.bad {{ color: var(--bad); }} .good {{ color: var(--good); }}
table {{ border-collapse: collapse; }} td, th {{ padding: .2rem .8rem .2rem 0; text-align: left;
vertical-align: top; border-bottom: 1px solid var(--line); }}
td:last-child {{ min-width: 5rem; overflow-wrap: anywhere; }}
svg {{ width: 100%; display: block; overflow: visible; }}
svg.chart {{ width: calc(100% - 80px); margin-left: 70px; }}
svg text {{ font: 12px system-ui, sans-serif; fill: currentColor; }}
svg line {{ stroke: var(--line); }} svg circle {{ fill: var(--dot); }}
svg circle.odd {{ fill: var(--bad); }} svg rect {{ fill: var(--dot); }}
svg rect.best {{ fill: var(--good); }}
</style></head><body>
)";

// Scans that are drawn at most: one of each bin's most unusual ones would do as well, a page of a
// hundred megabytes would not.
constexpr std::size_t kMostDots = 2000;
// [px]; across, shares of the page's width, so that text is as large on a telephone.
constexpr double kHeight = 130.0, kTop = 8.0, kBottom = 22.0;

struct Dot {
  double at = 0.0;  // number of the scan
  double value = 0.0;
  bool odd = false;
};

struct Chart {
  const char* title;
  const char* unit;
  std::vector<Dot> dots;
};

// The odd ones, and of the others as many as there is room for.
std::vector<Dot> drawn(std::vector<Dot> dots) {
  const std::size_t step = dots.size() / kMostDots + 1;
  std::size_t index = 0, odd = 0;
  std::erase_if(dots, [&](const Dot& dot) {
    if (!std::isfinite(dot.value)) return true;
    const bool keep = index++ % step == 0 || (dot.odd && odd++ < kMostDots);
    return !keep;
  });
  return dots;
}

// Four digits; a whole number as it is.
std::string short_number(double value) {
  constexpr double kMostWhole = 1e7;
  const bool whole = std::abs(value) >= 1000.0 && std::abs(value) < kMostWhole;
  return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

std::string chart_of(const Chart& chart, std::size_t scans) {
  const std::vector<Dot> dots = drawn(chart.dots);
  if (dots.empty()) return {};
  const auto [low, high] = std::minmax_element(
      dots.begin(), dots.end(), [](const Dot& a, const Dot& b) { return a.value < b.value; });
  const double least = std::min(0.0, low->value);
  const double greatest = high->value > least ? high->value : least + 1.0;
  const auto x = [&](double at) { return 100.0 * at / std::max(1.0, double(scans) - 1.0); };
  const auto y = [&](double value) {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * (value - least) / (greatest - least);
  };
  std::string svg = fmt::format(
      "<h2>{0}</h2>\n<svg class=\"chart\" height=\"{1}\" role=\"img\" aria-label=\"{0}\">\n",
      chart.title, kHeight);
  for (const double value : {least, greatest}) {
    svg += fmt::format(
        "<line x2=\"100%\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/><text x=\"-6\" y=\"{1:.1f}\" "
        "text-anchor=\"end\">{2}{3}</text>\n",
        y(value), y(value) + 4, short_number(value), chart.unit);
  }
  svg += fmt::format("<text y=\"{}\">scan 0</text>\n", kHeight - 4);
  if (scans > 1) {
    svg += fmt::format("<text x=\"100%\" y=\"{}\" text-anchor=\"end\">{}</text>\n", kHeight - 4,
                       scans - 1);
  }
  for (const Dot& dot : dots) {
    svg += fmt::format("<circle cx=\"{:.2f}%\" cy=\"{:.1f}\" r=\"{}\"{}/>", x(dot.at), y(dot.value),
                       dot.odd ? 3 : 1.6, dot.odd ? " class=\"odd\"" : "");
  }
  return svg + "\n</svg>\n";
}

using Value = std::function<double(const ScanFacts&)>;
using Odd = std::function<bool(const ScanFacts&)>;

Chart chart_from(const RecordingCheck& check, const char* title, const char* unit,
                 const Value& value, const Odd& odd) {
  Chart chart{title, unit, {}};
  for (std::size_t i = 0; i < check.scans.size(); ++i) {
    const ScanFacts& scan = check.scans[i];
    if (scan.error.empty()) chart.dots.push_back({double(i), value(scan), odd(scan)});
  }
  return chart;
}

Chart interval_chart(const RecordingCheck& check) {
  Chart chart{"Time since the scan before", " s", {}};
  const ScanFacts* last = nullptr;
  const double usual = check.figures.usual_interval_s;
  for (std::size_t i = 0; i < check.scans.size(); ++i) {
    const ScanFacts& scan = check.scans[i];
    if (!scan.error.empty()) continue;
    if (last != nullptr) {
      const double step = seconds(scan.stamp_ns - last->stamp_ns);
      chart.dots.push_back({double(i), step, step <= 0.0 || step > 1.5 * usual});
    }
    last = &scan;
  }
  return chart;
}

std::string charts(const RecordingCheck& check) {
  if (check.scans.empty()) return {};
  const auto never = [](const ScanFacts&) { return false; };
  const double usual = check.figures.returns.median;
  std::string html;
  const auto add = [&](const Chart& chart) { html += chart_of(chart, check.scans.size()); };
  add(interval_chart(check));
  add(chart_from(
      check, "Returns", "", [](const ScanFacts& s) { return double(s.returns); },
      [usual](const ScanFacts& s) { return double(s.returns) < 0.5 * usual; }));
  add(chart_from(
      check, "Points that are NaN, infinite or zero", " %",
      [](const ScanFacts& s) {
        return s.points == 0 ? 0.0 : 100.0 * double(s.not_finite + s.zero) / double(s.points);
      },
      never));
  add(chart_from(
      check, "How long a sweep lasts", " s",
      [](const ScanFacts& s) { return s.last_s - s.first_s; }, never));
  add(chart_from(
      check, "Range of the middle return", " m", [](const ScanFacts& s) { return s.middle; },
      never));
  add(chart_from(
      check, "Directions around with returns", " %",
      [](const ScanFacts& s) { return 100.0 * s.seen_around; }, never));
  add(chart_from(
      check, "Turned since the scan before, roughly", " deg",
      [](const ScanFacts& s) { return s.turned_deg; }, never));
  return html;
}

std::string trials(const MotionCheck& motion) {
  const std::vector<TimeTrial>& all = motion.trials.trials;
  double greatest = 0.0;
  for (const TimeTrial& trial : all) greatest = std::max(greatest, trial.middle_blur);
  if (!(greatest > 0.0)) return {};
  constexpr double kRow = 40.0;
  const char* title = "How blurred the map is, by how the point times are read";
  std::string svg =
      fmt::format("<h2>{0}</h2>\n<svg height=\"{1}\" role=\"img\" aria-label=\"{0}\">\n", title,
                  kRow * double(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double top = kRow * double(i);
    svg += fmt::format(
        "<text y=\"{}\">{}: {:.1f} mm</text><rect y=\"{}\" width=\"{:.1f}%\" height=\"14\"{}/>\n",
        top + 14, name_of(all[i].reading), 1e3 * all[i].middle_blur, top + 19,
        100.0 * all[i].middle_blur / greatest,
        motion.trials.decided && i == motion.trials.preferred ? " class=\"best\"" : "");
  }
  return svg + "</svg>\n";
}

std::string findings_table(const std::vector<Finding>& findings) {
  if (findings.empty()) return "<p>Nothing odd was found.</p>\n";
  std::string html = "<table><tr><th></th><th>what</th><th>scans</th><th>first</th></tr>\n";
  for (const Finding& finding : findings) {
    html += fmt::format(
        "<tr><td class=\"{}\">{}</td><td>{}{}{}</td><td>{}</td><td>{}</td></tr>\n",
        finding.suffers ? "bad" : "", finding.suffers ? "suffers" : "odd", html_text(finding.what),
        finding.detail.empty() ? "" : ": ", html_text(finding.detail),
        finding.scans > 0 ? std::to_string(finding.scans) : "", html_text(finding.first));
  }
  return html + "</table>\n";
}

std::string numbers(const Figures& figures) {
  std::string text = fmt::format("{} scan{}", figures.scans, figures.scans == 1 ? "" : "s");
  if (figures.rate_hz() > 0.0) text += fmt::format(" at {:.2f} Hz", figures.rate_hz());
  text +=
      fmt::format(", {:.0f} points{}", figures.points.median, figures.scans == 1 ? "" : " each");
  if (!figures.rings.empty()) text += fmt::format(", {} rings", figures.rings.size());
  return text;
}

std::string list(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string html = "<ul>\n";
  for (const std::string& sentence : sentences) html += "<li>" + html_text(sentence) + "</li>\n";
  return html + "</ul>\n";
}

}  // namespace

std::string to_html(const RecordingCheck& check, const std::string& name) {
  const Figures& figures = check.figures;
  const std::string title = html_text(name);
  std::string html = std::string(kMark) + fmt::format(kHead, title);
  html += fmt::format("<h1>{}</h1>\n<p class=\"verdict {}\">{}</p>\n", title,
                      check.suffers() ? "bad" : "good", html_text(check.verdict()));
  html += "<p>" + html_text(check.description) + ": " + numbers(figures) + ".</p>\n";
  html += findings_table(check.findings);
  html += "<h2>Times</h2>\n" + list(check.time_sentences) + list(check.motion_sentences) +
          list(check.notes);
  if (check.motion) html += trials(*check.motion);
  return html + charts(check) + "</body></html>\n";
}

void require_page_or_nothing(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  if (file.empty()) return;
  if (const fs::path folder = fs::absolute(file).parent_path(); !fs::is_directory(folder)) {
    throw std::invalid_argument("--html " + file.string() + ": there is no folder " +
                                folder.string());
  }
  if (!fs::exists(fs::symlink_status(file))) return;
  if (io::is_file_beginning(file, kMark)) return;
  throw std::invalid_argument("--html " + file.string() +
                              ": is there already and is no page of check's; choose another name");
}

}  // namespace surefoot::checks
