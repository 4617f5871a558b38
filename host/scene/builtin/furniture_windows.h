// Windows and what hangs before them. A window stands on y = 0 in the plane z = 0 and faces +Z, into the
// room.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

/// Frame, casements with glazing bars, handles, inner sill board. `reveal` is how far the plane z = 0 lies
/// behind the inner face of the wall.
struct WindowShape {
  glm::vec2 size{1.5f, 1.5f};
  int casements = 2;
  glm::ivec2 panes{2, 3};  ///< of each casement
  float reveal = 0.16f;
  float bevel = 0.004f;  ///< of all edges; 0 is plain, for windows that nobody comes close to
};
Piece mullionedWindow(const WindowShape& shape);

/// A venetian blind of `size` hanging down from the top; the slats are turned by `slatDegrees` (0 is open, 80
/// shut) and gathered at the bottom when the blind is drawn up to `drop` (1 is all the way down).
struct BlindShape {
  glm::vec2 size{1.5f, 1.5f};
  float slatDegrees = 30.0f;
  float drop = 1.0f;
};
Piece venetianBlind(const BlindShape& shape);

/// A drawn curtain with soft folds, from the rings at its top (y = `height`) down; `gather` in 0..1 narrows
/// its middle as a tie-back does. Its middle is x = 0.
struct CurtainShape {
  float width = 0.6f;
  float height = 2.4f;
  int folds = 8;
  float foldDepth = 0.045f;
  float gather = 0.0f;
  std::uint32_t seed = 1;
};
Piece curtain(const CurtainShape& shape);

/// Where the middle of the rail lies above a curtain's height: it hangs in the tops of its rings.
constexpr float kRailAboveCurtain = 0.025f;

/// A round rail of `width` with finials and brackets to the wall `standOff` behind it, at y = 0.
Piece curtainRail(float width, float standOff);

}  // namespace host::furniture
