// What a frame does not need is left out, said, and changes no pixel.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "effects/soft_shadows/soft_shadows.h"
#include "effects/ssao/ssao.h"
#include "effects/ssgi/ssgi.h"
#include "tests/gpu/multi_resolution_support.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::Not;

auto isSkipped(const char* what) {
  return Contains(Field(&Skip::what, what));
}

auto isStage(const char* name) {
  return Contains(Field(&gl::StageTime::name, name));
}

class Skips : public MultiResolutionTest {
 protected:
  Skips() { multiResolution_.setProfiling(gl::Profiler::Mode::finish); }

  const Report& report() { return multiResolution_.report(); }

  void expectConstant(Effect& effect, float value) {
    for (const Technique technique : {Technique::multiResolution, Technique::full}) {
      multiResolution_.settings().technique = technique;
      multiResolution_.render(effect, gbuffer_.frame());
      multiResolution_.fillTargets(kNan);
      EXPECT_THAT(renderPicture(multiResolution_, effect, gbuffer_.frame()), Each(value));
      EXPECT_THAT(report().skipped, ElementsAre(Field(&Skip::what, "effect")));
      EXPECT_THAT(report().levels, ElementsAre(Field(&LevelReport::coverage, 0.0)));
      EXPECT_THAT(report().stages, IsEmpty());
    }
    EXPECT_NO_THROW(multiResolution_.debugView(DebugView::levels));
  }

  const glm::ivec2 size_{97, 61};
  const SyntheticGBuffer gbuffer_{size_, perspective(size_), room()};
};

TEST_F(Skips, AmbientOcclusionWithoutIntensityIsNotRendered) {
  Ssao ssao({.intensity = 0.0f});
  expectConstant(ssao, 1.0f);
  ssao.setSettings({.intensity = 1e-30f});
  EXPECT_THAT(mixed(ssao, gbuffer_.frame()), Each(1.0f)) << "the same, rendered";
  EXPECT_THAT(report().skipped, Not(isSkipped("effect")));
}

TEST_F(Skips, ShadowsWithoutAShadowMapAreNotRendered) {
  SoftShadows shadows;
  expectConstant(shadows, 1.0f);
}

TEST_F(Skips, IndirectLightThatNothingSendsIsNotRendered) {
  Ssgi ssgi;
  expectConstant(ssgi, 0.0f);
  ssgi.setInputs({.environmentAbove = glm::vec3(0.0f, 0.5f, 0.0f)});
  EXPECT_THAT(mixed(ssgi, gbuffer_.frame()), Not(Each(0.0f)));
  EXPECT_THAT(report().skipped, Not(isSkipped("effect")));
}

TEST_F(Skips, EffectsOfOneFrameShareDepthAndEdges) {
  Frame frame = gbuffer_.frame();
  Ssao first(ssaoWith(15));
  SsgiSettings settings{.samples = 16};
  settings.levels[2].used = false;
  Ssgi second(settings);
  second.setInputs({.environmentAbove = glm::vec3(0.5f)});
  const Picture firstAlone = mixed(first, frame);
  const Picture secondAlone = mixed(second, frame);
  EXPECT_THAT(report().stages, AllOf(isStage("mres.depth"), isStage("mres.edges")));

  frame.id = 7;
  EXPECT_EQ(mixed(first, frame), firstAlone);
  EXPECT_THAT(report().skipped, IsEmpty());
  EXPECT_EQ(mixed(second, frame), secondAlone) << "though it has other levels, and so other folds";
  EXPECT_THAT(report().skipped, AllOf(isSkipped("depth"), isSkipped("edges")));
  EXPECT_THAT(report().stages, Not(isStage("mres.depth")));
  EXPECT_EQ(mixed(first, frame), firstAlone);
}

TEST_F(Skips, NothingIsSharedWithAnotherFrameOrByOtherThresholds) {
  Frame frame = gbuffer_.frame();
  Ssao ssao(ssaoWith(15));
  frame.id = 1;
  static_cast<void>(mixed(ssao, frame));
  const SyntheticGBuffer other(size_, perspective(size_), sphere({0.0, 0.0, -2.0}, 1.0));
  Frame next = other.frame();
  const Picture expected = mixed(ssao, next);
  next.id = 2;
  EXPECT_EQ(mixed(ssao, next), expected);
  EXPECT_THAT(report().skipped, IsEmpty());

  multiResolution_.settings().mask.normalThreshold = 60.0f;
  static_cast<void>(mixed(ssao, next));
  EXPECT_THAT(report().skipped, AllOf(isSkipped("depth"), Not(isSkipped("edges"))));
}

TEST_F(Skips, WhatWasFilledIsNotShared) {
  Frame frame = gbuffer_.frame();
  frame.id = 1;
  Ssao ssao(ssaoWith(15));
  const Picture expected = mixed(ssao, frame);
  multiResolution_.fillTargets(kNan);
  EXPECT_EQ(mixed(ssao, frame), expected);
}

TEST_F(Skips, ASizeThatChangesUnderOneIdIsNoticed) {
  Frame frame = gbuffer_.frame();
  frame.id = 1;
  Ssao ssao(ssaoWith(15));
  static_cast<void>(mixed(ssao, frame));
  const glm::ivec2 size(64, 48);
  const SyntheticGBuffer other(size, perspective(size), room());
  const Picture expected = mixed(ssao, other.frame());
  static_cast<void>(mixed(ssao, frame));
  Frame same = other.frame();
  same.id = 1;
  EXPECT_EQ(mixed(ssao, same), expected);
}

}  // namespace
}  // namespace mres::test
