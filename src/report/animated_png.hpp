// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A moving picture that browsers show like any PNG: the chunks acTL, fcTL and fdAT of the PNG
// specification's third edition ("APNG").
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "report/canvas.hpp"

namespace surefoot::report {

/// Frames are kept compressed, each as its change against the one before, until they are saved.
class AnimatedPng {
 public:
  /// @param width, height of every frame [pixels].
  AnimatedPng(int width, int height) : width_(width), height_(height) {}

  /// Adds an opaque frame that is shown for `milliseconds`.
  /// @throws std::invalid_argument where it has another size.
  void add(const Raster& frame, std::uint16_t milliseconds);
  [[nodiscard]] std::size_t frame_count() const { return frames_.size(); }
  /// Writes the animation, which then runs round and round, whole or not at all.
  /// @throws std::runtime_error naming the path.
  void save(const std::filesystem::path& path) const;

 private:
  /// The rectangle of a frame that changes.
  struct Frame {
    int x = 0, y = 0, width = 0, height = 0;
    std::uint16_t milliseconds = 0;
    std::string pixels;  ///< RGBA, what stays is transparent, compressed as PNG wants it
  };
  [[nodiscard]] Frame changed_part(const Raster& frame) const;

  int width_;
  int height_;
  std::vector<std::uint32_t> shown_;  ///< the last frame; empty before the first
  std::vector<Frame> frames_;
};

}  // namespace surefoot::report
