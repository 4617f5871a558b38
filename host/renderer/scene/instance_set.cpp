#include "host/renderer/scene/instance_set.h"

#include <algorithm>
#include <tuple>

namespace host {
namespace {

auto groupOf(const auto& drawn) {
  return std::tie(drawn.material, drawn.mesh, drawn.mirrored);
}

}  // namespace

InstanceSet::InstanceSet(const Scene& scene, const GeometryStore& geometry, const MaterialStore& materials) {
  bool first = true;
  for (const Instance& instance : scene.instances) {
    if (geometry.isEmpty(instance.mesh)) continue;
    const int named = scene.meshes[static_cast<std::size_t>(instance.mesh)].material;
    const int material = named < 0 ? materials.defaultMaterial() : named;
    const bool mirrored = glm::determinant(glm::mat3(instance.transform)) < 0.0f;
    const Bounds box = transformed(geometry.bounds(instance.mesh), instance.transform);
    auto& group = materials.isBlended(material) ? blended_ : opaque_;
    group.push_back({instance.mesh, material, mirrored, instance.transform, box});
    bounds_ = first ? box : Bounds{glm::min(bounds_.min, box.min), glm::max(bounds_.max, box.max)};
    first = false;
  }
  std::ranges::stable_sort(opaque_, [](const Placed& a, const Placed& b) { return groupOf(a) < groupOf(b); });
}

InstanceData InstanceSet::relative(const Placed& instance, glm::vec3 origin) {
  glm::mat4 rows = instance.transform;
  rows[3] -= glm::vec4(origin, 0.0f);
  rows = glm::transpose(rows);
  return {rows[0], rows[1], rows[2]};
}

void InstanceSet::appendCommand(DrawList& list, const Placed& instance, glm::vec3 origin) {
  list.commands.push_back({instance.mesh, instance.material, instance.mirrored, list.instances.size(), 1});
  list.instances.push_back(relative(instance, origin));
}

DrawList InstanceSet::opaque(const Frustum& frustum, glm::vec3 origin) const {
  DrawList list;
  for (const Placed& instance : opaque_) {
    if (!frustum.mayIntersect(moved(instance.bounds, -origin))) continue;
    if (list.empty() || groupOf(list.commands.back()) != groupOf(instance)) {
      appendCommand(list, instance, origin);
    } else {
      list.instances.push_back(relative(instance, origin));
      ++list.commands.back().instanceCount;
    }
  }
  return list;
}

DrawList InstanceSet::blended(const CameraView& view) const {
  struct Seen {
    const Placed* instance;
    float depth;
  };
  std::vector<Seen> seen;
  const Frustum frustum = view.frustum();
  for (const Placed& instance : blended_) {
    const Bounds box = moved(instance.bounds, -view.origin);
    if (frustum.mayIntersect(box)) seen.push_back({&instance, glm::dot(box.min + box.max, view.forward)});
  }
  std::ranges::stable_sort(seen, std::ranges::greater{}, &Seen::depth);
  DrawList list;
  for (const Seen& entry : seen) appendCommand(list, *entry.instance, view.origin);
  return list;
}

}  // namespace host
