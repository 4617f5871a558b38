// Every public call leaves the host's OpenGL state as it found it, and does not care what it finds.
#include <functional>
#include <gmock/gmock.h>
#include <optional>

#include "effects/soft_shadows/soft_shadows.h"
#include "effects/ssao/ssao.h"
#include "effects/ssgi/ssgi.h"
#include "mres/mres.h"
#include "tests/support/gl_state.h"
#include "tests/support/gl_test.h"
#include "tests/support/hostile_state.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/synthetic_shadow.h"

namespace mres::test {
namespace {

const glm::ivec2 kSize(65, 47);

class StateGuardTest : public GlTest {
 protected:
  StateGuardTest() : gbuffer_(kSize, perspective(kSize), room()) {}

  /// Runs `call` under hostile state and expects that it changes none of it.
  static void expectNothingChanges(const char* what, const std::function<void()>& call) {
    const HostileState hostile;
    const GlState before = captureGlState();
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    call();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << what;
    EXPECT_THAT(differences(before, captureGlState()), testing::IsEmpty()) << what;
  }

  SyntheticGBuffer gbuffer_;
};

TEST_F(StateGuardTest, EveryPublicCallLeavesAllStateAlone) {
  std::optional<MultiResolution> multiResolution;
  std::optional<Ssao> ssao;
  const glm::ivec2 otherSize(33, 29);
  const SyntheticGBuffer other(otherSize, perspective(otherSize), room());
  expectNothingChanges("constructor", [&] { multiResolution.emplace(Options{.measureCoverage = true}); });
  expectNothingChanges("effect's constructor", [&] { ssao.emplace(SsaoSettings{.samples = 4}); });
  expectNothingChanges("first render", [&] { multiResolution->render(*ssao, gbuffer_.frame()); });
  expectNothingChanges("render", [&] { multiResolution->render(*ssao, gbuffer_.frame()); });
  expectNothingChanges("render of another size", [&] { multiResolution->render(*ssao, other.frame()); });
  expectNothingChanges("edges", [&] { multiResolution->debugView(DebugView::edges); });
  expectNothingChanges("levels", [&] { multiResolution->debugView(DebugView::levels); });
  expectNothingChanges("fillTargets", [&] { multiResolution->fillTargets(1.0f); });
  expectNothingChanges("effect's settings", [&] { ssao->setSettings({.samples = 5}); });
  for (const auto mode : {gl::Profiler::Mode::query, gl::Profiler::Mode::finish}) {
    multiResolution->setProfiling(mode);
    expectNothingChanges("profiled render", [&] { multiResolution->render(*ssao, gbuffer_.frame()); });
  }
  expectNothingChanges("reloadShaders", [&] { multiResolution->reloadShaders(); });
  expectNothingChanges("render after reloadShaders",
                       [&] { multiResolution->render(*ssao, gbuffer_.frame()); });
  expectNothingChanges("refused render", [&] {
    Frame bad = gbuffer_.frame();
    bad.size = {0, 0};
    EXPECT_THROW(multiResolution->render(*ssao, bad), std::invalid_argument);
  });
  expectNothingChanges("forget", [&] { multiResolution->forget("ssao"); });
  expectNothingChanges("destructor", [&] { multiResolution.reset(); });
  expectNothingChanges("effect's destructor", [&] { ssao.reset(); });
}

TEST_F(StateGuardTest, EveryEffectLeavesAllStateAloneWhateverItsMasks) {
  const SyntheticShadow shadow(room(), parallelLight({0.3, 1.0, 0.2}, {0.0, 0.0, -5.0}, 8.0f), {64, 64});
  const std::vector<float> half(12, 0.5f);
  const gl::Texture2D importance(GL_R32F, {4, 3}, "importance", 1, half.data());
  const gl::Texture2D lit(GL_RGBA16F, kSize, "lit", 1, nullptr);
  const MaskSettings geometry{.geometryAlways = true};
  const MaskSettings compared{.geometryAlways = true, .minMaxMips = true, .disjoint = true};
  for (const MaskSettings& mask : {MaskSettings(), geometry, compared}) {
    MultiResolution multiResolution;
    multiResolution.settings().mask = mask;
    Frame frame = gbuffer_.frame();
    frame.importance = mask.geometryAlways ? importance.id() : 0;
    std::optional<SoftShadows> softShadows;
    std::optional<Ssgi> ssgi;
    expectNothingChanges("constructor of soft shadows",
                         [&] { softShadows.emplace(SoftShadowSettings{.samples = 4}); });
    expectNothingChanges("constructor of SSGI", [&] { ssgi.emplace(SsgiSettings{.samples = 512}); });
    softShadows->setInputs(shadow.inputs());
    ssgi->setInputs({.radiance = lit.id()});
    for (int i = 0; i < 2; ++i) {
      expectNothingChanges("soft shadows", [&] { multiResolution.render(*softShadows, frame); });
      expectNothingChanges("SSGI", [&] { multiResolution.render(*ssgi, frame); });
    }
    expectNothingChanges("destructor of soft shadows", [&] { softShadows.reset(); });
    expectNothingChanges("destructor of SSGI", [&] { ssgi.reset(); });
  }
}

TEST_F(StateGuardTest, HostileStateDoesNotShowInThePicture) {
  Ssao ssao({.samples = 6});
  for (const Technique technique : {Technique::multiResolution, Technique::full}) {
    MultiResolution clean;
    clean.settings().technique = technique;
    const Picture expected = renderPicture(clean, ssao, gbuffer_.frame());
    const std::vector<float> expectedLevels = readPixels(clean.debugView(DebugView::levels), kSize, 3);

    MultiResolution spoilt;
    spoilt.settings().technique = technique;
    GLuint result = 0;
    GLuint levels = 0;
    {
      const HostileState hostile;
      result = spoilt.render(ssao, gbuffer_.frame());
      levels = spoilt.debugView(DebugView::levels);
    }
    EXPECT_EQ(readPixels(result, kSize, 1), expected) << "targets made under hostile state";
    EXPECT_EQ(readPixels(levels, kSize, 3), expectedLevels);
    spoilt.fillTargets(3.0f);
    {
      const HostileState hostile;
      result = spoilt.render(ssao, gbuffer_.frame());
    }
    EXPECT_EQ(readPixels(result, kSize, 1), expected) << "second frame";
  }
}

TEST_F(StateGuardTest, HostileStateDoesNotKeepFillTargetsFromFilling) {
  Ssao ssao({.samples = 1});
  MultiResolution multiResolution;
  const GLuint result = multiResolution.render(ssao, gbuffer_.frame());
  {
    const HostileState hostile;
    multiResolution.fillTargets(0.5f);
  }
  EXPECT_THAT(readPixels(result, kSize, 1), testing::Each(0.5f));
}

TEST_F(StateGuardTest, ParametersOfTheHostsTexturesStay) {
  const auto parameters = [](GLuint texture) {
    std::vector<GLint> values;
    glBindTexture(GL_TEXTURE_2D, texture);
    for (const GLenum name :
         {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
          GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC,
          GL_TEXTURE_SWIZZLE_R, GL_TEXTURE_MIN_LOD}) {
      glGetTexParameteriv(GL_TEXTURE_2D, name, &values.emplace_back());
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    return values;
  };
  glBindTexture(GL_TEXTURE_2D, gbuffer_.frame().depth);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
  const auto depthBefore = parameters(gbuffer_.frame().depth);
  const auto normalsBefore = parameters(gbuffer_.frame().normals);

  Ssao ssao({.samples = 4});
  MultiResolution multiResolution;
  const Picture withOddParameters = renderPicture(multiResolution, ssao, gbuffer_.frame());
  EXPECT_EQ(parameters(gbuffer_.frame().depth), depthBefore);
  EXPECT_EQ(parameters(gbuffer_.frame().normals), normalsBefore);
  const SyntheticGBuffer plain(kSize, perspective(kSize), room());
  EXPECT_EQ(withOddParameters, renderPicture(multiResolution, ssao, plain.frame()))
      << "a shadow map's parameters";
}

TEST_F(StateGuardTest, ResultsThatTheHostStillHasBoundMayBeReplaced) {
  Ssao ssao({.samples = 1});
  MultiResolution multiResolution;
  glActiveTexture(GL_TEXTURE5);
  glBindTexture(GL_TEXTURE_2D, multiResolution.render(ssao, gbuffer_.frame()));
  const glm::ivec2 otherSize(40, 30);
  const SyntheticGBuffer other(otherSize, perspective(otherSize), room());
  static_cast<void>(multiResolution.render(ssao, other.frame()));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glBindTexture(GL_TEXTURE_2D, multiResolution.debugView(DebugView::levels));
  static_cast<void>(multiResolution.render(ssao, gbuffer_.frame()));
  static_cast<void>(multiResolution.debugView(DebugView::levels));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glBindTexture(GL_TEXTURE_2D, 0);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace
}  // namespace mres::test
