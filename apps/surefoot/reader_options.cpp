// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "reader_options.hpp"

#include <CLI/CLI.hpp>

#include "io/datasets.hpp"
#include "io/robots.hpp"
#include "option_checks.hpp"

namespace surefoot::app {
namespace {

using io::DeriveTimes;
using io::OpenOptions;
using io::ReturnChoice;
using io::Spin;
using io::StampAt;
using io::TimeDirection;
using io::TimeReference;
using io::TimeUnit;

constexpr const char* kGroup = "Reading";

void add_time_options(CLI::App& command, OpenOptions& options) {
  command
      .add_option("--time-field", options.time_field,
                  "Field of the point times (found by its name)")
      ->group(kGroup);
  add_choice<TimeUnit>(command, "--time-unit", options.time_unit,
                       "Unit of the point times (found from the values)",
                       {{"auto", TimeUnit::automatic},
                        {"s", TimeUnit::seconds},
                        {"ms", TimeUnit::milliseconds},
                        {"us", TimeUnit::microseconds},
                        {"ns", TimeUnit::nanoseconds}})
      ->group(kGroup);
  add_choice<TimeReference>(command, "--time-reference", options.time_reference,
                            "Whether point times count from the stamp or from the epoch",
                            {{"auto", TimeReference::automatic},
                             {"relative", TimeReference::relative},
                             {"absolute", TimeReference::absolute}})
      ->group(kGroup);
  add_choice<StampAt>(command, "--stamp-at", options.stamp_at,
                      "Instant of a scan that its stamp names",
                      {{"start", StampAt::start}, {"end", StampAt::end}})
      ->group(kGroup);
  add_choice<TimeDirection>(command, "--point-times", options.time_direction,
                            "forward; backward: they count back from the stamp; none: leave them "
                            "out, the scans are deskewed already",
                            {{"forward", TimeDirection::forward},
                             {"backward", TimeDirection::backward},
                             {"none", TimeDirection::none}})
      ->group(kGroup);
  add_choice<DeriveTimes>(command, "--derive-times", options.derive_times,
                          "Make up point times: azimuth: of a spinning LiDAR, from --cut on",
                          {{"no", DeriveTimes::no}, {"azimuth", DeriveTimes::azimuth}})
      ->group(kGroup);
  add_choice<Spin>(command, "--spin", options.spin, "How that LiDAR turns, seen from above",
                   {{"clockwise", Spin::clockwise}, {"counterclockwise", Spin::counterclockwise}})
      ->group(kGroup);
  command
      .add_option("--stamps", options.stamps_file,
                  "File of stamps, one a scan (times.txt beside the scans)")
      ->type_name(kFileType)
      ->group(kGroup);
  command
      .add_flag("--repair-stamps,!--no-repair-stamps", options.repair_stamps,
                "Mend stamps that go back, stand still or are wild (default: yes)")
      ->group(kGroup);
  command
      .add_flag("--repair-at-once", options.repair_at_once,
                "Mend them without a look at the next scans, as live runs on topics do")
      ->group(kGroup);
  command.add_option("--rate", options.rate_hz, "Scans a second where nothing gives stamps [Hz]")
      ->check(number_within(1e-3, 1e4))
      ->group(kGroup);
}

void add_format_options(CLI::App& command, OpenOptions& options) {
  command.add_option("--topic", options.topic, "Topic of a bag (the only one with scans)")
      ->group(kGroup);
  command.add_option("--format", options.format, "Kind of scans to read in a mixed folder")
      ->check(CLI::IsMember({"pcd", "ply", "bin", "las"}))
      ->group(kGroup);
  command
      .add_flag("--kitti-correction", options.kitti_hdl64_correction,
                "Turn HDL-64E points up by 0.205 deg (KITTI's calibration error)")
      ->group(kGroup);
  command
      .add_option("--udp-port", options.udp_port,
                  "Port of the sensor's packets in a capture (the first LiDAR's)")
      ->check(CLI::Range(1, 65535))
      ->group(kGroup);
  command
      .add_option("--sensor", options.sensor,
                  "Sensor of a capture's or bag's packets (found from the packets)")
      ->group(kGroup);
  command
      .add_option("--calibration", options.calibration_file,
                  "Calibration or metadata file of that sensor (its manual's table)")
      ->type_name(kFileType)
      ->group(kGroup);
  add_choice<ReturnChoice>(command, "--return", options.dual_return,
                           "Return to keep of two (packets of a sensor in dual mode)",
                           {{"strongest", ReturnChoice::strongest},
                            {"last", ReturnChoice::last},
                            {"both", ReturnChoice::both}})
      ->group(kGroup);
  command
      .add_option("--cut", options.cut_azimuth_deg,
                  "Azimuth that begins a revolution of a capture, or of --derive-times (there "
                  "counter-clockwise from x) [deg]")
      ->check(number_within(0.0, 359.99))
      ->group(kGroup);
  command
      .add_flag("--vertical-correction,!--no-vertical-correction", options.beam_origins,
                "Whether points of packets start at their laser's own height (default: yes)")
      ->group(kGroup);
}

}  // namespace

void add_reader_options(CLI::App& command, OpenOptions& options) {
  command
      .add_option("--dataset", options.dataset,
                  "Read as this public data set asks for; 'surefoot datasets' tells of each")
      ->check(one_of(io::dataset_names()))
      ->type_name("NAME")
      ->group(kGroup);
  command
      .add_option("--robot", options.robot,
                  "Read as what this robot's own software publishes asks for: topic, rate, stamps")
      ->check(one_of(io::robot_names()))
      ->type_name("NAME")
      ->group(kGroup);
  add_time_options(command, options);
  add_format_options(command, options);
}

}  // namespace surefoot::app
