// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The fixed set of recordings that tables stand on, on disk.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace surefoot::recordings {

struct SuiteRequest {
  std::filesystem::path folder;  ///< a sub-folder each recording
  std::string seeds;             ///< name of a set
  unsigned jobs = 1;             ///< recordings made at a time
  bool overwrite = false;        ///< as RecordingRequest::overwrite
};

/// Both are called from several threads, never at once and never after make_suite() has returned.
struct SuiteListener {
  std::function<void(const std::string& text)> say;  ///< after each recording
  std::function<bool()> interrupted;                 ///< true ends it
};

/// @returns whether every recording was made whole. Throws what make_recording() throws.
[[nodiscard]] bool make_suite(const SuiteRequest& request, const SuiteListener& listener);

}  // namespace surefoot::recordings
