#include "host/truth/alpha_mask.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <limits>

#include "tests/truth/analytic_scenes.h"

namespace host {
namespace {

/// A quad with four texels in a row along u, of which the first two are holes.
class AlphaMasks : public testing::Test {
 protected:
  AlphaMasks() {
    test::addTexturedMaterial(scene_, AlphaMode::mask, {0, 0, 255, 255});
    scene_.textures[0].nearest = false;
  }

  /// At texture coordinate (u, 0): on the lower edge of the first triangle.
  [[nodiscard]] bool isHole(float u) const { return AlphaMask(scene_, scene_.meshes[0]).isHole(0, u, 0.0f); }

  Scene scene_ = test::sceneOf({test::level(0.0f, {0, 0}, 1.0f, 0)});
};

TEST_F(AlphaMasks, InterpolateBetweenTexels) {
  EXPECT_TRUE(isHole(0.25f));
  EXPECT_TRUE(isHole(0.48f));  // the border of the third texel, which 0.5 lies on
  EXPECT_FALSE(isHole(0.52f));
  scene_.materials[0].alphaCutoff = 0.9f;
  EXPECT_TRUE(isHole(0.52f));
}

TEST_F(AlphaMasks, OrDoNot) {
  scene_.materials[0].alphaCutoff = 0.9f;
  scene_.textures[0].nearest = true;
  EXPECT_FALSE(isHole(0.52f));
}

TEST_F(AlphaMasks, FollowTheTextureTransform) {
  scene_.materials[0].baseColorTexture.uvTransform[2].x = 0.5f;
  EXPECT_FALSE(isHole(0.25f));
  EXPECT_TRUE(isHole(0.75f));
}

TEST_F(AlphaMasks, WrapAsTheTextureDoes) {
  const auto holeFarRight = [&](Wrap wrap) {
    scene_.textures[0].wrapS = wrap;
    scene_.materials[0].baseColorTexture.uvTransform[2].x = 1.0f;
    return isHole(0.25f);
  };
  EXPECT_TRUE(holeFarRight(Wrap::repeat));
  EXPECT_FALSE(holeFarRight(Wrap::mirroredRepeat));
  EXPECT_FALSE(holeFarRight(Wrap::clampToEdge));
}

TEST_F(AlphaMasks, FarCoordinatesAreInsideOfTheImage) {
  scene_.images[0].size = {16384, 1};
  scene_.images[0].pixels.assign(std::size_t{4} * 16384, 255);
  for (const bool nearest : {false, true})
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirroredRepeat, Wrap::clampToEdge})
      for (const float far : {1e6f, -1e6f, 1e30f, -1e30f, std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN()}) {
        scene_.textures[0].nearest = nearest;
        scene_.textures[0].wrapS = wrap;
        scene_.materials[0].baseColorTexture.uvTransform[2].x = far;
        EXPECT_FALSE(isHole(0.25f)) << far;
      }
}

TEST_F(AlphaMasks, CountTheColourFactorAndNeedNoTexture) {
  scene_.materials[0].baseColor.a = 0.4f;
  EXPECT_TRUE(isHole(0.75f));
  scene_.materials[0].baseColorTexture.texture = -1;
  EXPECT_TRUE(isHole(0.75f));
  scene_.materials[0].baseColor.a = 0.6f;
  EXPECT_FALSE(isHole(0.25f));
}

}  // namespace
}  // namespace host
