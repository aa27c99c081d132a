// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "io/bags/message_source.hpp"

namespace surefoot::io {

/// The messages of a rosbag2 sqlite3 file (.db3), of any version of its tables, in the order they
/// were written. Messages that are Zstandard frames are decompressed: only a metadata.yaml would
/// say so, and there may be none. A file that is compressed as a whole is first written out to the
/// system's folder for temporary files. Throws ReadError without the file's name.
[[nodiscard]] std::unique_ptr<MessageSource> read_sqlite_bag(const std::filesystem::path& file);

}  // namespace surefoot::io
