// The surfaces of the furnished scenes: what each is called, looks like and how large its texture is.
#pragma once

#include "host/scene/builtin/modelling.h"

namespace host::furniture {

enum class Finish {
  // Room
  wallPaint,
  wallAccent,
  ceilingPaint,
  trimPaint,
  ceilingTile,
  carpet,
  parquetLight,
  parquetMedium,
  parquetDark,
  outsideWall,
  // Wood
  oak,
  walnut,
  beech,
  whiteLacquer,
  // Metal
  chrome,
  silver,
  brass,
  paintedSteel,
  darkSteel,
  // Plastic and glass
  blackPlastic,
  greyPlastic,
  keycap,
  screen,
  lampGlow,
  blindSlat,
  bulb,
  // Ceramics
  porcelain,
  blueGlaze,
  sageGlaze,
  terracotta,
  // Cloth and paper
  linen,
  curtain,
  chairFabric,
  cushionFabric,
  napkin,
  runner,
  rug,
  rugBorder,
  fringe,
  lampShade,
  paper,
  pages,
  cork,
  coverRed,
  coverBlue,
  coverGreen,
  coverCream,
  coverBlack,
  coverOchre,
  picture,
  // Living things and food
  leaf,
  paleLeaf,
  stem,
  bark,
  soil,
  petal,
  apple,
  orange,
  lemon,
  pear,
  crust,
  wicker,
  tea,
};

/// Adds the material of `finish`, with its textures, and returns its index.
int addFinish(modelling::SceneBuilder& builder, Finish finish);

}  // namespace host::furniture
