// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/metadata_file.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "io/ascii_values.hpp"
#include "io/file_kind.hpp"
#include "io/file_reader.hpp"
#include "io/recording.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t kMostBytes = 4'000'000;
constexpr std::size_t kMostTried = 100;  // files of a folder

std::optional<std::string> text_of_file(const fs::path& file) {
  std::error_code ignored;
  const std::uintmax_t size = fs::file_size(file, ignored);
  if (ignored || size > kMostBytes) return std::nullopt;
  try {
    std::vector<std::byte> bytes;
    read_whole_file(file, bytes);
    return std::string(text_of(bytes));
  } catch (const ReadError&) {
    return std::nullopt;
  }
}

bool is_metadata(const std::string& text) {
  return text.find("beam_altitude_angles") != std::string::npos;
}

/// JSON files whose name begins as the capture's does, or the other way round; by name.
std::vector<fs::path> alike(const fs::path& capture) {
  const std::string stem = uncompressed_name(capture).stem().string();
  const fs::path folder = capture.has_parent_path() ? capture.parent_path() : fs::path(".");
  std::vector<fs::path> files;
  std::error_code ignored;
  for (fs::directory_iterator it(folder, ignored), end; it != end && !ignored;
       it.increment(ignored)) {
    const std::string other = it->path().stem().string();
    if (it->path().extension() != ".json" || other.empty()) continue;
    if (stem.starts_with(other) || other.starts_with(stem)) files.push_back(it->path());
    if (files.size() == kMostTried) break;
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

MetadataFile metadata_beside(const fs::path& capture) {
  const fs::path exact = uncompressed_name(capture).replace_extension(".json");
  if (std::optional<std::string> text = text_of_file(exact)) return {std::move(*text), {}};
  const std::size_t own_length = exact.stem().string().size();
  std::vector<std::pair<fs::path, std::string>> longer;
  std::pair<fs::path, std::string> beginning;
  for (const fs::path& file : alike(capture)) {
    std::optional<std::string> text = text_of_file(file);
    if (!text || !is_metadata(*text)) continue;
    const std::size_t length = file.stem().string().size();
    if (length > own_length) {
      longer.emplace_back(file, std::move(*text));
    } else if (length > beginning.first.stem().string().size()) {
      beginning = {file, std::move(*text)};
    }
  }
  const auto taken = [](const std::pair<fs::path, std::string>& one) {
    return MetadataFile{one.second, "the sensor's metadata: from " +
                                        text::printable(one.first.filename().string()) +
                                        ", whose name is most like the capture's"};
  };
  if (!beginning.first.empty()) return taken(beginning);
  if (longer.size() == 1) return taken(longer.front());
  if (longer.empty()) return {};
  std::string names;
  for (const auto& [file, text] : longer) {
    names += (names.empty() ? "" : ", ") + text::printable(file.filename().string());
  }
  return {{}, "any of these may be its metadata: " + names};
}

}  // namespace surefoot::io
