// The facade: what must hold whatever the effect, the size and the levels.
#include <array>
#include <cmath>
#include <cstddef>
#include <gmock/gmock.h>
#include <stdexcept>
#include <string>
#include <vector>

#include "effects/ssao/ssao.h"
#include "mres/mres.h"
#include "tests/gpu/multi_resolution_support.h"
#include "tests/support/allocations.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

TEST_F(MultiResolutionTest, EdgesEverywhereGiveTheNaivePictureBitForBit) {
  for (const glm::ivec2 size : {glm::ivec2(96, 64), glm::ivec2(71, 53)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), withRandomNormals(room()));
    Ssao ssao(ssaoWith(15));
    refineByMasks(multiResolution_);
    EXPECT_EQ(mixed(ssao, gbuffer.frame()), full(ssao, gbuffer.frame()));
  }
}

TEST_F(MultiResolutionTest, OneLevelGivesTheNaivePictureBitForBit) {
  const glm::ivec2 size(71, 53);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao(ssaoWith(1));
  EXPECT_EQ(mixed(ssao, gbuffer.frame()), full(ssao, gbuffer.frame()));
  EXPECT_EQ(multiResolution_.report().technique, Technique::full);
}

TEST_F(MultiResolutionTest, PicturesDoNotDependOnWhatWasRenderedBefore) {
  const glm::ivec2 size(95, 63);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao(ssaoWith(15));
  const Picture first = mixed(ssao, gbuffer.frame());
  EXPECT_EQ(mixed(ssao, gbuffer.frame()), first);
  TestEffect other({.body = "return vec4(surface.depth);", .channels = 3});
  for (const glm::ivec2 otherSize : {glm::ivec2(31, 17), glm::ivec2(1), glm::ivec2(130, 40), size}) {
    const SyntheticGBuffer otherScene(otherSize, perspective(otherSize), sphere({0.0, 0.0, -2.0}, 1.0));
    static_cast<void>(mixed(ssao, otherScene.frame()));
    static_cast<void>(full(other, otherScene.frame()));
    static_cast<void>(mixed(other, otherScene.frame()));
    EXPECT_EQ(mixed(ssao, gbuffer.frame()), first);
  }
  MultiResolution another;
  EXPECT_EQ(renderPicture(another, ssao, gbuffer.frame()), first);
}

TEST_F(MultiResolutionTest, SsaoOfARoomIsCloseToTheNaivePicture) {
  const glm::ivec2 size(320, 240);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  MultiResolution multiResolution({.measureCoverage = true});
  Ssao ssao({.samples = 32});
  const Picture picture = renderPicture(multiResolution, ssao, gbuffer.frame());
  glFinish();
  static_cast<void>(renderPicture(multiResolution, ssao, gbuffer.frame()));
  const std::vector<LevelReport> levels = multiResolution.report().levels;
  EXPECT_LT(rootMeanSquare(picture, full(ssao, gbuffer.frame())), 0.02);
  ASSERT_EQ(levels.size(), 4u);
  for (std::size_t i = 0; i + 1 < levels.size(); ++i)
    EXPECT_LT(levels[i].coverage, levels[i + 1].coverage) << i;
  EXPECT_GT(levels.front().coverage, 0.0);
  EXPECT_EQ(levels.back().coverage, 1.0);
}

/// Reads a texture of its own, bound where effect.h says.
class TexturedEffect final : public TestEffect {
 public:
  TexturedEffect()
      : TestEffect({.body = "return texelFetch(effectTexture, ivec2(0), 0);", .name = "textured"}),
        declaration_("uniform sampler2D effectTexture;\n" +
                     std::string(TestEffect::description().shaders[0].text)),
        files_{{{"test/effect.glsl", declaration_}}},
        description_(TestEffect::description()) {
    description_.shaders = files_;
  }
  [[nodiscard]] const EffectDescription& description() const override { return description_; }
  void setUp(const gl::Program& program) override {
    program.setTextureUnit("effectTexture", kEffectTextureUnit);
  }
  void bind(const Frame&) override { gl::bindTexture(kEffectTextureUnit, texture_.id(), sampler_); }

 private:
  static constexpr float kTexel = 0.625f;
  std::string declaration_;
  std::array<gl::ShaderFile, 1> files_;
  EffectDescription description_;
  gl::Texture2D texture_{GL_R32F, {1, 1}, "test.texture", 1, &kTexel};
  gl::SamplerName sampler_ = gl::makeSampler(gl::Filter::nearest);
};

TEST_F(MultiResolutionTest, AnEffectsOwnTextureStaysBoundForEveryLevel) {
  const glm::ivec2 size(95, 63);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TexturedEffect effect;
  refineByMasks(multiResolution_);
  for (unsigned levels = 1; levels < 16; levels += 2) {
    effect.setLevels(levelSubset(levels));
    EXPECT_THAT(mixed(effect, gbuffer.frame()), testing::Each(0.625f)) << levels;
  }
}

TEST_F(MultiResolutionTest, ResultsHaveTheSizeOfTheFrameForEverySubsetOfLevels) {
  for (const glm::ivec2 size : {glm::ivec2(9, 9), glm::ivec2(65, 33)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (unsigned levels = 0; levels < 16; ++levels) {
      Ssao ssao(ssaoWith(levels, 1));
      glBindTexture(GL_TEXTURE_2D, multiResolution_.render(ssao, gbuffer.frame()));
      glm::ivec2 actual(0);
      glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &actual.x);
      glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &actual.y);
      EXPECT_EQ(actual, size) << levels;
    }
  }
}

