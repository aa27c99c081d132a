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

void set_ray(RTCRayHit16& packet, std::size_t i, const Ray& ray, float max_distance) {
  packet.ray.org_x[i] = ray.origin.x();
  packet.ray.org_y[i] = ray.origin.y();
  packet.ray.org_z[i] = ray.origin.z();
  packet.ray.dir_x[i] = ray.direction.x();
  packet.ray.dir_y[i] = ray.direction.y();
  packet.ray.dir_z[i] = ray.direction.z();
  packet.ray.tnear[i] = 0.0F;
  packet.ray.tfar[i] = max_distance;
  packet.ray.time[i] = ray.time;
  packet.ray.mask[i] = 0xffffffffU;
  packet.ray.id[i] = 0;
  packet.ray.flags[i] = 0;
  packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
}

/// The lane of a packet that has no ray. Where the processor has no vectors of 16, Embree cuts the
/// packet up and looks at the rays alone, not at their validity: it takes one that ends before it
/// begins for none.
void set_no_ray(RTCRayHit16& packet, std::size_t i) {
  set_ray(packet, i, {Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ(), 0.0F}, -1.0F);
}

/// What of a mesh bears a foot.
TriangleMesh firm_part(const TriangleMesh& mesh) {
  TriangleMesh firm;
  firm.vertices = mesh.vertices;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (is_soft(mesh.materials[i])) continue;
    firm.triangles.push_back(mesh.triangles[i]);
    firm.materials.push_back(mesh.materials[i]);
  }
  return firm;
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
    has_panes = std::find(static_materials.begin(), static_materials.end(), Material::pane) !=
                static_materials.end();
    if (std::any_of(static_materials.begin(), static_materials.end(), is_soft)) {
      firm = make_scene(device, firm_part(scene.mesh));
    }
    if (scene.moving.empty()) return;
    for (const MovingObject& object : scene.moving) add_instance(object);
    rtcCommitScene(movers);
  }
  ~Impl() {
    for (Instance& instance : instances) {
      rtcReleaseGeometry(instance.geometry);
      rtcReleaseScene(instance.scene);
    }
    if (movers != nullptr) rtcReleaseScene(movers);
    if (firm != nullptr) rtcReleaseScene(firm);
    if (fixed != nullptr) rtcReleaseScene(fixed);
    rtcReleaseDevice(device);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void add_instance(const MovingObject& object) {
    if (movers == nullptr) {
      movers = rtcNewScene(device);
      rtcSetSceneFlags(movers, RTC_SCENE_FLAG_ROBUST);
    }
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

  void cast_packet(std::span<const Ray> rays, float max_distance, std::span<Hit> hits,
                   int panes_passed = 0) const;
  void go_on_behind_panes(std::span<const Ray> rays, std::span<const Eigen::Vector3f> normals,
                          float max_distance, std::span<Hit> hits, int panes_passed) const;

  RTCDevice device;
  // What moves has a scene of its own: it is built anew for every scan, the fixed one never.
  RTCScene fixed = nullptr;
  RTCScene movers = nullptr;  ///< null: nothing moves
  RTCScene firm = nullptr;    ///< the fixed one without leaves; null: it has none
  std::vector<Material> static_materials;
  bool has_panes = false;
  std::vector<Instance> instances;  ///< the index is the geometry's id in `movers`
};

RayCaster::RayCaster(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

void RayCaster::add(const MovingObject& object) {
  impl_->add_instance(object);
  rtcCommitScene(impl_->movers);
}

void RayCaster::set_interval(double begin, double end) {
  if (impl_->instances.empty()) return;
  for (const Impl::Instance& instance : impl_->instances) Impl::place(instance, begin, end);
  rtcCommitScene(impl_->movers);
}

void RayCaster::Impl::cast_packet(std::span<const Ray> rays, float max_distance,
                                  std::span<Hit> hits, int panes_passed) const {
  alignas(64) RTCRayHit16 packet;
  alignas(64) std::array<int, kPacket> valid{};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    valid[i] = -1;
    set_ray(packet, i, rays[i], max_distance);
  }
  for (std::size_t i = rays.size(); i < kPacket; ++i) set_no_ray(packet, i);
  intersect_coherent16(valid.data(), fixed, packet);
  // Rays now end where they met something fixed; only what is nearer takes its place.
  if (movers != nullptr) intersect_coherent16(valid.data(), movers, packet);

  std::array<Eigen::Vector3f, kPacket> normals;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = Hit{};
    if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    const Eigen::Vector3f normal =
        Eigen::Vector3f(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]).normalized();
    normals[i] = normal;
    const unsigned instance = packet.hit.instID[0][i];
    const bool moving = instance != RTC_INVALID_GEOMETRY_ID;
    hits[i].met = moving ? Met::moving : Met::still;
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
    hits[i].cos_incidence = std::min(1.0F, std::abs(normal.dot(direction)));
    const std::vector<Material>& materials =
        moving ? instances[instance].materials : static_materials;
    hits[i].material = materials[packet.hit.primID[i]];
  }
  if (has_panes) {
    go_on_behind_panes(rays, {normals.data(), rays.size()}, max_distance, hits, panes_passed);
  }
}

