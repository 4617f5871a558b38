#pragma once

#include "mres/gl/object.h"

namespace mres::gl {

/// Draws one triangle that covers the viewport, without vertex buffers (vertex shader
/// common/full_screen.vert).
class FullScreenTriangle {
 public:
  FullScreenTriangle() : vertexArray_(VertexArrayName::create()) {}
  void draw() const {
    glBindVertexArray(vertexArray_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  VertexArrayName vertexArray_;
};

}  // namespace mres::gl
