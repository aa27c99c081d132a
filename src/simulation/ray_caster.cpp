// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/ray_caster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "simulation/embree.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::size_t kPacket = 16;

/// A mesh with two time steps is not needed: only whole objects move, as instances.
RTCGeometry make_triangles(RTCDevice device, const TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.vertices.size()));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), mesh.triangles.size()));
  if (vertices == nullptr || indices == nullptr) {
    throw std::runtime_error("Embree could not hold a mesh of " +
                             std::to_string(mesh.triangles.size()) + " triangles");
  }
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    vertices = std::copy_n(vertex.data(), 3, vertices);
  }
  for (const auto& triangle : mesh.triangles) {
    indices = std::copy_n(triangle.data(), 3, indices);
  }
  rtcCommitGeometry(geometry);
  return geometry;
}

RTCScene make_scene(RTCDevice device, const TriangleMesh& mesh) {
  RTCScene scene = rtcNewScene(device);
  // Robust: no ray slips through the seam between two triangles.
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = make_triangles(device, mesh);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

std::array<float, 12> column_major_3x4(const Pose& pose) {
  const Eigen::Matrix<float, 3, 4> matrix = pose.matrix().topRows<3>().cast<float>();
  std::array<float, 12> values{};
  std::copy_n(matrix.data(), 12, values.begin());
  return values;
}

}  // namespace

struct RayCaster::Impl {
  struct Instance {
    RTCScene scene = nullptr;
    RTCGeometry geometry = nullptr;
    std::function<Pose(double)> T_map_object;
    std::vector<Material> materials;
  };

  explicit Impl(const Scene& scene)
      : device(rtcNewDevice("threads=1")), static_materials(scene.mesh.materials) {
    if (device == nullptr) throw std::runtime_error("Embree did not start");
    fixed = make_scene(device, scene.mesh);
    if (scene.moving.empty()) return;
    movers = rtcNewScene(device);
    rtcSetSceneFlags(movers, RTC_SCENE_FLAG_ROBUST);
    for (const MovingObject& object : scene.moving) add_instance(object);
    rtcCommitScene(movers);
  }
  ~Impl() {
    for (Instance& instance : instances) {
      rtcReleaseGeometry(instance.geometry);
      rtcReleaseScene(instance.scene);
    }
    if (movers != nullptr) rtcReleaseScene(movers);
    if (fixed != nullptr) rtcReleaseScene(fixed);
    rtcReleaseDevice(device);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void add_instance(const MovingObject& object) {
    Instance instance;
    instance.scene = make_scene(device, object.mesh);
    instance.geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    instance.T_map_object = object.T_map_object;
    instance.materials = object.mesh.materials;
    rtcSetGeometryInstancedScene(instance.geometry, instance.scene);
    rtcSetGeometryTimeStepCount(instance.geometry, 2);
    rtcAttachGeometry(movers, instance.geometry);
    instances.push_back(std::move(instance));
    place(instances.back(), 0.0, 0.0);
  }

  static void place(const Instance& instance, double begin, double end) {
    const std::array<double, 2> times = {begin, end};
    for (unsigned step = 0; step < 2; ++step) {
      const auto matrix = column_major_3x4(instance.T_map_object(times[step]));
      rtcSetGeometryTransform(instance.geometry, step, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                              matrix.data());
    }
    rtcCommitGeometry(instance.geometry);
  }

  void cast_packet(std::span<const Ray> rays, float max_distance, std::span<Hit> hits) const;

  RTCDevice device;
  // What moves has a scene of its own: it is built anew for every scan, the fixed one never.
  RTCScene fixed = nullptr;
  RTCScene movers = nullptr;  ///< null: nothing moves
  std::vector<Material> static_materials;
  std::vector<Instance> instances;  ///< the index is the geometry's id in `movers`
};

RayCaster::RayCaster(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

void RayCaster::set_interval(double begin, double end) {
  if (impl_->instances.empty()) return;
  for (const Impl::Instance& instance : impl_->instances) Impl::place(instance, begin, end);
  rtcCommitScene(impl_->movers);
}

void RayCaster::Impl::cast_packet(std::span<const Ray> rays, float max_distance,
                                  std::span<Hit> hits) const {
  alignas(64) RTCRayHit16 packet;
  alignas(64) std::array<int, kPacket> valid{};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    valid[i] = -1;
    packet.ray.org_x[i] = rays[i].origin.x();
    packet.ray.org_y[i] = rays[i].origin.y();
    packet.ray.org_z[i] = rays[i].origin.z();
    packet.ray.dir_x[i] = rays[i].direction.x();
    packet.ray.dir_y[i] = rays[i].direction.y();
    packet.ray.dir_z[i] = rays[i].direction.z();
    packet.ray.tnear[i] = 0.0F;
    packet.ray.tfar[i] = max_distance;
    packet.ray.time[i] = rays[i].time;
    packet.ray.mask[i] = 0xffffffffU;
    packet.ray.id[i] = 0;
    packet.ray.flags[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  intersect_coherent16(valid.data(), fixed, packet);
  // Rays now end where they met something fixed; only what is nearer takes its place.
  if (movers != nullptr) intersect_coherent16(valid.data(), movers, packet);

  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = Hit{};
    if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    const Eigen::Vector3f normal(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]);
    const unsigned instance = packet.hit.instID[0][i];
    const bool moving = instance != RTC_INVALID_GEOMETRY_ID;
    hits[i].met = moving ? Met::kMoving : Met::kStatic;
    // A normal met inside an instance is in the object's frame, so the ray must be too; objects
    // only turn about the vertical or not at all, and the ratio below needs the rotation alone.
    Eigen::Vector3f direction = rays[i].direction;
    if (moving) {
      std::array<float, 12> matrix{};
      rtcGetGeometryTransform(instances[instance].geometry, rays[i].time,
                              RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix.data());
      const Eigen::Map<const Eigen::Matrix<float, 3, 4>> T_map_object(matrix.data());
      direction = T_map_object.leftCols<3>().transpose() * direction;
    }
    hits[i].distance = packet.ray.tfar[i];
    hits[i].cos_incidence = std::min(1.0F, std::abs(normal.normalized().dot(direction)));
    const std::vector<Material>& materials =
        moving ? instances[instance].materials : static_materials;
    hits[i].material = materials[packet.hit.primID[i]];
  }
}

void RayCaster::cast(std::span<const Ray> rays, float max_distance, std::span<Hit> hits) const {
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - first);
    impl_->cast_packet(rays.subspan(first, count), max_distance, hits.subspan(first, count));
  }
}

std::optional<double> RayCaster::ground_below(const Eigen::Vector3d& point, double depth) const {
  const Ray ray{point.cast<float>(), -Eigen::Vector3f::UnitZ(), 0.0F};
  Hit hit;
  cast({&ray, 1}, static_cast<float>(depth), {&hit, 1});
  if (!hit.valid()) return std::nullopt;
  return point.z() - static_cast<double>(hit.distance);
}

}  // namespace surefoot::simulation
