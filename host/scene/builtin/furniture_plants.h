// Plants in pots, standing on y = 0, and cut flowers.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

struct PlantShape {
  float height = 1.4f;  ///< from the floor to the highest leaves
  float potRadius = 0.17f;
  int stems = 5;
  int leavesPerStem = 14;
  float leafLength = 0.2f;
  float leafWidth = 0.09f;
  glm::ivec2 leafSegments{4, 8};   ///< across and along
  glm::ivec2 stemSegments{6, 10};  ///< around and along
  int potSegments = 36;
  Finish leaves = Finish::leaf;
  Finish pot = Finish::terracotta;
  std::uint32_t seed = 1;
};

/// Stems that fan out of a pot and bear leaves in a spiral.
Piece pottedPlant(const PlantShape& shape);

/// A vase with a bunch of flowers.
Piece vaseWithFlowers(int flowers, std::uint32_t seed);

}  // namespace host::furniture
