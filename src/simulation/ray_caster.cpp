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

// Rays at a time. Embree cuts packets of 16 into these where the processor has no vectors of 16.
constexpr std::size_t kPacket = 8;
/// A number of each ray of a packet.
using Lanes = Eigen::Array<float, kPacket, 1>;

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

/// Rays into the first lanes. The others have none: Embree may look at the rays alone, not at their
/// validity, and takes one that ends before it begins for none.
void load(RTCRayHit8& packet, std::span<const Ray> rays, float max_distance) {
  for (std::size_t i = 0; i < kPacket; ++i) {
    const Ray& ray = rays[std::min(i, rays.size() - 1)];
    packet.ray.org_x[i] = ray.origin.x();
    packet.ray.org_y[i] = ray.origin.y();
    packet.ray.org_z[i] = ray.origin.z();
    packet.ray.dir_x[i] = ray.direction.x();
    packet.ray.dir_y[i] = ray.direction.y();
    packet.ray.dir_z[i] = ray.direction.z();
    packet.ray.time[i] = ray.time;
  }
  std::fill_n(packet.ray.tnear, kPacket, 0.0F);
  std::fill_n(packet.ray.tfar, kPacket, -1.0F);
  std::fill_n(packet.ray.tfar, rays.size(), max_distance);
  std::fill_n(packet.ray.mask, kPacket, 0xffffffffU);
  std::fill_n(packet.ray.id, kPacket, 0U);
  std::fill_n(packet.ray.flags, kPacket, 0U);
  std::fill_n(packet.hit.Ng_x, kPacket, 0.0F);
  std::fill_n(packet.hit.Ng_y, kPacket, 0.0F);
  std::fill_n(packet.hit.Ng_z, kPacket, 0.0F);
  std::fill_n(packet.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
  std::fill_n(packet.hit.instID[0], kPacket, RTC_INVALID_GEOMETRY_ID);
}

void intersect(RTCScene scene, std::size_t rays, RTCRayHit8& packet) {
  alignas(32) std::array<int, kPacket> valid{};
  std::fill_n(valid.begin(), rays, -1);
  intersect_coherent8(valid.data(), scene, packet);
}

Eigen::Vector3f unit_normal(const RTCRayHit8& packet, std::size_t i) {
  return Eigen::Vector3f(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]).normalized();
}

/// |cos| of the angle between each ray and the normal of what it met; 0 where it met nothing.
Lanes cosines_of_incidence(const RTCRayHit8& packet) {
  const auto lanes = [](const float* values) { return Eigen::Map<const Lanes>(values); };
  const auto x = lanes(packet.hit.Ng_x);
  const auto y = lanes(packet.hit.Ng_y);
  const auto z = lanes(packet.hit.Ng_z);
  // Eigen's own root of several numbers is not rounded as one of a single number.
  const Lanes length =
      (x * x + (y * y + z * z)).max(std::numeric_limits<float>::min()).unaryExpr([](float square) {
        return std::sqrt(square);
      });
  const Lanes dot = x / length * lanes(packet.ray.dir_x) +
                    (y / length * lanes(packet.ray.dir_y) + z / length * lanes(packet.ray.dir_z));
  return dot.abs().min(1.0F);
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

  explicit Impl(const Scene& scene) : device(new_device()), static_materials(scene.mesh.materials) {
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
    constexpr double kFarthest = 10.0;  // what goes farther in a scan starts anew elsewhere [m]
    std::array<Pose, 2> poses = {instance.T_map_object(begin), instance.T_map_object(end)};
    const double way = (poses[1].translation - poses[0].translation).norm();
    if (way > kFarthest) poses[1] = poses[0];
    for (unsigned step = 0; step < 2; ++step) {
      const auto matrix = column_major_3x4(poses.at(step));
      rtcSetGeometryTransform(instance.geometry, step, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                              matrix.data());
    }
    rtcCommitGeometry(instance.geometry);
  }

  void cast_packet(std::span<const Ray> rays, float max_distance, std::span<Hit> hits,
                   int panes_passed = 0) const;
  void go_on_behind_panes(std::span<const Ray> rays, const RTCRayHit8& packet, float max_distance,
                          std::span<Hit> hits, int panes_passed) const;
  static float cos_to_moving(const Ray& ray, const Eigen::Vector3f& normal,
                             const Instance& instance);

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
  alignas(32) RTCRayHit8 packet;
  load(packet, rays, max_distance);
  intersect(fixed, rays.size(), packet);
  // Rays now end where they met something fixed; only what is nearer takes its place.
  if (movers != nullptr) intersect(movers, rays.size(), packet);

  const Lanes cosines = cosines_of_incidence(packet);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = Hit{};
    if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    hits[i].distance = packet.ray.tfar[i];
    const unsigned instance = packet.hit.instID[0][i];
    if (instance == RTC_INVALID_GEOMETRY_ID) {
      hits[i].cos_incidence = cosines[static_cast<Eigen::Index>(i)];
      hits[i].material = static_materials[packet.hit.primID[i]];
    } else {
      hits[i].met = Met::moving;
      hits[i].cos_incidence = cos_to_moving(rays[i], unit_normal(packet, i), instances[instance]);
      hits[i].material = instances[instance].materials[packet.hit.primID[i]];
    }
  }
  if (has_panes) go_on_behind_panes(rays, packet, max_distance, hits, panes_passed);
}

/// A normal met inside an instance is in the object's frame, so the ray must be too; objects only
/// turn about the vertical or not at all, and the ratio needs the rotation alone.
float RayCaster::Impl::cos_to_moving(const Ray& ray, const Eigen::Vector3f& normal,
                                     const Instance& instance) {
  std::array<float, 12> matrix{};
  rtcGetGeometryTransform(instance.geometry, ray.time, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                          matrix.data());
  const Eigen::Map<const Eigen::Matrix<float, 3, 4>> T_map_object(matrix.data());
  const Eigen::Vector3f direction = T_map_object.leftCols<3>().transpose() * ray.direction;
  return std::min(1.0F, std::abs(normal.dot(direction)));
}

/// Fresnel's law after Schlick, both faces of a pane together: 8 % when looked at straight.
float pane_reflectance(float cos_incidence) {
  constexpr float kStraight = 0.08F;
  return kStraight + (1.0F - kStraight) * std::pow(1.0F - cos_incidence, 5.0F);
}

void RayCaster::Impl::go_on_behind_panes(std::span<const Ray> rays, const RTCRayHit8& packet,
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
    if (mirrored) {
      const Eigen::Vector3f normal = unit_normal(packet, i);
      ray.direction -= 2.0F * normal.dot(ray.direction) * normal;
    }
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
  const Ray down{point.cast<float>(), -Eigen::Vector3f::UnitZ(), 0.0F};
  alignas(32) RTCRayHit8 packet;
  load(packet, {&down, 1}, static_cast<float>(depth));
  intersect(impl_->firm == nullptr ? impl_->fixed : impl_->firm, 1, packet);
  if (packet.hit.geomID[0] == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return point.z() - static_cast<double>(packet.ray.tfar[0]);
}

}  // namespace surefoot::simulation
