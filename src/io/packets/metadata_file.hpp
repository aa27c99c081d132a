// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What an Ouster says about itself, in a file beside its capture.
#pragma once

#include <filesystem>
#include <string>

namespace surefoot::io {

struct MetadataFile {
  std::string text;    ///< empty: there is none, or none that is surely the capture's
  std::string remark;  ///< which one was taken by a name that is only like it, or why none was
};

/// walk.json of walk.pcap. Where that is not there, of the JSON files that are an Ouster's metadata
/// the one with whose name the capture's begins (the longest), else the only one whose name begins
/// with the capture's, as Ouster's own tools name them: walk_0.json.
[[nodiscard]] MetadataFile metadata_beside(const std::filesystem::path& capture);

}  // namespace surefoot::io
