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
  const char* effect = host::kSsaoEffect;
};

constexpr double kMostRms = 0.03;  // so small a picture is nearly all edges

host::PictureSettings settingsOf(const View& view) {
  host::PictureSettings settings;
  settings.effect = view.effect;
  return settings;
}

/// A view, rendered by technique and reference.
class RenderedView {
 public:
  explicit RenderedView(const View& view)
      : scene_(host::loadScene(view.scene)),
        comparison_(scene_, settingsOf(view), kSoftwareRasterizer),
        measurement_(comparison_.measure({.camera = view.camera, .size = kSize, .timing = {}})) {}

  [[nodiscard]] const host::ErrorMetrics& error() const { return measurement_.error.value(); }
  host::ComparisonPictures pictures() { return comparison_.pictures(); }

 private:
  static constexpr bool kSoftwareRasterizer = true;  // only names the clock of timings, and none are taken

  host::Scene scene_;
  host::Comparison comparison_;
  host::Measurement measurement_;
};

class ScenePictures : public testing::TestWithParam<View> {
 protected:
  static void SetUpTestSuite() { static const host::GlContext kContext; }
};

TEST_P(ScenePictures, AreCloseToFullResolutionAndMatchTheGoldenOnes) {
  const View& view = GetParam();
  RenderedView rendered(view);
  EXPECT_LT(rendered.error().rms, kMostRms);
  EXPECT_GT(rendered.error().rms, 0.0) << "something must have been left out";
  EXPECT_EQ(rendered.error().nonFinite, 0);

  const host::ComparisonPictures pictures = rendered.pictures();
  const std::string effect =
      view.effect == std::string(host::kSsaoEffect) ? "" : view.effect + std::string("_");
  const std::string name = std::string(view.scene) + '_' + std::to_string(view.camera) + '_' + effect;
  EXPECT_TRUE(matchesGolden(pictures.technique, name + "picture"));
  EXPECT_TRUE(matchesGolden(pictures.referenceEffect, name + "full"));
  EXPECT_TRUE(matchesGolden(pictures.techniqueEffect, name + "mres"));
  // A decision flips where a value meets its threshold: a different rounding moves whole texels of a mask.
  const GoldenTolerance decisions{.failingShare = 0.02};
  EXPECT_TRUE(matchesGolden(pictures.edges, name + "edges", decisions));
  EXPECT_TRUE(matchesGolden(pictures.levels, name + "levels", decisions));
}

INSTANTIATE_TEST_SUITE_P(
    BuiltIn, ScenePictures,
    testing::Values(View{"office", 0}, View{"office", 5}, View{"hall", 0}, View{"hall", 3},
                    View{"breakfast", 0}, View{"breakfast", 4}, View{"office", 0, host::kSoftShadowEffect},
                    View{"hall", 0, host::kSoftShadowEffect}, View{"breakfast", 0, host::kSoftShadowEffect},
                    View{"office", 0, host::kSsgiEffect}, View{"hall", 0, host::kSsgiEffect},
                    View{"breakfast", 0, host::kSsgiEffect}),
    [](const auto& view) {
      return std::string(view.param.scene) + std::to_string(view.param.camera) + view.param.effect;
    });

}  // namespace
}  // namespace mres::test
