// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "reading.hpp"

#include <pybind11/stl/filesystem.h>

#include <array>
#include <string_view>
#include <utility>

#include "io/datasets.hpp"
#include "io/robots.hpp"
#include "words.hpp"

namespace surefoot::python {

namespace {

template <typename Choice, std::size_t count>
using Words = std::array<std::pair<std::string_view, Choice>, count>;

constexpr Words<io::TimeUnit, 5> kTimeUnits = {{{"auto", io::TimeUnit::automatic},
                                                {"s", io::TimeUnit::seconds},
                                                {"ms", io::TimeUnit::milliseconds},
                                                {"us", io::TimeUnit::microseconds},
                                                {"ns", io::TimeUnit::nanoseconds}}};
constexpr Words<io::TimeReference, 4> kTimeReferences = {
    {{"auto", io::TimeReference::automatic},
     {"relative", io::TimeReference::relative},
     {"absolute", io::TimeReference::absolute},
     {"own-clock", io::TimeReference::own_clock}}};
constexpr Words<io::StampAt, 2> kStampsAt = {
    {{"start", io::StampAt::start}, {"end", io::StampAt::end}}};
constexpr Words<io::TimeDirection, 3> kDirections = {{{"forward", io::TimeDirection::forward},
                                                      {"backward", io::TimeDirection::backward},
                                                      {"none", io::TimeDirection::none}}};
constexpr Words<io::DeriveTimes, 2> kDeriveTimes = {
    {{"no", io::DeriveTimes::no}, {"azimuth", io::DeriveTimes::azimuth}}};
constexpr Words<io::Spin, 2> kSpins = {
    {{"clockwise", io::Spin::clockwise}, {"counterclockwise", io::Spin::counterclockwise}}};
constexpr Words<io::ReturnChoice, 3> kReturns = {{{"strongest", io::ReturnChoice::strongest},
                                                  {"last", io::ReturnChoice::last},
                                                  {"both", io::ReturnChoice::both}}};

std::string word(const py::handle& value) { return py::str(value); }

double number_in(const py::handle& value, const char* option, const io::NumberRange& range) {
  const auto number = value.cast<double>();
  require_within(option, number, range);
  return number;
}

std::string robot_named(const std::string& name) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::string& one : io::robot_names()) names.emplace_back(one, one);
  return choice_of(names, "robot", name);
}

std::string dataset_named(const std::string& name) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::string& one : io::dataset_names()) names.emplace_back(one, one);
  return choice_of(names, "dataset", name);
}

using Setter = void (*)(io::OpenOptions&, const py::handle&);
struct ReadingKeyword {
  const char* name;
  Setter set;
};

const ReadingKeyword kReadingKeywords[] = {
    {"dataset", [](auto& o, const auto& v) { o.dataset = dataset_named(word(v)); }},
    {"topic", [](auto& o, const auto& v) { o.topic = word(v); }},
    {"format", [](auto& o, const auto& v) { o.format = word(v); }},
    {"time_field", [](auto& o, const auto& v) { o.time_field = word(v); }},
    {"time_unit", [](auto& o, const auto& v) { o.time_unit = time_unit_named(word(v)); }},
    {"time_reference",
     [](auto& o, const auto& v) { o.time_reference = time_reference_named(word(v)); }},
    {"stamp_at", [](auto& o, const auto& v) { o.stamp_at = stamp_at_named(word(v)); }},
    {"point_times",
     [](auto& o, const auto& v) {
       o.time_direction = choice_of(kDirections, "point_times", word(v));
     }},
    {"derive_times",
     [](auto& o, const auto& v) {
       o.derive_times = choice_of(kDeriveTimes, "derive_times", word(v));
     }},
    {"spin", [](auto& o, const auto& v) { o.spin = choice_of(kSpins, "spin", word(v)); }},
    {"stamps",
     [](auto& o, const auto& v) { o.stamps_file = v.template cast<std::filesystem::path>(); }},
    {"robot", [](auto& o, const auto& v) { o.robot = robot_named(word(v)); }},
    {"repair_at_once", [](auto& o, const auto& v) { o.repair_at_once = v.template cast<bool>(); }},
    {"repair_stamps", [](auto& o, const auto& v) { o.repair_stamps = v.template cast<bool>(); }},
    {"rate", [](auto& o, const auto& v) { o.rate_hz = number_in(v, "rate", io::kRates); }},
    {"kitti_correction",
     [](auto& o, const auto& v) { o.kitti_hdl64_correction = v.template cast<bool>(); }},
    {"udp_port",
     [](auto& o, const auto& v) {
       require_within("udp_port", v.template cast<int>(), io::kPorts);
       o.udp_port = v.template cast<std::uint16_t>();
     }},
    {"sensor", [](auto& o, const auto& v) { o.sensor = word(v); }},
    {"calibration",
     [](auto& o, const auto& v) { o.calibration_file = v.template cast<std::filesystem::path>(); }},
    {"returns",
     [](auto& o, const auto& v) { o.dual_return = choice_of(kReturns, "returns", word(v)); }},
    {"cut", [](auto& o, const auto& v) { o.cut_azimuth_deg = number_in(v, "cut", io::kCuts); }},
    {"vertical_correction",
     [](auto& o, const auto& v) { o.beam_origins = v.template cast<bool>(); }},
};

}  // namespace

io::TimeUnit time_unit_named(const std::string& name) {
  return choice_of(kTimeUnits, "time_unit", name);
}
io::TimeReference time_reference_named(const std::string& name) {
  return choice_of(kTimeReferences, "time_reference", name);
}
io::StampAt stamp_at_named(const std::string& name) {
  return choice_of(kStampsAt, "stamp_at", name);
}

bool set_reading_option(io::OpenOptions& options, const std::string& name,
                        const py::handle& value) {
  for (const ReadingKeyword& option : kReadingKeywords) {
    if (name != option.name) continue;
    if (value.is_none()) return true;
    try {
      option.set(options, value);
    } catch (const py::cast_error&) {
      throw py::type_error(name + ": got " + std::string(py::repr(value)));
    }
    return true;
  }
  return false;
}

std::vector<std::string> reading_option_names() {
  std::vector<std::string> names;
  for (const ReadingKeyword& option : kReadingKeywords) names.emplace_back(option.name);
  return names;
}

void refuse_keyword(const std::string& function, const std::string& name,
                    const std::vector<std::string>& own) {
  std::string known;
  for (const auto& names : {own, reading_option_names()}) {
    for (const std::string& one : names) known += (known.empty() ? "" : ", ") + one;
  }
  throw py::type_error(function + "() has no option '" + name + "'; it has: " + known);
}

}  // namespace surefoot::python
