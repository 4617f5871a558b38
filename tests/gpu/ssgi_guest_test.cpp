// How SSGI takes its place: its levels, the host's state, and what it refuses.
#include <gmock/gmock.h>
#include <optional>

#include "tests/gpu/ssgi_support.h"
#include "tests/support/allocations.h"
#include "tests/support/gl_state.h"
#include "tests/support/hostile_state.h"
#include "tests/support/sentences.h"
#include "tests/support/ssgi_reference.h"

namespace mres::test {
namespace {

TEST_F(SsgiTest, RendersTheLevelsOfThePapersTableAndTheHalfLevel) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const auto isLevel = [](int index) { return testing::Field(&LevelReport::index, index); };
  SsgiSettings settings{.samples = 8};
  const SsgiInputs lit{.environmentAbove = glm::vec3(1.0f)};
  static_cast<void>(render(gbuffer, settings, lit, Technique::multiResolution));
  EXPECT_THAT(multiResolution_.report().levels,
              testing::ElementsAre(isLevel(0), isLevel(1), isLevel(2), isLevel(3)));
  settings.levels[1].used = false;
  static_cast<void>(render(gbuffer, settings, lit, Technique::multiResolution));
  EXPECT_THAT(multiResolution_.report().levels, testing::ElementsAre(isLevel(0), isLevel(2), isLevel(3)));
  const LevelTable& table = ssgi_.levels();
  EXPECT_EQ(table[0].maskVariance, 0.924f);
  EXPECT_EQ(table[0].blendWeight, 1000.0f);
  EXPECT_EQ(table[1].maskVariance, 0.924f);
  EXPECT_EQ(table[1].blendWeight, 100.0f);
  EXPECT_EQ(table[2].maskVariance, 0.924f);
  EXPECT_EQ(table[2].blendWeight, 100.0f);
  EXPECT_EQ(table[3].maskVariance, 0.0f);
  EXPECT_EQ(table[3].blendWeight, 1.0f);
}

TEST_F(SsgiTest, EdgesEverywhereGiveTheNaivePictureBitForBit) {
  for (const glm::ivec2 size : {glm::ivec2(96, 64), glm::ivec2(101, 77)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), withRandomNormals(room()));
    const LitPicture lit = uniformPicture(size, {1.0f, 0.5f, 0.25f});
    const SsgiInputs inputs{.radiance = lit.texture.id(), .environmentAbove = kWhite};
    refineByMasks(multiResolution_);
    const Image mixed = render(gbuffer, {.samples = 8}, inputs, Technique::multiResolution);
    EXPECT_EQ(multiResolution_.report().levels.size(), 4u);
    EXPECT_EQ(mixed.texels, render(gbuffer, {.samples = 8}, inputs).texels);
  }
}

TEST_F(SsgiTest, OfARoomIsCloseToTheNaivePicture) {
  const glm::ivec2 size(320, 240);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const LitPicture lit = facingPicture(gbuffer, {0.0f, 1.0f, 0.0f}, kWhite, {0.5f, 0.2f, 0.1f});
  const SsgiInputs inputs{.radiance = lit.texture.id(), .environmentAbove = kWhite};
  const SsgiSettings settings{.samples = 32};
  EXPECT_LT(rootMeanSquare(render(gbuffer, settings, inputs, Technique::multiResolution).texels,
                           render(gbuffer, settings, inputs).texels),
            0.02);
}

TEST_F(SsgiTest, HostileStateNeitherShowsNorChanges) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const LitPicture lit = uniformPicture(size, kWhite);
  const SsgiInputs inputs{.radiance = lit.texture.id(), .environmentAbove = kWhite};
  const SsgiSettings settings{.samples = 1600};  // those in a texture, too
  const Image expected = render(gbuffer, settings, inputs);
  std::optional<Ssgi> ssgi;
  GLuint result = 0;
  {
    const HostileState hostile;
    const GlState before = captureGlState();
    ssgi.emplace(settings);
    ssgi->setInputs(inputs);
    result = multiResolution_.render(*ssgi, gbuffer.frame());
    EXPECT_THAT(differences(before, captureGlState()), testing::IsEmpty());
  }
  EXPECT_EQ(readPixels(result, size, 3), expected.texels);
}

TEST_F(SsgiTest, ASteadyFrameAllocatesNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const LitPicture lit = uniformPicture(size, kWhite);
  const auto renderFrame = [&] {
    ssgi_.setSettings({.samples = 8});
    ssgi_.setInputs({.radiance = lit.texture.id(), .environmentAbove = kWhite});
    multiResolution_.render(ssgi_, gbuffer.frame());
  };
  for (int frame = 0; frame < 3; ++frame) renderFrame();
  const AllocationCounter allocations;
  for (int frame = 0; frame < 3; ++frame) renderFrame();
  EXPECT_EQ(allocations.count(), 0u);
}

TEST_F(SsgiTest, SettingsOutOfRangeAreRefused) {
  for (const SsgiSettings& bad :
       {SsgiSettings{.radius = -1.0f}, SsgiSettings{.radius = kNan}, SsgiSettings{.samples = 7},
        SsgiSettings{.samples = 8193}, SsgiSettings{.intensity = 4.5f}, SsgiSettings{.bias = 2.0f},
        SsgiSettings{.maxRadiance = 1001.0f}, SsgiSettings{.seed = -1}}) {
    EXPECT_THAT([&] { ssgi_.setSettings(bad); }, refusesInASentence("SsgiSettings::"));
  }
  SsgiSettings bad;
  bad.levels[2].maskVariance = kNan;
  EXPECT_THAT([&] { ssgi_.setSettings(bad); }, refusesInASentence("maskVariance"));
  EXPECT_EQ(ssgi_.settings().radius, SsgiSettings{}.radius);
}

TEST_F(SsgiTest, InputsOutOfRangeAreRefused) {
  for (const SsgiInputs& bad :
       {SsgiInputs{.radianceScale = -1.0f}, SsgiInputs{.radianceScale = kInfinity},
        SsgiInputs{.environmentAbove = {0.0f, kNan, 0.0f}},
        SsgiInputs{.environmentBelow = {0.0f, 0.0f, -1.0f}}, SsgiInputs{.environmentBelow = glm::vec3(7e4f)},
        SsgiInputs{.up = glm::vec3(0.0f)}, SsgiInputs{.up = glm::vec3(kNan)}}) {
    EXPECT_THAT([&] { ssgi_.setInputs(bad); }, refusesInASentence("SsgiInputs::"));
  }
}

}  // namespace
}  // namespace mres::test
