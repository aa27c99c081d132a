// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings/scene_drawing.hpp"

#include <utility>

#include "report/canvas.hpp"
#include "simulation/scene_picture.hpp"

namespace surefoot::recordings {

void draw_scene(const RecordingRequest& request, const std::filesystem::path& file) {
  constexpr int kWidth = 480;
  const simulation::Scene scene = scene_of(request);
  const simulation::RayCaster rays(scene);
  simulation::SceneImage image = simulation::render_scene(scene, rays, kWidth);
  report::Canvas canvas(image.width, image.height, report::PageFormat::png);
  const report::Rect page{0.0, 0.0, static_cast<double>(image.width),
                          static_cast<double>(image.height)};
  canvas.image({image.width, image.height, std::move(image.argb)}, page);
  canvas.save(file, report::PictureKind::scene);
}

}  // namespace surefoot::recordings
