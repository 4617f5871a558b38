// Every technique renders every effect of a scene, as the commands have it.
#include <algorithm>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

#include "host/measure/effect_instance.h"
#include "host/measure/error_metrics.h"
#include "host/platform/gl_context.h"
#include "host/renderer/read_texture.h"

namespace host {
namespace {

constexpr glm::ivec2 kSize(192, 108);

PictureSettings settingsOf(const std::string& effect) {
  PictureSettings settings;
  settings.effect = effect;
  return settings;
}

/// A view of the office, drawn, and what an effect reads of it.
class OfficeView {
 public:
  explicit OfficeView(const std::string& effect)
      : settings_(settingsOf(effect)),
        frame_(frameOf(renderer_, renderer_.drawGeometry(scene_.cameras.at(0), kSize), kSize)),
        inputs_(drawInputs(renderer_, settings_)) {}

  FloatImage render(const std::string& technique) {
    EffectInstance instance(settings_, technique, EffectInstance::Coverage::unmeasured);
    instance.setInputs(inputs_);
    return readTexture(instance.render(frame_), kSize, instance.channels());
  }

 private:
  PictureSettings settings_;
  Scene scene_ = loadScene("office");
  mres::gl::Profiler profiler_;
  Renderer renderer_{scene_, profiler_, rendererSettings(settings_)};
  mres::Frame frame_;
  EffectInputs inputs_;
};

TEST(Techniques, RenderEveryEffect) {
  const GlContext context;
  for (const std::string& effect : effectNames()) {
    OfficeView view(effect);
    const FloatImage reference = view.render(kFullTechnique);
    for (const std::string& technique : techniqueNames()) {
      const ErrorMetrics error = compareImages(view.render(technique), reference);
      EXPECT_EQ(error.nonFinite, 0) << technique << ", " << effect;
      EXPECT_LT(error.rms, 0.2) << technique << ", " << effect;
      const bool isExact = technique == kFullTechnique || technique == "interleaved";
      EXPECT_EQ(error.rms == 0.0, isExact) << technique << ", " << effect;
    }
  }
}

TEST(Techniques, AreNamedOnce) {
  for (const TechniqueChoice& choice : techniques()) {
    EXPECT_EQ(std::ranges::count(techniqueNames(), choice.name), 1) << choice.name;
    EXPECT_FALSE(choice.meaning.empty()) << choice.name;
    EXPECT_EQ(&techniqueOf(choice.name), &choice);
  }
  EXPECT_FALSE(techniqueOf("half-joint").own);
  EXPECT_THROW(techniqueOf("unknown"), std::out_of_range);
}

}  // namespace
}  // namespace host
