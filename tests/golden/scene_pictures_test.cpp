// The whole way from a built-in scene to the pictures that a user sees, against golden ones.
#include "host/measure/comparison.h"
#include "host/platform/gl_context.h"
#include "tests/golden/golden_image.h"

namespace mres::test {
namespace {

constexpr glm::ivec2 kSize(320, 180);

struct View {
  const char* scene;
  int camera;
};

class ScenePictures : public testing::TestWithParam<View> {
 protected:
  static void SetUpTestSuite() { static const host::GlContext kContext; }
};

TEST_P(ScenePictures, MatchTheGoldenOnes) {
  const View view = GetParam();
  const host::Scene scene = host::loadScene(view.scene);
  const bool softwareRasterizer = true;  // only names the clock of timings, and none are taken
  host::Comparison comparison(scene, {}, softwareRasterizer);
  const host::Measurement measurement =
      comparison.measure({.camera = view.camera, .size = kSize, .timing = {}});
  ASSERT_TRUE(measurement.error.has_value());
  EXPECT_LT(measurement.error->rms, 0.03);  // so small a picture is nearly all edges
  EXPECT_EQ(measurement.error->nonFinite, 0);

  const host::ComparisonPictures pictures = comparison.pictures();
  const std::string name = std::string(view.scene) + '_' + std::to_string(view.camera) + '_';
  EXPECT_TRUE(matchesGolden(pictures.technique, name + "picture"));
  EXPECT_TRUE(matchesGolden(pictures.referenceEffect, name + "full"));
  EXPECT_TRUE(matchesGolden(pictures.techniqueEffect, name + "mres"));
  // A decision flips where a value meets its threshold: a different rounding moves whole texels of a mask.
  const GoldenTolerance decisions{.failingShare = 0.02};
  EXPECT_TRUE(matchesGolden(pictures.edges, name + "edges", decisions));
  EXPECT_TRUE(matchesGolden(pictures.levels, name + "levels", decisions));
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, ScenePictures,
                         testing::Values(View{"office", 0}, View{"office", 5}, View{"hall", 0},
                                         View{"hall", 3}, View{"breakfast", 0}, View{"breakfast", 4}),
                         [](const auto& view) {
                           return std::string(view.param.scene) + std::to_string(view.param.camera);
                         });

}  // namespace
}  // namespace mres::test
