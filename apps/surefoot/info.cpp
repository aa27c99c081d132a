// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot info: what a recording holds and what is odd about it.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "io/decimal_time.hpp"
#include "io/printable.hpp"
#include "io/recording.hpp"
#include "io/recording_summary.hpp"
#include "process/exit_codes.hpp"
#include "reader_options.hpp"
#include "runs/length_unit.hpp"

namespace surefoot::app {
namespace {

using io::format_seconds;
using io::RecordingSummary;
using io::Spread;

struct InfoOptions {
  std::filesystem::path input;
  io::OpenOptions reader;
  bool json = false;
};

nlohmann::ordered_json to_json(const Spread& spread) {
  return {{"min", spread.least}, {"median", spread.median}, {"max", spread.greatest}};
}

nlohmann::ordered_json to_json(const RecordingSummary& summary) {
  nlohmann::ordered_json json;
  json["description"] = summary.description;
  json["notes"] = summary.notes;
  json["fields"] = summary.layouts;
  json["scans"] = summary.scans;
  json["unreadable"] = summary.unreadable;
  json["points_per_scan"] = to_json(summary.points);
  // As text: a JSON number is a double, which does not hold an epoch time to the nanosecond.
  json["first_stamp"] = format_seconds(summary.first_stamp_ns);
  json["last_stamp"] = format_seconds(summary.last_stamp_ns);
  json["rate_hz"] = summary.rate_hz();
  json["interval_s"] = to_json(summary.interval_s);
  json["scan_duration_s"] = to_json(summary.duration_s);
  json["range_m"] = to_json(summary.range_m);
  if (summary.has_intensities) {
    json["intensity"] = to_json(summary.intensity);
  }
  json["rings"] = summary.rings;
  const io::CaptureCounts& counts = summary.capture;
  if (counts.packets > 0) {
    json["packets"] = {{"all", counts.packets},
                       {"data", counts.data_packets},
                       {"position", counts.position_packets},
                       {"truncated", counts.truncated},
                       {"other", counts.other},
                       {"fragments", counts.fragments},
                       {"lost", counts.lost}};
  }
  json["odd"] = nlohmann::ordered_json::array();
  for (const io::Oddity& oddity : summary.oddities) {
    json["odd"].push_back(
        {{"what", oddity.what}, {"scans", oddity.scans}, {"first", oddity.first}});
  }
  return json;
}

void print_row(const char* name, const std::string& value) {
  std::printf("%-14s %s\n", name, io::printable(value).c_str());
}

std::string text_of(const Spread& spread, const char* format) {
  char text[160];
  const std::string shape = std::string("min ") + format + ", median " + format + ", max " + format;
  std::snprintf(text, sizeof(text), shape.c_str(), spread.least, spread.median, spread.greatest);
  return text;
}

void print_stamps(const RecordingSummary& summary) {
  print_row("stamps", format_seconds(summary.first_stamp_ns) + " .. " +
                          format_seconds(summary.last_stamp_ns) + " s (" +
                          format_seconds(summary.last_stamp_ns - summary.first_stamp_ns) + " s)");
  if (summary.scans > 1) {
    char rate[40];
    std::snprintf(rate, sizeof(rate), "%.3f Hz", summary.rate_hz());
    print_row("rate", rate);
    print_row("interval", text_of(summary.interval_s, "%.6f") + " s");
  }
}

void print_counts(const io::CaptureCounts& counts) {
  print_row("packets", std::to_string(counts.packets) + ": " + std::to_string(counts.data_packets) +
                           " data, " + std::to_string(counts.position_packets) + " position, " +
                           std::to_string(counts.truncated) + " truncated, " +
                           std::to_string(counts.other) + " other, " +
                           std::to_string(counts.fragments) + " fragments of longer ones; " +
                           std::to_string(counts.lost) + " lost");
}

void print(const RecordingSummary& summary) {
  print_row("recording", summary.description);
  for (const std::string& layout : summary.layouts) {
    print_row("fields", layout);
  }
  print_row("scans", std::to_string(summary.scans));
  if (summary.scans > 0) {
    print_row("points a scan", text_of(summary.points, "%.0f"));
    print_stamps(summary);
    if (summary.duration_s.greatest > 0.0) {
      print_row("scan duration", text_of(summary.duration_s, "%.6f") + " s");
    }
    print_row("range", text_of(summary.range_m, "%.3f") + " m");
    if (summary.has_intensities) {
      print_row("intensity", text_of(summary.intensity, "%g"));
    }
    if (!summary.rings.empty()) {
      print_row("rings", std::to_string(summary.rings.size()) + ", " +
                             std::to_string(summary.rings.front()) + " .. " +
                             std::to_string(summary.rings.back()));
    }
  }
  if (summary.capture.packets > 0) {
    print_counts(summary.capture);
  }
  for (const std::string& note : summary.notes) {
    print_row("found out", note);
  }
  for (const io::Oddity& oddity : summary.oddities) {
    print_row("odd", oddity.first.empty() ? oddity.what
                                          : oddity.what + ": " + std::to_string(oddity.scans) +
                                                " (first: " + oddity.first + ")");
  }
}

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a recording holds and what is odd");
  command->add_option("input", options->input, "Folder of scans, one scan, a bag, or a capture")
      ->required();
  command->add_flag("--json", options->json, "Print JSON");
  add_reader_options(*command, options->reader);
  command->callback([options, &exit_code] {
    options->reader.repair_stamps = false;  // what is odd is told, not mended
    const auto recording = io::open_recording(options->input, options->reader);
    RecordingSummary summary = io::summarise(*recording);
    if (const auto odd = runs::odd_range(summary.range_m.median)) {
      summary.oddities.push_back({*odd, summary.scans, ""});
    }
    if (options->json) {
      using ErrorHandler = nlohmann::ordered_json::error_handler_t;
      // File names may hold any bytes.
      std::printf("%s\n", to_json(summary).dump(2, ' ', false, ErrorHandler::replace).c_str());
    } else {
      print(summary);
    }
    exit_code = summary.unreadable > 0 ? process::kSomeFailed : process::kDone;
  });
}

}  // namespace surefoot::app
