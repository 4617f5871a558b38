// The openings of the hall's outside: where they are, and what fills them.
#pragma once

#include "host/scene/builtin/hall_measures.h"
#include "host/scene/scene.h"

namespace host::hall {

/// An opening with a round arch, upright in the plane x = 0, centred on z = 0.
struct Opening {
  float sill;
  float springing;
  float halfWidth;

  [[nodiscard]] constexpr float crown() const { return springing + halfWidth; }
};

constexpr Opening kAisleWindow{1.5f, 4.15f, 1.0f};
constexpr Opening kGalleryWindow{7.95f, 10.1f, 1.0f};
constexpr Opening kEndWindow{4.7f, 9.0f, 1.3f};      ///< the middle one of three over the stairs
constexpr Opening kEndSideWindow{4.7f, 8.2f, 0.9f};  ///< its neighbours
constexpr float kEndSideWindowOffset = 3.3f;         ///< |x| of their middles
constexpr Opening kDoor{0.0f, 3.4f, 1.5f};
constexpr float kRoseHeight = 9.0f;
constexpr float kRoseRadius = 2.1f;
constexpr float kReveal = 0.55f;  ///< from a wall's inner face to the middle of what fills its opening

/// Stone frame, two lancets and a ring, +-x being the depth.
void addTracery(Mesh& mesh, const Opening& opening);

/// Roll mouldings around an opening with an arch, on the wall's inner face, from the height `foot` up.
void addSurround(Mesh& mesh, const Opening& opening, float foot);

/// Thin bars that hold the (absent) leaded glass.
void addGlazingBars(Mesh& mesh, const Opening& opening);

}  // namespace host::hall