TEST_F(MultiResolutionTest, ReportSaysWhatRan) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao(ssaoWith(0b1101));
  multiResolution_.setProfiling(gl::Profiler::Mode::finish);
  static_cast<void>(mixed(ssao, gbuffer.frame()));
  const Report& report = multiResolution_.report();
  EXPECT_EQ(report.technique, Technique::multiResolution);
  EXPECT_THAT(report.levels, testing::ElementsAre(testing::Field(&LevelReport::index, 0),
                                                  testing::Field(&LevelReport::index, 2),
                                                  testing::Field(&LevelReport::size, glm::ivec2(13, 8))));
  EXPECT_THAT(report.skipped, testing::ElementsAre(testing::Field(&Skip::what, "level1")));
  EXPECT_THAT(report.stages, testing::Contains(testing::Field(&gl::StageTime::name, "mres.masks")));
  EXPECT_GT(report.bytes, 97u * 61u * 4u);
}

TEST_F(MultiResolutionTest, AnEffectWithoutDetailIsNotRefinedBeyondTheHalfLevel) {
  const glm::ivec2 size(193, 129);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  MultiResolution multiResolution({.measureCoverage = true});
  for (const bool filtered : {false, true}) {
    TestEffect effect({.body = "return vec4(0.37);", .filtered = filtered});
    multiResolution.forget("test");
    multiResolution.render(effect, gbuffer.frame());
    glFinish();
    multiResolution.render(effect, gbuffer.frame());
    const std::vector<LevelReport>& levels = multiResolution.report().levels;
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[0].coverage, 0.0);
    EXPECT_GT(levels[1].coverage, 0.1) << "the half level finds out";
  }
}

TEST_F(MultiResolutionTest, TheErrorStaysWithinItsBudgetAndMoreBudgetIsLessWork) {
  const glm::ivec2 size(384, 256);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  MultiResolution multiResolution({.measureCoverage = true});
  Ssao ssao({.samples = 32});
  const Picture reference = full(ssao, gbuffer.frame());
  double lastWork = 1.0;
  for (const float budget : {0.0025f, 0.01f, 0.04f}) {
    SCOPED_TRACE(budget);
    multiResolution.settings().mask.errorBudget = budget;
    static_cast<void>(renderPicture(multiResolution, ssao, gbuffer.frame()));
    glFinish();
    const Picture picture = renderPicture(multiResolution, ssao, gbuffer.frame());
    EXPECT_LE(rootMeanSquare(picture, reference), budget);
    double work = 0.0;
    for (const LevelReport& level : multiResolution.report().levels)
      work += level.coverage * std::exp2(-2.0 * level.index);
    EXPECT_LT(work, lastWork);
    lastWork = work;
  }
}

TEST_F(MultiResolutionTest, ASteadyFrameAllocatesNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  MultiResolution multiResolution({.measureCoverage = true});
  Ssao all(ssaoWith(0b1111, 1));
  for (const auto mode : {gl::Profiler::Mode::off, gl::Profiler::Mode::query, gl::Profiler::Mode::finish}) {
    multiResolution.setProfiling(mode);
    for (const Technique technique : {Technique::multiResolution, Technique::full}) {
      multiResolution.settings().technique = technique;
      for (int frame = 0; frame < 10; ++frame) multiResolution.render(all, gbuffer.frame());
      const AllocationCounter allocations;
      for (int frame = 0; frame < 10; ++frame) multiResolution.render(all, gbuffer.frame());
      EXPECT_EQ(allocations.count(), 0u) << "profiling mode " << static_cast<int>(mode);
    }
  }
}

TEST_F(MultiResolutionTest, ForgettingAnEffectFreesItsTexturesAndNoOthers) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect first({.body = "return vec4(0.25);", .name = "first"});
  TestEffect second({.body = "return vec4(0.5);", .name = "second"});
  const GLuint firstResult = multiResolution_.render(first, gbuffer.frame());
  const GLuint secondResult = multiResolution_.render(second, gbuffer.frame());
  multiResolution_.forget("first");
  multiResolution_.forget("unknown");
  EXPECT_EQ(glIsTexture(firstResult), GL_FALSE);
  EXPECT_EQ(glIsTexture(secondResult), GL_TRUE);
  EXPECT_NO_THROW(multiResolution_.debugView(DebugView::levels));
  EXPECT_THAT(mixed(first, gbuffer.frame()), testing::Each(0.25f)) << "it may come back";
}

TEST_F(MultiResolutionTest, ForgettingTheLastEffectLeavesNothingToShow) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect({.body = "return vec4(0.25);", .name = "previewed", .preview = "return vec2(0.0, 1.0);"});
  multiResolution_.render(effect, gbuffer.frame());
  EXPECT_NO_THROW(multiResolution_.debugView(DebugView::edges));
  multiResolution_.forget("previewed");
  EXPECT_THROW(multiResolution_.debugView(DebugView::edges), std::logic_error);
}

}  // namespace
}  // namespace mres::test
