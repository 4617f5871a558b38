#include <algorithm>

#include "host/scene/builtin/hall_parts.h"
#include "host/scene/builtin/procedural_textures.h"

namespace host::hall {
namespace {

using modelling::SceneBuilder;
using modelling::tiled;
using textures::Pattern;

constexpr int kCoarse = 256;  // pixels
constexpr int kFine = 512;

const glm::vec3 kLimestone(0.87f, 0.81f, 0.7f);  // sRGB

struct Finish {
  const char* name;
  Pattern pattern;
  float metres;  ///< of one repeat
  float roughness;
  int size = kCoarse;
  bool relief = false;  ///< with a normal map
  bool doubleSided = false;
};

int add(SceneBuilder& builder, const Finish& finish) {
  Material material;
  material.name = finish.name;
  material.metallic = 0.0f;
  material.roughness = finish.roughness;
  material.doubleSided = finish.doubleSided;
  const int color = builder.addImage(textures::baseColorImage(finish.name, finish.size, finish.pattern));
  material.baseColorTexture = tiled(color, finish.metres);
  if (finish.relief) {
    const std::string name = std::string(finish.name) + " relief";
    material.normalTexture =
        tiled(builder.addImage(textures::normalImage(name, finish.size, finish.pattern)), finish.metres);
  }
  return builder.addMaterial(std::move(material));
}

int addPlain(SceneBuilder& builder, const char* name, glm::vec3 linear, float metallic, float roughness,
             glm::vec3 emissive = glm::vec3(0.0f)) {
  Material material;
  material.name = name;
  material.baseColor = glm::vec4(linear, 1.0f);
  material.metallic = metallic;
  material.roughness = roughness;
  material.emissive = emissive;
  return builder.addMaterial(std::move(material));
}

Pattern ashlar() {
  const textures::Masonry courses{.blocks = {2, 4},
                                  .joint = 0.0035f,
                                  .stagger = 0.5f,
                                  .shadeVariation = 0.16f,
                                  .jointColor = {0.66f, 0.6f, 0.51f}};
  return textures::masonry(courses, textures::plaster(kLimestone, 0.22f, 3), 5);
}

Pattern floorTiles() {
  return textures::checker(4, textures::marble({0.86f, 0.79f, 0.68f}, {0.58f, 0.5f, 0.41f}, 0.35f, 11),
                           textures::marble({0.45f, 0.37f, 0.3f}, {0.65f, 0.57f, 0.48f}, 0.35f, 12),
                           {0.4f, 0.37f, 0.33f});
}

/// Blue cloth 1.2 m wide with a golden stripe along both borders.
Pattern bannerCloth() {
  const Pattern blue = textures::fabric({0.16f, 0.24f, 0.46f}, {0.12f, 0.18f, 0.38f}, 128, 16);
  const Pattern gold = textures::fabric({0.8f, 0.63f, 0.28f}, {0.62f, 0.46f, 0.18f}, 128, 18);
  return [=](glm::vec2 uv) {
    const float fromBorder = std::min(uv.x, 1.0f - uv.x);
    return fromBorder > 0.05f && fromBorder < 0.12f ? gold(uv) : blue(uv);
  };
}

}  // namespace

Materials addMaterials(SceneBuilder& builder) {
  Materials m{};
  m.ashlar = add(builder, {"ashlar", ashlar(), 2.2f, 0.85f, kFine, true});
  m.dressed =
      add(builder, {"dressed limestone", textures::plaster(kLimestone * 1.03f, 0.14f, 7), 1.5f, 0.75f});
  m.shaft =
      add(builder, {"column marble",
                    textures::marble({0.64f, 0.53f, 0.46f}, {0.82f, 0.75f, 0.67f}, 0.35f, 17), 1.6f, 0.3f});
  m.vault = add(builder, {"vault plaster", textures::plaster({0.79f, 0.82f, 0.83f}, 0.12f, 8), 3.0f, 0.9f});
  m.paleMarble = add(
      builder,
      {"pale marble", textures::marble({0.92f, 0.9f, 0.86f}, {0.66f, 0.63f, 0.6f}, 0.25f, 9), 1.2f, 0.35f});
  m.floor = add(builder, {"floor tiles", floorTiles(), 2.4f, 0.3f, kFine, true});
  m.redMarble = add(
      builder,
      {"red marble", textures::marble({0.45f, 0.27f, 0.23f}, {0.72f, 0.6f, 0.53f}, 0.4f, 10), 1.0f, 0.3f});
  m.oak =
      add(builder, {"oak", textures::wood({0.56f, 0.44f, 0.32f}, {0.36f, 0.26f, 0.18f}, 1, 13), 1.0f, 0.55f});
  m.bronze = addPlain(builder, "bronze", {0.42f, 0.28f, 0.12f}, 1.0f, 0.4f);
  m.iron = addPlain(builder, "iron", {0.06f, 0.06f, 0.065f}, 0.0f, 0.6f);
  m.carpet = add(builder, {"carpet", textures::fabric({0.5f, 0.09f, 0.1f}, {0.42f, 0.06f, 0.09f}, 64, 14),
                           0.5f, 0.95f, kCoarse, true});
  m.carpetBorder = add(
      builder,
      {"carpet border", textures::fabric({0.72f, 0.56f, 0.25f}, {0.5f, 0.35f, 0.15f}, 64, 15), 0.5f, 0.95f});
  m.banner = add(builder, {"banner", bannerCloth(), 1.2f, 0.9f, kCoarse, false, true});
  m.wax = addPlain(builder, "wax", {0.86f, 0.8f, 0.66f}, 0.0f, 0.6f);
  m.flame = addPlain(builder, "flame", {1.0f, 0.7f, 0.3f}, 0.0f, 1.0f, {6.0f, 3.6f, 1.4f});
  return m;
}

}  // namespace host::hall