/// Fresnel's law after Schlick, both faces of a pane together: 8 % when looked at straight.
float pane_reflectance(float cos_incidence) {
  constexpr float kStraight = 0.08F;
  return kStraight + (1.0F - kStraight) * std::pow(1.0F - cos_incidence, 5.0F);
}

void RayCaster::Impl::go_on_behind_panes(std::span<const Ray> rays,
                                         std::span<const Eigen::Vector3f> normals,
                                         float max_distance, std::span<Hit> hits,
                                         int panes_passed) const {
  constexpr int kMostPanes = 6;
  constexpr float kGlint = 0.99996F;  // within 0.5 deg of straight the pane itself shines back
  constexpr float kMirrors = 0.5F;    // what reflects more than this is a mirror, else a window
  constexpr float kClear = 1e-3F;     // the next ray starts this far from the pane [m]
  std::array<Ray, kPacket> onward;
  std::array<std::size_t, kPacket> whose{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool pane = hits[i].valid() && hits[i].material == Material::pane;
    if (!pane || hits[i].met == Met::moving || hits[i].cos_incidence > kGlint) continue;
    const float reflectance = pane_reflectance(hits[i].cos_incidence);
    const bool mirrored = reflectance > kMirrors;
    const float there = mirrored ? reflectance : 1.0F - reflectance;
    Ray& ray = onward[count];
    ray = rays[i];
    ray.origin += hits[i].distance * ray.direction;
    if (mirrored) ray.direction -= 2.0F * normals[i].dot(ray.direction) * normals[i];
    ray.origin += kClear * ray.direction;
    hits[i].passed = there * there;
    hits[i].met = mirrored ? Met::mirrored : Met::still;
    whose[count++] = i;
  }
  if (count == 0) return;
  std::array<Hit, kPacket> behind{};
  if (panes_passed < kMostPanes) {
    cast_packet({onward.data(), count}, max_distance, {behind.data(), count}, panes_passed + 1);
  }
  for (std::size_t k = 0; k < count; ++k) {
    Hit& hit = hits[whose[k]];
    const Hit pane = hit;
    hit = behind[k];
    if (!hit.valid()) continue;
    hit.distance += pane.distance + kClear;
    hit.passed *= pane.passed;
    hit.met = std::max(hit.met, pane.met);
    if (hit.distance > max_distance) hit = Hit{};
  }
}

void RayCaster::cast(std::span<const Ray> rays, float max_distance, std::span<Hit> hits) const {
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - first);
    impl_->cast_packet(rays.subspan(first, count), max_distance, hits.subspan(first, count));
  }
}

std::optional<double> RayCaster::ground_below(const Eigen::Vector3d& point, double depth) const {
  alignas(64) RTCRayHit16 packet;
  alignas(64) std::array<int, kPacket> valid{};
  valid[0] = -1;
  set_ray(packet, 0, {point.cast<float>(), -Eigen::Vector3f::UnitZ(), 0.0F},
          static_cast<float>(depth));
  for (std::size_t i = 1; i < kPacket; ++i) set_no_ray(packet, i);
  intersect_coherent16(valid.data(), impl_->firm == nullptr ? impl_->fixed : impl_->firm, packet);
  if (packet.hit.geomID[0] == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return point.z() - static_cast<double>(packet.ray.tfar[0]);
}

}  // namespace surefoot::simulation
