#include "host/renderer/scene/gpu_scene.h"

#include "host/renderer/render_state.h"

namespace host {

using Cull = RenderState::Cull;

GpuScene::GpuScene(const Scene& scene)
    : geometry_(scene.meshes), materials_(scene), instances_(scene, geometry_, materials_) {}

void GpuScene::draw(const DrawList& list, Sides sides) const {
  if (list.empty()) return;
  geometry_.begin(list.instances);
  int bound = -1;
  for (const DrawCommand& command : list.commands) {
    if (command.material != bound) materials_.bind(command.material);
    bound = command.material;
    setMirrored(command.mirrored);
    drawSides(command, sides);
  }
}

void GpuScene::drawSides(const DrawCommand& command, Sides sides) const {
  const auto drawCulling = [&](Cull cull) {
    apply(cull);
    geometry_.draw(command.mesh, command.firstInstance, command.instanceCount);
  };
  const bool doubleSided = materials_.isDoubleSided(command.material);
  if (sides == Sides::backThenFront && doubleSided) {
    drawCulling(Cull::front);
    drawCulling(Cull::back);
  } else {
    drawCulling(doubleSided || sides == Sides::both ? Cull::none : Cull::back);
  }
}

}  // namespace host
