// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "io/packets/capture_file.hpp"

namespace surefoot::io {

/// Frames of a capture to another, as they are: pcap with nanoseconds, of the same link layer.
class FrameWriter {
 public:
  /// Throws WriteError where the file cannot be made.
  FrameWriter(const std::filesystem::path& file, const CaptureFile& like);

  /// False where the format cannot hold the frame's stamp: before 1970, after 2106. Throws
  /// WriteError.
  [[nodiscard]] bool add(const CapturedFrame& frame);
  /// All that was added lies in the file. Throws WriteError.
  void finish();

 private:
  struct Close {
    void operator()(void* dump) const;
  };
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::unique_ptr<void, Close> dump_;  ///< a pcap_dumper_t
};

}  // namespace surefoot::io
