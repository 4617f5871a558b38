#pragma once

#include <vector>

#include "host/renderer/scene/geometry_store.h"

namespace host {

/// Instances of one mesh, drawn by one call.
struct DrawCommand {
  int mesh = 0;
  int material = 0;
  bool mirrored = false;
  std::size_t firstInstance = 0;
  std::size_t instanceCount = 0;
};

/// What one pass draws: commands in the order of drawing, and the stream of instances that they refer to.
struct DrawList {
  std::vector<DrawCommand> commands;
  std::vector<InstanceData> instances;
  [[nodiscard]] bool empty() const { return commands.empty(); }
};

}  // namespace host
