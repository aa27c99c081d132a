// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "reader_options.hpp"

#include <CLI/CLI.hpp>
#include <limits>
#include <map>
#include <string>

namespace surefoot::app {
namespace {

using dataset::OpenOptions;
using dataset::ReturnChoice;
using dataset::StampAt;
using dataset::TimeReference;
using dataset::TimeUnit;

constexpr const char* kGroup = "Reading";

// An option whose values are words.
template <typename Choice>
void add_choice(CLI::App& command, const char* flag, Choice& choice, const char* help,
                const std::map<std::string, Choice>& words) {
  command.add_option(flag, choice, help)
      ->transform(CLI::CheckedTransformer(words).description(""))
      ->option_text([&words] {
        std::string text;
        for (const auto& [word, value] : words) {
          text += (text.empty() ? "" : "|") + word;
        }
        return text;
      }())
      ->group(kGroup);
}

void add_time_options(CLI::App& command, OpenOptions& options) {
  command
      .add_option("--time-field", options.time_field,
                  "Field of the point times (found by its name)")
      ->group(kGroup);
  add_choice<TimeUnit>(command, "--time-unit", options.time_unit,
                       "Unit of the point times (found from the values)",
                       {{"auto", TimeUnit::kAuto},
                        {"s", TimeUnit::kSeconds},
                        {"ms", TimeUnit::kMilliseconds},
                        {"us", TimeUnit::kMicroseconds},
                        {"ns", TimeUnit::kNanoseconds}});
  add_choice<TimeReference>(command, "--time-reference", options.time_reference,
                            "Whether point times count from the stamp or from the epoch",
                            {{"auto", TimeReference::kAuto},
                             {"relative", TimeReference::kRelative},
                             {"absolute", TimeReference::kAbsolute}});
  add_choice<StampAt>(command, "--stamp-at", options.stamp_at,
                      "Instant of a scan that its stamp names",
                      {{"start", StampAt::kStart}, {"end", StampAt::kEnd}});
  command
      .add_option("--stamps", options.stamps_file,
                  "File of stamps, one a scan (times.txt beside the scans)")
      ->group(kGroup);
  command.add_option("--rate", options.rate_hz, "Scans a second where nothing gives stamps [Hz]")
      ->check(CLI::Range(1e-3, 1e4))
      ->group(kGroup);
}

void add_format_options(CLI::App& command, OpenOptions& options) {
  command.add_option("--format", options.format, "Kind of scans to read in a mixed folder")
      ->check(CLI::IsMember({"pcd", "ply", "bin"}))
      ->group(kGroup);
  command
      .add_flag("--kitti-correction", options.kitti_hdl64_correction,
                "Turn HDL-64E points up by 0.205 deg (KITTI's calibration error)")
      ->group(kGroup);
  command.add_option("--udp-port", options.udp_port, "Port of the sensor's packets in a capture")
      ->check(CLI::Range(1, 65535))
      ->group(kGroup);
  add_choice<ReturnChoice>(command, "--return", options.dual_return,
                           "Return to keep of two (VLP-16 in dual mode)",
                           {{"strongest", ReturnChoice::kStrongest},
                            {"last", ReturnChoice::kLast},
                            {"both", ReturnChoice::kBoth}});
  command
      .add_option("--cut", options.cut_azimuth_deg,
                  "Azimuth that begins a revolution of a capture [deg]")
      ->check(CLI::Range(0.0, 359.99))
      ->group(kGroup);
  command
      .add_flag("--vertical-correction,!--no-vertical-correction",
                options.vlp16_vertical_correction,
                "Whether VLP-16 points start at their laser's own height (default: yes)")
      ->group(kGroup);
}

}  // namespace

void add_reader_options(CLI::App& command, OpenOptions& options) {
  add_time_options(command, options);
  add_format_options(command, options);
}

}  // namespace surefoot::app
