// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot convert: the scans of a recording to another format.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "io/conversion.hpp"
#include "io/counted.hpp"
#include "piped_input.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "process/progress.hpp"
#include "reader_options.hpp"
#include "runs/input_checks.hpp"
#include "text/printable.hpp"

namespace surefoot::app {

namespace {

struct ConvertOptions {
  io::ConversionRequest request;
  bool quiet = false;
};

int convert(const ConvertOptions& options) {
  runs::refuse_run_folder(options.request.input);
  take_piped_recording(options.request.input, options.quiet);
  const process::InterruptGuard interrupt;
  process::Progress progress("scans", options.quiet);
  const auto complain = [&](const std::string& text) {
    progress.finish();
    fmt::print(stderr, "{}\n", text);
  };
  const io::ConversionOutcome outcome = io::convert_recording(
      options.request, {[&](std::size_t scans, double share) { progress.update(scans, share); },
                        complain, [&] { return interrupt.interrupted(); }});
  if (outcome.interrupted) {
    complain(fmt::format("interrupted after {}: nothing is written",
                         io::counted(outcome.scans, "scan")));
    return process::kInterrupted;
  }
  progress.finish();
  if (!options.quiet) {
    for (const std::string& note : outcome.notes) {
      fmt::print(stderr, "note: {}\n", text::printable(note));
    }
    for (const std::string& loss : outcome.losses) fmt::print(stderr, "{}\n", loss);
    fmt::print("{}, {}: {}\n", io::counted(outcome.scans, "scan"),
               io::counted(outcome.points, "point"), options.request.output.string());
    if (outcome.messages > 0) {
      fmt::print("  {:5} messages of {} other topics, copied as they are\n", outcome.messages,
                 outcome.topics);
    }
    if (outcome.packets > 0) fmt::print("  {:5} packets, copied as they are\n", outcome.packets);
    if (outcome.unreadable > 0) fmt::print("  {:5} unreadable\n", outcome.unreadable);
  }
  return outcome.unreadable > 0 ? process::kSomeFailed : process::kDone;
}

}  // namespace

void add_convert_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ConvertOptions>();
  io::ConversionRequest& request = options->request;
  CLI::App* command = app.add_subcommand(
      "convert", "Write a recording's scans in another format, with a bag's other messages");
  command->add_option("input", request.input, "any recording that 'surefoot run' takes")
      ->required();
  command
      ->add_option(
          "output", request.output,
          "FILE.mcap, FILE.bag (ROS 1), a folder, of one scan FILE.pcd, .ply, .bin, .las, or of a "
          "capture FILE.pcap, with its packets")
      ->required();
  command->add_option("--to", request.format, "format (by the output's name; a folder: pcd)")
      ->check(CLI::IsMember(io::conversion_format_names()));
  command->add_option("--begin", request.begin, "leave out what is before [s after the first scan]")
      ->check(command_line::number_within(0.0, 1e9));
  command->add_option("--end", request.end, "leave out what is after [s after the first scan]")
      ->check(command_line::number_within(0.0, 1e9));
  command->add_option("--start", request.start, "scans to pass over at first")
      ->check(command_line::whole_number(0));
  command->add_option("--count", request.count, "scans to write at most")
      ->check(command_line::whole_number(1));
  command->add_option("--stride", request.stride, "every n-th scan")
      ->check(command_line::whole_number(1));
  command->add_option("--out-topic", request.sink.topic,
                      "topic in a bag (the source's, else /points)");
  command->add_option("--frame", request.sink.frame, "frame in a bag (the source's, else lidar)");
  command->add_flag("-q,--quiet", options->quiet, "print errors only");
  add_reader_options(*command, request.reader);
  const std::string group = command->get_option("--topic")->get_group();
  command->remove_option(command->get_option("--topic"));
  command
      ->add_option("--topic", request.topics,
                   "Topic of a bag; may be given again (into a bag: all; else the only one "
                   "with scans)")
      ->allow_extra_args(false)
      ->group(group);
  command->callback([options, &exit_code] { exit_code = convert(*options); });
}

}  // namespace surefoot::app
