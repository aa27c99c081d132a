// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/fingerprint.hpp"

#include <array>
#include <fstream>
#include <map>

#include "io/bags/bag_files.hpp"
#include "io/file_kind.hpp"
#include "io/files/folder_listing.hpp"
#include "io/packets/metadata_file.hpp"
#include "io/stamps.hpp"

namespace surefoot::experiments {

namespace fs = std::filesystem;

namespace {

void add_file(const fs::path& file, const std::string& name, Fingerprint& fingerprint,
              std::uint64_t& bytes) {
  const std::uint64_t size = fs::file_size(file);
  fingerprint.add(name);
  fingerprint.add(size);
  fingerprint.add(static_cast<std::uint64_t>(fs::last_write_time(file).time_since_epoch().count()));
  bytes += size;
}

}  // namespace

void Fingerprint::add(std::string_view bytes) {
  const auto mix = [this](unsigned char byte) { hash_ = (hash_ ^ byte) * 1099511628211U; };
  for (const char c : bytes) mix(static_cast<unsigned char>(c));
  mix(0xFF);  // "ab" and "c" are not "a" and "bc"
}

void Fingerprint::add(std::uint64_t number) { add(std::to_string(number)); }

std::string Fingerprint::text() const {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += kDigits[(hash_ >> shift) & 0xF];
  return digits;
}

FilesMark mark_of(const fs::path& path) {
  Fingerprint fingerprint;
  FilesMark mark;
  if (fs::is_directory(path)) {
    std::map<std::string, fs::path> files;  // in an order that is the same everywhere
    std::vector<fs::path> folders = io::folders_of_recording(path);
    if (fs::path bag = io::bag_folder(path); bag != path) folders.push_back(std::move(bag));
    for (const fs::path& folder : folders) {
      for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        files.emplace(entry.path().lexically_relative(path).generic_string(), entry.path());
      }
    }
    for (const auto& [name, file] : files) add_file(file, name, fingerprint, mark.bytes);
    if (const fs::path stamps = io::find_stamps_file(path); !stamps.empty()) {
      std::uint64_t no_scans = 0;
      add_file(stamps, stamps.filename().string(), fingerprint, no_scans);
    }
  } else {
    add_file(path, path.filename().string(), fingerprint, mark.bytes);
    const bool is_capture = io::kind_of(path) == io::FileKind::capture;
    if (is_capture) fingerprint.add(io::metadata_beside(path).text);
  }
  mark.fingerprint = fingerprint.text();
  return mark;
}

std::string build_fingerprint() {
  std::ifstream program("/proc/self/exe", std::ios::binary);
  if (!program) return "";
  Fingerprint fingerprint;
  std::array<char, 65536> block{};
  while (program.read(block.data(), block.size()) || program.gcount() > 0) {
    fingerprint.add(std::string_view(block.data(), static_cast<std::size_t>(program.gcount())));
  }
  return fingerprint.text();
}

}  // namespace surefoot::experiments
