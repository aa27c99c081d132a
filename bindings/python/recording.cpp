// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Recordings as iterators of scans: what `surefoot run` would register, in its order.
#include "io/recording.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "bindings.hpp"
#include "reading.hpp"
#include "scan.hpp"

namespace surefoot::python {

namespace {

/// Leaves out what the program leaves out, and says so.
class ScanIterator {
 public:
  ScanIterator(const std::filesystem::path& path, const io::OpenOptions& options, bool keep_partial)
      : recording_(io::open_recording(path, options)), keep_partial_(keep_partial) {}

  ArrayScan next() {
    while (std::optional<io::ScanItem> item = next_item()) {
      if (!item->scan) {
        leave_out(item->error);
        continue;
      }
      ArrayScan scan = array_scan(std::move(*item->scan));
      scan.name = item->name;
      scan.remark = item->remark;
      return scan;
    }
    throw py::stop_iteration();
  }

  void skip(std::size_t scans) {
    if (scans > 0 && std::exchange(ahead_, std::nullopt)) --scans;
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    recording_->skip(scans);
  }
  /// What the recording knows of itself, while no other thread reads it.
  template <typename Question>
  auto ask(const Question& question) const {
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    return question(std::as_const(*recording_));
  }
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }

 private:
  std::optional<io::ScanItem> next_item() {
    if (ahead_) return std::exchange(ahead_, std::nullopt);
    const bool first = !std::exchange(begun_, true);
    std::optional<io::ScanItem> item, second;
    {
      const py::gil_scoped_release release;
      const std::lock_guard lock(mutex_);
      item = recording_->next();
      // A revolution that the capture begins within, unless it is all there is.
      if (first && !keep_partial_ && item && !item->remark.empty()) second = recording_->next();
    }
    if (!second) return item;
    ahead_ = std::move(second);  // the warning may be an error
    leave_out(item->name + ": " + item->remark);
    return next_item();
  }

  void leave_out(const std::string& why) {
    left_out_.push_back(why);
    if (PyErr_WarnEx(PyExc_UserWarning, ("left out: " + why).c_str(), 1) != 0) {
      throw py::error_already_set();
    }
  }

  std::unique_ptr<io::Recording> recording_;
  bool keep_partial_;
  bool begun_ = false;
  std::optional<io::ScanItem> ahead_;  // read, but not given yet
  mutable std::mutex mutex_;           // of recording_, for threads of Python that share it
  std::vector<std::string> left_out_;
};

std::unique_ptr<ScanIterator> open(const std::filesystem::path& path, bool keep_partial,
                                   const py::kwargs& options) {
  io::OpenOptions reader;
  for (const auto& [key, value] : options) {
    const std::string name = py::str(key);
    if (set_reading_option(reader, name, value)) continue;
    refuse_keyword("open", name, {"keep_partial"});
  }
  const py::gil_scoped_release release;
  return std::make_unique<ScanIterator>(path, reader, keep_partial);
}

py::dict counts_of(const ScanIterator& self) {
  const io::CaptureCounts counts = self.ask(std::mem_fn(&io::Recording::capture_counts));
  py::dict result;
  result["packets"] = counts.packets;
  result["data_packets"] = counts.data_packets;
  result["position_packets"] = counts.position_packets;
  result["truncated"] = counts.truncated;
  result["other"] = counts.other;
  result["fragments"] = counts.fragments;
  result["reordered"] = counts.reordered;
  result["lost"] = counts.lost;
  return result;
}

}  // namespace

void bind_recording(py::module_& module) {
  py::class_<ScanIterator>(module, "Recording", R"(A recording, read from front to back.

Iterate it once to get its scans. Scans that cannot be read are left out with a warning.)")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &ScanIterator::next)
      .def("skip", &ScanIterator::skip, py::arg("scans"),
           "Passes over scans; cheap where they are separate files.")
      .def_property_readonly(
          "size",
          [](const ScanIterator& self) { return self.ask(std::mem_fn(&io::Recording::size)); },
          "Number of scans, or None where that is not known without reading them.")
      .def_property_readonly(
          "progress",
          [](const ScanIterator& self) { return self.ask(std::mem_fn(&io::Recording::progress)); },
          "Share that was read, 0..1.")
      .def_property_readonly(
          "notes",
          [](const ScanIterator& self) { return self.ask(std::mem_fn(&io::Recording::notes)); },
          "What was found out from values or assumed; grows while reading.")
      .def_property_readonly(
          "description",
          [](const ScanIterator& self) {
            return self.ask(std::mem_fn(&io::Recording::description));
          },
          "Such as 'folder of 90 PCD files'.")
      .def_property_readonly("left_out", &ScanIterator::left_out,
                             "What could not be used so far, and why.")
      .def_property_readonly("capture_counts", &counts_of,
                             "Packets of a capture so far, by what became of them.")
      .def("__repr__", [](const ScanIterator& self) {
        return "<Recording: " + self.ask(std::mem_fn(&io::Recording::description)) + ">";
      });
  module.def(
      "open", &open, py::arg("path"), py::kw_only(), py::arg("keep_partial") = false,
      R"(Opens whatever `surefoot run` takes: a folder of PCD, PLY, LAS or KITTI .bin scans, one
such file, a capture of packets (.pcap, .pcapng), a bag (.bag, .db3, .mcap, or its folder).

>>> for scan in surefoot.open("walk.mcap", topic="/points"): ...

keep_partial: give also the part of a revolution that a capture begins with.
The other options are the program's, with _ for -: dataset, robot, topic, format, time_field, time_unit (auto,
s, ms, us, ns), time_reference (auto, relative, absolute, own-clock), stamp_at (start, end), point_times
(forward, backward, none), derive_times (no,
azimuth), spin (clockwise, counterclockwise), stamps (a file), repair_stamps,
repair_at_once, rate [Hz],
kitti_correction, udp_port, sensor, calibration (a file), returns (strongest, last, both; the
program's --return), cut [deg], vertical_correction.)");
  module.attr("_reading_options") = reading_option_names();
}

}  // namespace surefoot::python
