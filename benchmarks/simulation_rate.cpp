// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How fast recordings are simulated: scans of a VLP-16, and their rays against what Embree casts by
// itself on the same scene. "items" are scans, or rays.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "simulation/body_motion.hpp"
#include "simulation/embree.hpp"
#include "simulation/scanner.hpp"

namespace surefoot::benchmarks {

namespace {

using namespace surefoot::simulation;

constexpr double kSeconds = 20.0;
constexpr std::uint64_t kFirstScan = 40;  // the robot walks
constexpr std::uint64_t kScans = 150;
constexpr std::size_t kPacket = 8;

/// A trotting robot with a VLP-16 in one of the scenes.
struct Studio {
  explicit Studio(const std::string& name, bool footprint = false)
      : scene(build_scene(name, 1)),
        rays(scene),
        scanner(rays, lidar_model("vlp16"),
                make_motion(scene, rays, gait_model("trot"), kSeconds, 1,
                            Pose{Eigen::Quaterniond::Identity(), {0.10, 0.0, 0.16}}),
                {.footprint = footprint}) {}
  Scene scene;
  RayCaster rays;
  Scanner scanner;
};

void time_scans(benchmark::State& state, const std::string& scene, bool footprint) {
  Studio studio(scene, footprint);
  std::uint64_t index = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(studio.scanner.scan(kFirstScan + index));
    index = (index + 1) % kScans;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK_CAPTURE(time_scans, campus_footprint, "campus", true)
    ->Name("scan/campus/footprint")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_scans, campus, "campus", false)
    ->Name("scan/campus/one_ray")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_scans, forest_footprint, "forest", true)
    ->Name("scan/forest/footprint")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_scans, forest, "forest", false)
    ->Name("scan/forest/one_ray")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_scans, hilltop_footprint, "hilltop", true)
    ->Name("scan/hilltop/footprint")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_scans, hilltop, "hilltop", false)
    ->Name("scan/hilltop/one_ray")
    ->Unit(benchmark::kMillisecond);

/// The beams of one revolution from one place, laser by laser as the scanner casts them.
std::vector<Ray> revolution(const Studio& studio) {
  constexpr int kAzimuths = 1808;
  const Pose T_map_lidar = studio.scanner.motion().T_map_lidar(5.0);
  std::vector<Ray> rays;
  for (const Laser& laser : studio.scanner.model().lasers) {
    for (int i = 0; i < kAzimuths; ++i) {
      const double azimuth = 2.0 * std::numbers::pi * i / kAzimuths;
      const Eigen::Vector3d direction(std::cos(laser.elevation) * std::cos(azimuth),
                                      -std::cos(laser.elevation) * std::sin(azimuth),
                                      std::sin(laser.elevation));
      rays.push_back({T_map_lidar.translation.cast<float>(),
                      (T_map_lidar.rotation * direction).cast<float>(), 0.0F});
    }
  }
  return rays;
}

void time_ray_caster(benchmark::State& state, const std::string& scene) {
  const Studio studio(scene);
  const std::vector<Ray> rays = revolution(studio);
  std::vector<Hit> hits(rays.size());
  const auto reach = static_cast<float>(studio.scanner.model().max_range);
  for (auto _ : state) {
    studio.rays.cast(rays, reach, hits);
    benchmark::DoNotOptimize(hits.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}
BENCHMARK_CAPTURE(time_ray_caster, campus, "campus")->Name("rays/campus/ray_caster");
BENCHMARK_CAPTURE(time_ray_caster, forest, "forest")->Name("rays/forest/ray_caster");
BENCHMARK_CAPTURE(time_ray_caster, hilltop, "hilltop")->Name("rays/hilltop/ray_caster");

/// The same triangles given to Embree without anything of ours between.
class BareEmbree {
 public:
  explicit BareEmbree(const TriangleMesh& mesh)
      : device_(new_device()), scene_(rtcNewScene(device_)) {
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertices.size()));
    for (const Eigen::Vector3f& vertex : mesh.vertices) {
      vertices = std::copy_n(vertex.data(), 3, vertices);
    }
    auto* corners = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
      corners = std::copy_n(triangle.data(), 3, corners);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~BareEmbree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  BareEmbree(const BareEmbree&) = delete;
  BareEmbree& operator=(const BareEmbree&) = delete;

  void cast(RTCRayHit8& packet) const {
    alignas(64) std::array<int, kPacket> valid;
    valid.fill(-1);
    intersect_coherent8(valid.data(), scene_, packet);
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

std::vector<RTCRayHit8> packets_of(const std::vector<Ray>& rays, float reach) {
  std::vector<RTCRayHit8> packets(rays.size() / kPacket);
  for (std::size_t i = 0; i < packets.size() * kPacket; ++i) {
    RTCRayHit8& packet = packets[i / kPacket];
    const std::size_t lane = i % kPacket;
    packet.ray.org_x[lane] = rays[i].origin.x();
    packet.ray.org_y[lane] = rays[i].origin.y();
    packet.ray.org_z[lane] = rays[i].origin.z();
    packet.ray.dir_x[lane] = rays[i].direction.x();
    packet.ray.dir_y[lane] = rays[i].direction.y();
    packet.ray.dir_z[lane] = rays[i].direction.z();
    packet.ray.tfar[lane] = reach;
    packet.ray.mask[lane] = 0xffffffffU;
    packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  }
  return packets;
}

void time_embree(benchmark::State& state, const std::string& scene) {
  const Studio studio(scene);
  const BareEmbree embree(studio.scene.mesh);
  const std::vector<RTCRayHit8> packets =
      packets_of(revolution(studio), static_cast<float>(studio.scanner.model().max_range));
  for (auto _ : state) {
    for (const RTCRayHit8& unused : packets) {
      RTCRayHit8 packet = unused;  // casting changes it
      embree.cast(packet);
      benchmark::DoNotOptimize(packet);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(packets.size() * kPacket));
  state.counters["triangles"] = static_cast<double>(studio.scene.mesh.triangles.size());
}
BENCHMARK_CAPTURE(time_embree, campus, "campus")->Name("rays/campus/embree");
BENCHMARK_CAPTURE(time_embree, forest, "forest")->Name("rays/forest/embree");
BENCHMARK_CAPTURE(time_embree, hilltop, "hilltop")->Name("rays/hilltop/embree");

}  // namespace

}  // namespace surefoot::benchmarks
