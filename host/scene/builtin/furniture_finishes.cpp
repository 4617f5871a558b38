#include "host/scene/builtin/furniture_finishes.h"

#include <map>
#include <stdexcept>

#include "host/scene/builtin/furniture_patterns.h"

namespace host::furniture {

namespace {

using textures::Pattern;

constexpr int kTextureSize = 256;

/// How a finish is made: a colour alone, or a pattern with one repeat every so many metres.
struct Recipe {
  std::string name;
  glm::vec3 color{1.0f};  ///< sRGB; the pattern's colours are used as they are where there is one
  float roughness = 0.5f;
  float metallic = 0.0f;
  Pattern pattern = nullptr;
  glm::vec2 metres{1.0f};
  float relief = 0.0f;  ///< scale of the normal map; 0 is none
  glm::vec3 emissive{0.0f};
  bool doubleSided = false;
};

glm::vec3 linearOf(glm::vec3 srgb) {
  return glm::pow(srgb, glm::vec3(2.2f));
}

Recipe plain(std::string name, glm::vec3 color, float roughness) {
  Recipe recipe;
  recipe.name = std::move(name);
  recipe.color = color;
  recipe.roughness = roughness;
  return recipe;
}

Recipe metal(std::string name, glm::vec3 color, float roughness) {
  Recipe recipe = plain(std::move(name), color, roughness);
  recipe.metallic = 1.0f;
  return recipe;
}

Recipe patterned(std::string name, Pattern pattern, glm::vec2 metres, float roughness, float relief = 0.0f) {
  Recipe recipe = plain(std::move(name), glm::vec3(1.0f), roughness);
  recipe.pattern = std::move(pattern);
  recipe.metres = metres;
  recipe.relief = relief;
  return recipe;
}

Recipe bothSides(Recipe recipe) {
  recipe.doubleSided = true;
  return recipe;
}

Recipe glowing(Recipe recipe, glm::vec3 radiance) {
  recipe.emissive = radiance;
  return recipe;
}

using Recipes = std::map<Finish, Recipe>;

void addRoomRecipes(Recipes& r) {
  using textures::fabric;
  using textures::plaster;
  using textures::wood;
  r[Finish::wallPaint] =
      patterned("wall paint", plaster({0.93f, 0.92f, 0.89f}, 0.04f, 1), glm::vec2(1.6f), 0.9f, 0.4f);
  r[Finish::wallAccent] =
      patterned("sage wall", plaster({0.74f, 0.78f, 0.7f}, 0.05f, 2), glm::vec2(1.6f), 0.9f, 0.4f);
  r[Finish::ceilingPaint] = plain("ceiling paint", glm::vec3(0.93f), 0.95f);
  r[Finish::trimPaint] = plain("trim paint", {0.93f, 0.92f, 0.89f}, 0.45f);
  r[Finish::ceilingTile] = patterned("ceiling tile", acousticTile(), glm::vec2(0.6f), 0.95f, 0.6f);
  r[Finish::carpet] = patterned("carpet", mottled({0.47f, 0.485f, 0.5f}, {0.58f, 0.59f, 0.6f}, 64, 0.02f, 3),
                                glm::vec2(0.8f), 1.0f, 0.7f);
  r[Finish::parquetLight] =
      patterned("light oak block", wood({0.76f, 0.59f, 0.41f}, {0.66f, 0.48f, 0.31f}, 1, 4),
                glm::vec2(0.8f, 0.24f), 0.38f, 0.3f);
  r[Finish::parquetMedium] =
      patterned("medium oak block", wood({0.69f, 0.52f, 0.34f}, {0.58f, 0.41f, 0.26f}, 1, 5),
                glm::vec2(0.8f, 0.24f), 0.38f, 0.3f);
  r[Finish::parquetDark] =
      patterned("dark oak block", wood({0.61f, 0.44f, 0.28f}, {0.5f, 0.35f, 0.21f}, 1, 6),
                glm::vec2(0.8f, 0.24f), 0.38f, 0.3f);
  r[Finish::outsideWall] = plain("outside wall", {0.8f, 0.77f, 0.72f}, 0.9f);
}

void addWoodAndMetalRecipes(Recipes& r) {
  using textures::wood;
  r[Finish::oak] =
      patterned("oak", wood({0.78f, 0.64f, 0.48f}, {0.67f, 0.52f, 0.37f}, 1, 7), {0.9f, 0.3f}, 0.5f, 0.3f);
  r[Finish::walnut] = patterned("walnut", wood({0.56f, 0.42f, 0.32f}, {0.43f, 0.31f, 0.23f}, 1, 8),
                                {0.9f, 0.3f}, 0.42f, 0.3f);
  r[Finish::beech] =
      patterned("beech", wood({0.84f, 0.7f, 0.53f}, {0.77f, 0.61f, 0.44f}, 1, 9), {1.2f, 0.4f}, 0.45f);
  r[Finish::whiteLacquer] = plain("white lacquer", glm::vec3(0.88f), 0.35f);
  r[Finish::chrome] = metal("chrome", glm::vec3(0.82f), 0.15f);
  r[Finish::silver] = metal("silver", {0.93f, 0.91f, 0.87f}, 0.22f);
  r[Finish::brass] = metal("brass", {0.86f, 0.76f, 0.56f}, 0.32f);
  r[Finish::paintedSteel] = plain("painted steel", {0.86f, 0.87f, 0.87f}, 0.4f);
  r[Finish::darkSteel] = plain("dark steel", {0.33f, 0.34f, 0.35f}, 0.45f);
  r[Finish::blackPlastic] = plain("black plastic", glm::vec3(0.22f), 0.5f);
  r[Finish::greyPlastic] = plain("grey plastic", glm::vec3(0.48f), 0.5f);
  r[Finish::keycap] = plain("keycap", glm::vec3(0.34f), 0.6f);
  r[Finish::blindSlat] = bothSides(plain("blind slat", {0.9f, 0.89f, 0.86f}, 0.4f));
  r[Finish::screen] = glowing(patterned("screen", screenPicture(), {0.5f, 0.3125f}, 0.25f), glm::vec3(1.3f));
  r[Finish::lampGlow] = glowing(plain("lamp glow", glm::vec3(0.95f), 0.6f), {2.2f, 2.1f, 1.9f});
  r[Finish::bulb] = glowing(plain("bulb", glm::vec3(0.95f), 0.5f), {3.2f, 2.6f, 1.8f});
}

void addCeramicAndClothRecipes(Recipes& r) {
  using textures::fabric;
  r[Finish::porcelain] = plain("porcelain", {0.93f, 0.92f, 0.89f}, 0.15f);
  r[Finish::blueGlaze] = plain("blue glaze", {0.34f, 0.45f, 0.56f}, 0.18f);
  r[Finish::sageGlaze] = plain("sage glaze", {0.68f, 0.74f, 0.65f}, 0.22f);
  r[Finish::terracotta] =
      patterned("terracotta", mottled({0.72f, 0.42f, 0.28f}, {0.78f, 0.49f, 0.35f}, 16, 0.01f, 10),
                glm::vec2(0.4f), 0.85f);
  r[Finish::linen] = patterned("linen", fabric({0.9f, 0.88f, 0.82f}, {0.86f, 0.83f, 0.76f}, 64, 11),
                               glm::vec2(0.12f), 0.95f, 0.5f);
  r[Finish::curtain] =
      bothSides(patterned("curtain cloth", fabric({0.9f, 0.87f, 0.79f}, {0.86f, 0.82f, 0.74f}, 48, 12),
                          glm::vec2(0.16f), 0.95f, 0.4f));
  r[Finish::chairFabric] =
      patterned("chair fabric", fabric({0.34f, 0.38f, 0.43f}, {0.28f, 0.32f, 0.37f}, 48, 13),
                glm::vec2(0.12f), 0.95f, 0.7f);
  r[Finish::cushionFabric] =
      patterned("cushion fabric", fabric({0.52f, 0.6f, 0.62f}, {0.45f, 0.53f, 0.56f}, 48, 14),
                glm::vec2(0.12f), 0.95f, 0.6f);
  r[Finish::napkin] =
      bothSides(patterned("napkin cloth", fabric({0.8f, 0.54f, 0.46f}, {0.84f, 0.61f, 0.53f}, 48, 15),
                          glm::vec2(0.08f), 0.95f, 0.4f));
  r[Finish::runner] =
      bothSides(patterned("runner cloth", fabric({0.87f, 0.84f, 0.76f}, {0.82f, 0.79f, 0.72f}, 48, 26),
                          glm::vec2(0.14f), 0.95f, 0.5f));
  r[Finish::rug] = patterned("rug field", rugField({0.64f, 0.34f, 0.29f}), {0.5f, 0.5f}, 1.0f, 0.6f);
  r[Finish::rugBorder] =
      patterned("rug border", mottled({0.27f, 0.32f, 0.41f}, {0.33f, 0.38f, 0.47f}, 64, 0.004f, 16),
                glm::vec2(0.3f), 1.0f, 0.5f);
  r[Finish::fringe] = plain("cotton cord", {0.88f, 0.84f, 0.75f}, 0.95f);
  r[Finish::lampShade] =
      bothSides(glowing(patterned("lamp shade", fabric({0.93f, 0.88f, 0.76f}, {0.9f, 0.84f, 0.71f}, 48, 17),
                                  glm::vec2(0.16f), 0.9f),
                        {0.28f, 0.23f, 0.15f}));
  r[Finish::wicker] = patterned("wicker", fabric({0.7f, 0.51f, 0.31f}, {0.6f, 0.42f, 0.24f}, 10, 18),
                                glm::vec2(0.12f), 0.75f, 1.0f);
}

void addPaperRecipes(Recipes& r) {
  using textures::fabric;
  const auto cover = [](const char* name, glm::vec3 color, std::uint32_t seed) {
    return patterned(name, fabric(color, color * 0.92f, 96, seed), glm::vec2(0.1f), 0.7f);
  };
  r[Finish::paper] = patterned("paper", printedPage(), {0.21f, 0.297f}, 0.9f);
  r[Finish::pages] = plain("page edges", {0.87f, 0.83f, 0.73f}, 0.95f);
  r[Finish::cork] = patterned("cork", mottled({0.58f, 0.41f, 0.26f}, {0.75f, 0.58f, 0.4f}, 48, 0.01f, 19),
                              glm::vec2(0.4f), 0.95f, 0.5f);
  r[Finish::coverRed] = cover("red cover", {0.6f, 0.3f, 0.27f}, 20);
  r[Finish::coverBlue] = cover("blue cover", {0.31f, 0.39f, 0.5f}, 21);
  r[Finish::coverGreen] = cover("green cover", {0.34f, 0.46f, 0.38f}, 22);
  r[Finish::coverCream] = cover("cream cover", {0.84f, 0.78f, 0.65f}, 23);
  r[Finish::coverBlack] = cover("black cover", {0.28f, 0.28f, 0.29f}, 24);
  r[Finish::coverOchre] = cover("ochre cover", {0.76f, 0.52f, 0.2f}, 25);
  r[Finish::picture] = patterned("painting", landscape(), {0.7f, 0.5f}, 0.6f, 0.5f);
}

void addLivingRecipes(Recipes& r) {
  const auto spotted = [](const char* name, glm::vec3 a, glm::vec3 b, float metres, float roughness,
                          float relief, std::uint32_t seed) {
    return patterned(name, mottled(a, b, 16, 0.01f, seed), glm::vec2(metres), roughness, relief);
  };
  r[Finish::leaf] =
      bothSides(spotted("leaf", {0.45f, 0.58f, 0.37f}, {0.55f, 0.68f, 0.45f}, 0.2f, 0.6f, 0.0f, 30));
  r[Finish::paleLeaf] =
      bothSides(spotted("pale leaf", {0.55f, 0.66f, 0.44f}, {0.64f, 0.74f, 0.52f}, 0.12f, 0.55f, 0.0f, 31));
  r[Finish::stem] = plain("stem", {0.5f, 0.56f, 0.36f}, 0.6f);
  r[Finish::bark] = spotted("bark", {0.3f, 0.22f, 0.15f}, {0.44f, 0.34f, 0.24f}, 0.1f, 0.9f, 0.0f, 32);
  r[Finish::soil] = spotted("soil", {0.13f, 0.09f, 0.06f}, {0.25f, 0.18f, 0.12f}, 0.08f, 1.0f, 0.8f, 33);
  r[Finish::petal] = bothSides(plain("petal", {0.94f, 0.8f, 0.72f}, 0.7f));
  r[Finish::apple] = spotted("apple skin", {0.64f, 0.12f, 0.1f}, {0.78f, 0.42f, 0.18f}, 0.2f, 0.3f, 0.0f, 34);
  r[Finish::orange] =
      spotted("orange peel", {0.9f, 0.49f, 0.1f}, {0.95f, 0.56f, 0.15f}, 0.03f, 0.45f, 0.5f, 35);
  r[Finish::lemon] =
      spotted("lemon peel", {0.93f, 0.78f, 0.18f}, {0.96f, 0.84f, 0.3f}, 0.03f, 0.45f, 0.5f, 36);
  r[Finish::pear] = spotted("pear skin", {0.68f, 0.68f, 0.26f}, {0.74f, 0.62f, 0.28f}, 0.1f, 0.4f, 0.0f, 37);
  r[Finish::crust] =
      spotted("bread crust", {0.67f, 0.4f, 0.16f}, {0.83f, 0.6f, 0.32f}, 0.12f, 0.75f, 0.5f, 38);
  r[Finish::tea] = plain("tea", {0.36f, 0.16f, 0.06f}, 0.08f);
}

const Recipe& recipeOf(Finish finish) {
  static const Recipes kRecipes = [] {
    Recipes recipes;
    addRoomRecipes(recipes);
    addWoodAndMetalRecipes(recipes);
    addCeramicAndClothRecipes(recipes);
    addPaperRecipes(recipes);
    addLivingRecipes(recipes);
    return recipes;
  }();
  return kRecipes.at(finish);
}

TextureUse repeated(int texture, glm::vec2 metres) {
  TextureUse use;
  use.texture = texture;
  use.uvTransform[0][0] = 1.0f / metres.x;
  use.uvTransform[1][1] = 1.0f / metres.y;
  return use;
}

}  // namespace

int addFinish(modelling::SceneBuilder& builder, Finish finish) {
  const Recipe& recipe = recipeOf(finish);
  Material material;
  material.name = recipe.name;
  material.baseColor = glm::vec4(linearOf(recipe.color), 1.0f);
  material.roughness = recipe.roughness;
  material.metallic = recipe.metallic;
  material.emissive = recipe.emissive;
  material.doubleSided = recipe.doubleSided;
  if (recipe.pattern) {
    const int colors = builder.addImage(textures::baseColorImage(recipe.name, kTextureSize, recipe.pattern));
    material.baseColorTexture = repeated(colors, recipe.metres);
    if (finish == Finish::screen) material.emissiveTexture = material.baseColorTexture;
  }
  if (recipe.relief > 0.0f) {
    const int normals =
        builder.addImage(textures::normalImage(recipe.name + " relief", kTextureSize, recipe.pattern));
    material.normalTexture = repeated(normals, recipe.metres);
    material.normalScale = recipe.relief;
  }
  return builder.addMaterial(std::move(material));
}

}  // namespace host::furniture
