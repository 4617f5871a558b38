#include "host/truth/ray_scene.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <stdexcept>
#include <vector>

#include "host/truth/alpha_mask.h"

namespace host {
namespace {

template <auto release>
struct Release {
  template <class Object>
  void operator()(Object* object) const {
    release(object);
  }
};

using DeviceHandle = std::unique_ptr<RTCDeviceTy, Release<rtcReleaseDevice>>;
using SceneHandle = std::unique_ptr<RTCSceneTy, Release<rtcReleaseScene>>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, Release<rtcReleaseGeometry>>;

constexpr int kPacket = 8;  // rays that Embree takes at once

/// Lets rays pass through the holes of an AlphaMask.
void passHoles(const RTCFilterFunctionNArguments* arguments) {
  const auto& mask = *static_cast<const AlphaMask*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] != -1) continue;
    const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
    const float u = RTCHitN_u(arguments->hit, arguments->N, i);
    const float v = RTCHitN_v(arguments->hit, arguments->N, i);
    if (mask.isHole(triangle, u, v)) arguments->valid[i] = 0;
  }
}

AlphaMode alphaModeOf(const Scene& scene, const Mesh& mesh) {
  return mesh.material < 0 ? AlphaMode::opaque
                           : scene.materials.at(static_cast<std::size_t>(mesh.material)).alphaMode;
}

void requireSuccess(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  throw std::runtime_error(
      fmt::format("Embree cannot trace rays through the scene (its error {}){}.", static_cast<int>(error),
                  error == RTC_ERROR_OUT_OF_MEMORY ? ": there is too little memory" : ""));
}

}  // namespace

struct RayScene::Geometry {
  explicit Geometry(const Scene& scene);

  [[nodiscard]] SceneHandle newScene() const;
  SceneHandle sceneOf(const Scene& scene, const Mesh& mesh);
  void attach(RTCScene scene, const GeometryHandle& geometry) const;

  DeviceHandle device{rtcNewDevice(nullptr)};
  std::deque<AlphaMask> masks;      // Embree keeps their addresses
  std::vector<SceneHandle> meshes;  // null for those that no ray meets
  SceneHandle whole;
};

RayScene::Geometry::Geometry(const Scene& scene) : whole(newScene()) {
  for (const Mesh& mesh : scene.meshes) meshes.push_back(sceneOf(scene, mesh));
  for (const Instance& instance : scene.instances) {
    const SceneHandle& mesh = meshes.at(static_cast<std::size_t>(instance.mesh));
    if (!mesh) continue;
    const GeometryHandle placed(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
    rtcSetGeometryInstancedScene(placed.get(), mesh.get());
    rtcSetGeometryTransform(placed.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &instance.transform[0][0]);
    attach(whole.get(), placed);
  }
  rtcCommitScene(whole.get());
  requireSuccess(device.get());
}

/// Robust: no ray slips through between two triangles.
SceneHandle RayScene::Geometry::newScene() const {
  SceneHandle scene(rtcNewScene(device.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  return scene;
}

/// The vertices stay where they are; Embree may read sixteen bytes at a position, and a Vertex is larger.
SceneHandle RayScene::Geometry::sceneOf(const Scene& scene, const Mesh& mesh) {
  static_assert(offsetof(Vertex, position) == 0 && sizeof(Vertex) >= 16);
  const AlphaMode alphaMode = alphaModeOf(scene, mesh);
  if (mesh.indices.empty() || alphaMode == AlphaMode::blend) return nullptr;
  const GeometryHandle triangles(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  rtcSetSharedGeometryBuffer(triangles.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.vertices.data(), 0, sizeof(Vertex), mesh.vertices.size());
  rtcSetSharedGeometryBuffer(triangles.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(),
                             0, 3 * sizeof(mesh.indices[0]), mesh.indices.size() / 3);
  if (alphaMode == AlphaMode::mask) {
    rtcSetGeometryUserData(triangles.get(), &masks.emplace_back(scene, mesh));
    rtcSetGeometryOccludedFilterFunction(triangles.get(), passHoles);
  }
  SceneHandle built = newScene();
  attach(built.get(), triangles);
  rtcCommitScene(built.get());
  return built;
}

void RayScene::Geometry::attach(RTCScene scene, const GeometryHandle& geometry) const {
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene, geometry.get());
}

RayScene::RayScene(const Scene& scene) : geometry_(std::make_unique<Geometry>(scene)) {
  RTCBounds bounds{};
  rtcGetSceneBounds(geometry_->whole.get(), &bounds);
  const glm::vec3 extent(bounds.upper_x - bounds.lower_x, bounds.upper_y - bounds.lower_y,
                         bounds.upper_z - bounds.lower_z);
  diameter_ = glm::length(glm::max(extent, 0.0f));  // that of nothing is infinitely negative
}

RayScene::~RayScene() = default;

int RayScene::countBlocked(glm::vec3 origin, std::span<const glm::vec3> segments) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  int blocked = 0;
  for (std::size_t first = 0; first < segments.size(); first += kPacket) {
    const std::size_t count = std::min<std::size_t>(kPacket, segments.size() - first);
    alignas(32) int valid[kPacket] = {};
    RTCRay8 rays{};
    for (std::size_t i = 0; i < count; ++i) {
      valid[i] = -1;
      rays.org_x[i] = origin.x;
      rays.org_y[i] = origin.y;
      rays.org_z[i] = origin.z;
      rays.dir_x[i] = segments[first + i].x;
      rays.dir_y[i] = segments[first + i].y;
      rays.dir_z[i] = segments[first + i].z;
      rays.tfar[i] = 1.0f;
      rays.mask[i] = ~0u;
    }
    rtcOccluded8(valid, geometry_->whole.get(), &context, &rays);
    // Embree marks a ray that meets something by a length of minus infinity.
    blocked +=
        static_cast<int>(std::count_if(rays.tfar, rays.tfar + count, [](float t) { return t < 0.0f; }));
  }
  return blocked;
}

}  // namespace host
