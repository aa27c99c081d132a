// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/check_text.hpp"

#include <fmt/format.h>

#include "io/decimal_time.hpp"
#include "text/printable.hpp"

namespace surefoot::checks {
namespace {

using io::format_seconds;

/// Rows of a name, so wide, and what there is to say.
class Rows {
 public:
  explicit Rows(int width) : width_(width) {}

  void add(const char* name, const std::string& value) {
    text_ += fmt::format("{:<{}} {}\n", name, width_, text::printable(value));
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  int width_;
  std::string text_;
};

std::string rings_text(const std::vector<std::uint16_t>& rings) {
  return fmt::format("{}, {} .. {}", rings.size(), rings.front(), rings.back());
}

/// Each of the three values as `shape` has it, such as "{:.3f}".
std::string spread_text(const io::Spread& spread, const std::string& shape) {
  return fmt::format(fmt::runtime("min " + shape + ", median " + shape + ", max " + shape),
                     spread.least, spread.median, spread.greatest);
}

void add_stamps(Rows& rows, const io::RecordingSummary& summary) {
  rows.add("stamps", fmt::format("{} .. {} s ({} s)", format_seconds(summary.first_stamp_ns),
                                 format_seconds(summary.last_stamp_ns),
                                 format_seconds(summary.last_stamp_ns - summary.first_stamp_ns)));
  if (summary.scans < 2) return;
  rows.add("rate", fmt::format("{:.3f} Hz", summary.rate_hz()));
  rows.add("interval", spread_text(summary.interval_s, "{:.6f}") + " s");
}

void add_scans(Rows& rows, const io::RecordingSummary& summary) {
  rows.add("points a scan", spread_text(summary.points, "{:.0f}"));
  add_stamps(rows, summary);
  if (summary.duration_s.greatest > 0.0) {
    rows.add("scan duration", spread_text(summary.duration_s, "{:.6f}") + " s");
  }
  rows.add("range", spread_text(summary.range_m, "{:.3f}") + " m");
  if (summary.has_intensities) rows.add("intensity", spread_text(summary.intensity, "{:g}"));
  if (!summary.rings.empty()) rows.add("rings", rings_text(summary.rings));
}

std::string packets_text(const io::CaptureCounts& counts) {
  return fmt::format(
      "{}: {} data, {} position, {} truncated, {} other, {} fragments of longer ones; {} "
      "reordered, {} lost",
      counts.packets, counts.data_packets, counts.position_packets, counts.truncated, counts.other,
      counts.fragments, counts.reordered, counts.lost);
}

void add_figures(Rows& rows, const Figures& figures) {
  if (figures.scans < 2) {
    rows.add("scans", std::to_string(figures.scans));
  } else {
    rows.add("scans", fmt::format("{} at {:.2f} Hz, {} s", figures.scans, figures.rate_hz(),
                                  format_seconds(figures.last_stamp_ns - figures.first_stamp_ns)));
    rows.add("intervals",
             fmt::format("{:.4f} to {:.4f} s, usually {:.4f} s", figures.interval_s.least,
                         figures.interval_s.greatest, figures.usual_interval_s));
  }
  rows.add("points",
           fmt::format("{:.0f} to {:.0f} a scan, usually {:.0f}; {:.1f} % NaN, {:.1f} % zero",
                       figures.points.least, figures.points.greatest, figures.points.median,
                       100.0 * figures.not_finite_share, 100.0 * figures.zero_share));
  rows.add("ranges",
           fmt::format("{:.2f} to {:.2f} m, {:.2f} m in the middle", figures.range_m.least,
                       figures.range_m.greatest, figures.range_m.median));
  rows.add("directions", fmt::format("{:.0f} % of those around", 100.0 * figures.around.median));
  if (!figures.rings.empty()) rows.add("rings", rings_text(figures.rings));
}

std::string finding_text(const Finding& finding) {
  std::string text = finding.what;
  if (finding.scans > 0) text += fmt::format(": {} (first: {})", finding.scans, finding.first);
  if (!finding.detail.empty()) text += (finding.scans > 0 ? "; " : ": ") + finding.detail;
  return text;
}

void add_topics(Rows& rows, const std::vector<io::TopicSurvey>& topics) {
  for (const io::TopicSurvey& survey : topics) {
    std::string text = survey.topic.name + "  " + survey.topic.type;
    if (survey.rate_hz() > 0.0) text += fmt::format("  {:.1f} Hz", survey.rate_hz());
    if (!survey.frame.empty()) text += "  frame " + survey.frame;
    if (!survey.content.empty()) text += "  " + survey.content;
    rows.add("topic", text);
  }
}

}  // namespace

std::string to_text(const std::vector<io::TopicSurvey>& topics) {
  Rows rows(14);
  add_topics(rows, topics);
  for (const io::TopicSurvey& survey : topics) {
    if (survey.usable) rows.add("scans by", "--topic " + text::shell_word(survey.topic.name));
  }
  return rows.text();
}

std::string to_text(const io::RecordingSummary& summary,
                    const std::vector<io::TopicSurvey>& topics) {
  Rows rows(14);
  rows.add("recording", summary.description);
  for (const std::string& layout : summary.layouts) rows.add("fields", layout);
  rows.add("scans", std::to_string(summary.scans));
  if (summary.scans > 0) add_scans(rows, summary);
  if (summary.capture.packets > 0) rows.add("packets", packets_text(summary.capture));
  add_topics(rows, topics);
  for (const std::string& note : summary.notes) rows.add("found out", note);
  for (const io::Oddity& oddity : summary.oddities) {
    const bool of_scans = !oddity.first.empty();
    rows.add("odd", of_scans
                        ? fmt::format("{}: {} (first: {})", oddity.what, oddity.scans, oddity.first)
                        : oddity.what);
  }
  return rows.text();
}

std::string to_text(const RecordingCheck& check) {
  Rows rows(12);
  rows.add("recording", check.description);
  for (const std::string& layout : check.layouts) rows.add("fields", layout);
  if (check.figures.scans > 0) add_figures(rows, check.figures);
  for (const std::string& note : check.notes) rows.add("found out", note);
  for (const std::string& sentence : check.time_sentences) rows.add("times", sentence);
  for (const std::string& sentence : check.motion_sentences) rows.add("motion", sentence);
  for (const Finding& finding : check.findings) {
    rows.add(finding.suffers ? "suffers" : "odd", finding_text(finding));
  }
  rows.add("verdict", check.verdict());
  return rows.text();
}

}  // namespace surefoot::checks
