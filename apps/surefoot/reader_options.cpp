// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "reader_options.hpp"

#include <CLI/CLI.hpp>

#include "command_line/option_checks.hpp"
#include "command_line/option_group.hpp"
#include "io/datasets.hpp"
#include "io/option_ranges.hpp"
#include "io/robots.hpp"

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

void add_time_options(command_line::OptionGroup& group, OpenOptions& options) {
  group.add("--time-field", options.time_field, "Field of the point times (found by its name)");
  group.add_choice<TimeUnit>("--time-unit", options.time_unit,
                             "Unit of the point times (found from the values)",
                             {{"auto", TimeUnit::automatic},
                              {"s", TimeUnit::seconds},
                              {"ms", TimeUnit::milliseconds},
                              {"us", TimeUnit::microseconds},
                              {"ns", TimeUnit::nanoseconds}});
  group.add_choice<TimeReference>("--time-reference", options.time_reference,
                                  "Whether point times count from the stamp or from the epoch",
                                  {{"auto", TimeReference::automatic},
                                   {"relative", TimeReference::relative},
                                   {"absolute", TimeReference::absolute},
                                   {"own-clock", TimeReference::own_clock}});
  group.add_choice<StampAt>("--stamp-at", options.stamp_at,
                            "Instant of a scan that its stamp names",
                            {{"start", StampAt::start}, {"end", StampAt::end}});
  group.add_choice<TimeDirection>(
      "--point-times", options.time_direction,
      "forward; backward: they count back from the stamp; none: leave them "
      "out, the scans are deskewed already",
      {{"forward", TimeDirection::forward},
       {"backward", TimeDirection::backward},
       {"none", TimeDirection::none}});
  group.add_choice<DeriveTimes>("--derive-times", options.derive_times,
                                "Make up point times: azimuth: of a spinning LiDAR, from --cut on",
                                {{"no", DeriveTimes::no}, {"azimuth", DeriveTimes::azimuth}});
  group.add_choice<Spin>(
      "--spin", options.spin, "How that LiDAR turns, seen from above",
      {{"clockwise", Spin::clockwise}, {"counterclockwise", Spin::counterclockwise}});
  group
      .add("--stamps", options.stamps_file,
           "File of stamps, one a scan (times.txt beside the scans)")
      ->type_name(command_line::kFileType);
  group.add_flag("--repair-stamps,!--no-repair-stamps", options.repair_stamps,
                 "Mend stamps that go back, stand still or are wild (default: yes)");
  group.add_flag("--repair-at-once", options.repair_at_once,
                 "Mend them without a look at the next scans, as live runs on topics do");
  group.add("--rate", options.rate_hz, "Scans a second where nothing gives stamps [Hz]")
      ->check(command_line::number_within(io::kRates.low, io::kRates.high));
}

void add_format_options(command_line::OptionGroup& group, OpenOptions& options) {
  group.add("--topic", options.topic, "Topic of a bag (the only one with scans)");
  group.add("--format", options.format, "Kind of scans to read in a mixed folder")
      ->check(CLI::IsMember({"pcd", "ply", "bin", "las"}));
  group.add_flag("--kitti-correction", options.kitti_hdl64_correction,
                 "Turn HDL-64E points up by 0.205 deg (KITTI's calibration error)");
  group
      .add("--udp-port", options.udp_port,
           "Port of the sensor's packets in a capture (the first LiDAR's)")
      ->check(CLI::Range(1, 65535));
  group.add("--sensor", options.sensor,
            "Sensor of a capture's or bag's packets (found from the packets)");
  group
      .add("--calibration", options.calibration_file,
           "Calibration or metadata file of that sensor (its manual's table)")
      ->type_name(command_line::kFileType);
  group.add_choice<ReturnChoice>("--return", options.dual_return,
                                 "Return to keep of two (packets of a sensor in dual mode)",
                                 {{"strongest", ReturnChoice::strongest},
                                  {"last", ReturnChoice::last},
                                  {"both", ReturnChoice::both}});
  group
      .add("--cut", options.cut_azimuth_deg,
           "Azimuth that begins a revolution of a capture, or of --derive-times (there "
           "counter-clockwise from x) [deg]")
      ->check(command_line::number_within(io::kCuts.low, io::kCuts.high));
  group.add_flag("--vertical-correction,!--no-vertical-correction", options.beam_origins,
                 "Whether points of packets start at their laser's own height (default: yes)");
}

}  // namespace

void add_reader_options(CLI::App& command, OpenOptions& options) {
  command_line::OptionGroup group(command, "Reading");
  group
      .add("--dataset", options.dataset,
           "Read as this public data set asks for; 'surefoot datasets' tells of each")
      ->check(command_line::one_of(io::dataset_names()))
      ->type_name("NAME");
  group
      .add("--robot", options.robot,
           "Read as what this robot's own software publishes asks for: topic, rate, stamps, mount")
      ->check(command_line::one_of(io::robot_names()))
      ->type_name("NAME");
  add_time_options(group, options);
  add_format_options(group, options);
}

}  // namespace surefoot::app
