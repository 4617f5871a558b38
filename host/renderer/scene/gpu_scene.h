#pragma once

#include "host/renderer/scene/instance_set.h"

namespace host {

/// A scene on the GPU, and how its instances are drawn.
class GpuScene {
 public:
  explicit GpuScene(const Scene& scene);

  /// How a pass treats the two sides of the surfaces.
  enum class Sides {
    asMaterial,    ///< back faces are culled unless the material is double-sided
    both,          ///< nothing is culled
    backThenFront  ///< double-sided materials draw their back faces first: for blending
  };

  /// Draws a list with the program in use (connected by MaterialStore::connect).
  void draw(const DrawList& list, Sides sides) const;

  [[nodiscard]] const InstanceSet& instances() const { return instances_; }
  [[nodiscard]] GLuint white() const { return materials_.white(); }
  [[nodiscard]] std::size_t bytes() const { return geometry_.bytes() + materials_.bytes(); }

 private:
  void drawSides(const DrawCommand& command, Sides sides) const;

  GeometryStore geometry_;
  MaterialStore materials_;
  InstanceSet instances_;
};

}  // namespace host
