// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/live_log.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "io/file_writer.hpp"
#include "io/recording.hpp"
#include "text/printable.hpp"

namespace surefoot::live {
namespace {

constexpr std::string_view kHeader = "stamp_ns,scan,fate,latency_ms";

}  // namespace

void LiveLog::used(std::int64_t stamp_ns, const std::string& scan, double latency_ms) {
  std::string line = std::to_string(stamp_ns) + "," + scan + ",used,";
  io::append_fixed(line, latency_ms, 3);
  add(line);
}

void LiveLog::dropped(std::int64_t stamp_ns, const std::string& scan) {
  add(std::to_string(stamp_ns) + "," + scan + ",dropped,");
}

void LiveLog::paused(std::int64_t stamp_ns, const std::string& scan) {
  add(std::to_string(stamp_ns) + "," + scan + ",paused,");
}

void LiveLog::reset() { add("0,,reset,"); }

void LiveLog::open(const std::filesystem::path& file) {
  const std::lock_guard lock(mutex_);
  file_.open(file);
  file_ << kHeader << '\n' << kept_ << std::flush;
  kept_.clear();
  if (!file_) {
    throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(errno));
  }
}

void LiveLog::add(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (file_.is_open()) {
    file_ << line << '\n' << std::flush;
  } else {
    kept_ += line + '\n';
  }
}

UsedScans used_scans(const std::filesystem::path& log) {
  std::ifstream file(log);
  if (!file) throw io::ReadError(log.string() + ": cannot read it: " + std::strerror(errno));
  std::string line;
  if (!std::getline(file, line) || line != kHeader) {
    throw io::ReadError(log.string() + ": got '" + text::printable(line.substr(0, 80)) +
                        "', expected the log of a " + "live run, which begins '" +
                        std::string(kHeader) + "'");
  }
  UsedScans scans;
  bool is_reset = false;
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    std::int64_t stamp_ns = 0;
    const char* const end = line.data() + line.size();
    const auto parsed = std::from_chars(line.data(), end, stamp_ns);
    if (parsed.ec != std::errc{} || parsed.ptr == end || *parsed.ptr != ',') {
      if (file.eof()) break;  // a last line that was not finished
      throw io::ReadError(log.string() + ": line " + std::to_string(number) + ": got '" +
                          text::printable(line.substr(0, 80)) +
                          "', expected 'stamp,scan,fate,latency'");
    }
    if (line == "0,,reset,") is_reset = true;
    if (line.find(",used,") == std::string::npos) continue;
    scans.used.push_back(stamp_ns);
    if (std::exchange(is_reset, false)) scans.reset_before.push_back(stamp_ns);
  }
  // The sensor's clock may have been set back.
  std::sort(scans.reset_before.begin(), scans.reset_before.end());
  if (scans.used.empty()) throw io::ReadError(log.string() + ": its run used no scan");
  return scans;
}

}  // namespace surefoot::live
