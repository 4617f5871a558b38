// The facade: what must hold whatever the effect, the size and the levels.
#include <gmock/gmock.h>
#include <limits>
#include <optional>

#include "effects/ssao/ssao.h"
#include "mres/mres.h"
#include "tests/support/allocations.h"
#include "tests/support/failing_framebuffers.h"
#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/sentences.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

SsaoSettings ssaoWith(unsigned levels, int samples = 8) {
  return {.samples = samples, .levels = levelSubset(levels)};
}

class MultiResolutionTest : public GlTest {
 protected:
  Picture full(Effect& effect, const Frame& frame) {
    multiResolution_.settings().technique = Technique::full;
    Picture picture = renderPicture(multiResolution_, effect, frame);
    multiResolution_.settings().technique = Technique::multiResolution;
    return picture;
  }
  Picture mixed(Effect& effect, const Frame& frame) { return renderPicture(multiResolution_, effect, frame); }

  MultiResolution multiResolution_;
};

TEST_F(MultiResolutionTest, NothingUndefinedIsEverComposited) {
  for (const glm::ivec2 size : {glm::ivec2(97, 61), glm::ivec2(64, 64), glm::ivec2(33, 17)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (unsigned levels = 1; levels < 16; levels += 2) {
      Ssao ssao(ssaoWith(levels, 4));
      for (const float threshold : {0.0f, 0.02f}) {
        multiResolution_.settings().mask.refineThreshold = threshold;
        const Picture clean = mixed(ssao, gbuffer.frame());
        ASSERT_TRUE(isFinite(clean));
        for (const float poison : {kNan, -60000.0f, 60000.0f}) {
          multiResolution_.fillTargets(poison);
          ASSERT_EQ(mixed(ssao, gbuffer.frame()), clean)
              << size.x << "x" << size.y << ", levels " << levels << ", poison " << poison;
        }
      }
    }
  }
}

TEST_F(MultiResolutionTest, NothingUndefinedIsEverCompositedOfColoursAndUnfilteredEffects) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const char* body = "return vec4(fract(surface.position), 1.0);";
  TestEffect filtered({.body = body, .channels = 3, .filtered = true, .name = "filtered"});
  TestEffect unfiltered({.body = body, .channels = 3, .name = "unfiltered"});
  TestEffect single({.body = body, .name = "single"});
  for (TestEffect* effect : {&filtered, &unfiltered, &single}) {
    const Picture clean = mixed(*effect, gbuffer.frame());
    multiResolution_.fillTargets(kNan);
    EXPECT_EQ(mixed(*effect, gbuffer.frame()), clean);
    EXPECT_TRUE(isFinite(clean));
  }
}

TEST_F(MultiResolutionTest, AConstantGivesTheSameConstantAtEverySize) {
  constexpr float kValue = 0.37f;
  std::optional<float> stored;  // as the driver rounds it to a half
  std::vector<std::unique_ptr<TestEffect>> effects;
  for (const int channels : {1, 3}) {
    for (const bool filtered : {false, true}) {
      effects.push_back(std::make_unique<TestEffect>(TestEffect::Recipe{
          .body = "return vec4(0.37);",
          .channels = channels,
          .filtered = filtered,
          .background = glm::vec4(kValue),
          .name = std::string(filtered ? "filtered" : "plain") + std::to_string(channels)}));
    }
  }
  for (const glm::ivec2 size :
       {glm::ivec2(1), glm::ivec2(1, 4096), glm::ivec2(4096, 1), glm::ivec2(2, 3), glm::ivec2(7, 5),
        glm::ivec2(15), glm::ivec2(16), glm::ivec2(31, 17), glm::ivec2(127, 61), glm::ivec2(251, 257)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (const auto& effect : effects) {
      std::vector<Picture> pictures{full(*effect, gbuffer.frame())};
      for (const float threshold : {0.0f, MaskSettings{}.refineThreshold}) {
        multiResolution_.settings().mask.refineThreshold = threshold;
        pictures.push_back(mixed(*effect, gbuffer.frame()));
      }
      for (const Picture& picture : pictures) {
        stored = stored.value_or(picture.front());
        ASSERT_NEAR(*stored, kValue, kValue / 1024.0f);
        ASSERT_THAT(picture, testing::Each(*stored))
            << effect->description().name << " at " << size.x << "x" << size.y;
      }
    }
  }
}

/// 0.25, but for some pixels that have `bad` in one of the channels that count.
std::string mostlyGood(const char* bad, int channels) {
  return std::string("float zero = surface.pixel.x * 0.0;\n") +
         "bool isBad = surface.levelPixel.x % 5 == 2 && surface.levelPixel.y % 3 == 1;\n"
         "vec4 value = vec4(0.25);\n"
         "if (isBad) value." +
         (channels == 1 ? "r" : "b") + " = " + bad + ";\nreturn value;";
}

TEST_F(MultiResolutionTest, ValuesThatAreNoNumbersBecomeTheBackgroundAndSpreadNowhere) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  for (const char* bad : {"0.0 / zero", "1.0 / zero", "-1.0 / zero", "sqrt(zero - 1.0)"}) {
    for (const int channels : {1, 3}) {
      for (const bool filtered : {false, true}) {
        TestEffect effect({.body = mostlyGood(bad, channels),
                           .channels = channels,
                           .filtered = filtered,
                           .background = glm::vec4(0.25f)});
        multiResolution_.forget("test");
        EXPECT_THAT(mixed(effect, gbuffer.frame()), testing::Each(0.25f)) << bad << ", " << channels;
        EXPECT_THAT(full(effect, gbuffer.frame()), testing::Each(0.25f)) << bad << ", " << channels;
      }
    }
  }
}

TEST_F(MultiResolutionTest, ValuesBeyondTheRangeOfHalfFloatsEndWithIt) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.1, 0.1, 1.0}, -5.0));
  TestEffect effect({.body = "return vec4(surface.pixel.x < 48.0 ? 1e30 : -70000.0);", .filtered = true});
  EXPECT_TRUE(isFinite(full(effect, gbuffer.frame())));
  EXPECT_TRUE(isFinite(mixed(effect, gbuffer.frame())));
}

TEST_F(MultiResolutionTest, EdgesEverywhereGiveTheNaivePictureBitForBit) {
  for (const glm::ivec2 size : {glm::ivec2(96, 64), glm::ivec2(71, 53)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), withRandomNormals(room()));
    Ssao ssao(ssaoWith(15));
    refineAtEveryEdge(multiResolution_);
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
  refineAtEveryEdge(multiResolution_);
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

TEST_F(MultiResolutionTest, AnEffectWithoutDetailIsNotRefinedBeyondTheQuarterLevel) {
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
    EXPECT_EQ(levels[1].coverage, 0.0);
    EXPECT_GT(levels[2].coverage, 0.1) << "the quarter level finds out";
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

TEST_F(MultiResolutionTest, RefusesASecondEffectOfTheSameNameUntilTheFirstIsForgotten) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const TestEffect::Recipe recipe{.body = "return vec4(0.25);"};
  TestEffect first(recipe);
  TestEffect same(recipe);
  static_cast<void>(mixed(first, gbuffer.frame()));
  EXPECT_THAT(mixed(same, gbuffer.frame()), testing::Each(0.25f)) << "an equal one may share";

  std::vector<TestEffect::Recipe> others(4, recipe);
  others[0].body = "return vec4(0.5);";
  others[1].channels = 3;
  others[2].filtered = true;
  others[3].background = glm::vec4(0.5f);
  for (const TestEffect::Recipe& other : others) {
    TestEffect second(other);
    EXPECT_THAT([&] { multiResolution_.render(second, gbuffer.frame()); },
                refusesInASentence<std::logic_error>("named 'test'"));
  }
  multiResolution_.forget("test");
  TestEffect second(others[0]);
  EXPECT_THAT(mixed(second, gbuffer.frame()), testing::Each(0.5f));
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

/// Whether rendering the second frame after the first throws if the driver accepts only so many framebuffers.
bool isRejectedAfter(int good, MultiResolution& multiResolution, Effect& effect,
                     const std::array<Frame, 2>& frames) {
  multiResolution.render(effect, frames[0]);
  const FailingFramebuffers driver(good);
  try {
    multiResolution.render(effect, frames[1]);
  } catch (const std::runtime_error&) {
    return true;
  }
  return false;
}

TEST_F(MultiResolutionTest, ATargetThatTheDriverRejectsLeavesNothingHalfMade) {
  const glm::ivec2 size(97, 61);
  const glm::ivec2 otherSize(70, 50);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const SyntheticGBuffer other(otherSize, perspective(otherSize), room());
  Ssao ssao(ssaoWith(15, 1));
  const Picture expected = mixed(ssao, gbuffer.frame());
  int good = 0;
  while (isRejectedAfter(good, multiResolution_, ssao, {other.frame(), gbuffer.frame()})) {
    EXPECT_THAT([&] { multiResolution_.debugView(DebugView::levels); },
                refusesInASentence<std::logic_error>("call render() first"));
    ASSERT_EQ(mixed(ssao, gbuffer.frame()), expected) << "after " << good << " complete framebuffers";
    ++good;
  }
  EXPECT_GT(good, 20) << "targets, masks, zones and the pyramid were all made anew";
}

/// Every way to put one number of a settings struct out of its range.
template <class SomeSettings>
std::vector<SomeSettings> outOfRange(const SomeSettings& good) {
  std::vector<SomeSettings> bad;
  int count = 0;
  SomeSettings probe = good;
  visit(probe, [&](const char*, auto&, const SettingInfo&) { ++count; });
  for (int changed = 0; changed < count; ++changed) {
    for (const double beyond : {-0.01, 0.01, std::numeric_limits<double>::quiet_NaN()}) {
      SomeSettings settings = good;
      int index = 0;
      visit(settings, [&](const char*, auto& value, const SettingInfo& info) {
        using Value = std::remove_reference_t<decltype(value)>;
        constexpr bool kWhole = std::is_same_v<Value, bool> || std::is_enum_v<Value>;
        if (index++ != changed || kWhole) return;  // what is a little beyond is inside or no value of it
        value = static_cast<Value>((beyond < 0.0 ? info.min : info.max) + beyond);
        bad.push_back(settings);
      });
    }
  }
  return bad;
}

TEST_F(MultiResolutionTest, RefusesSettingsOutOfRangeAndStaysUsable) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect({.body = "return vec4(0.25);"});
  for (const MaskSettings& bad : outOfRange(MaskSettings{})) {
    multiResolution_.settings().mask = bad;
    EXPECT_THAT([&] { multiResolution_.render(effect, gbuffer.frame()); },
                refusesInASentence("MaskSettings::"));
  }
  multiResolution_.settings().mask = {.combination = static_cast<MaskCombination>(2)};
  EXPECT_THAT([&] { multiResolution_.render(effect, gbuffer.frame()); },
              refusesInASentence("MaskSettings::combination must be 0 to 1."));
  multiResolution_.settings().mask = {};
  for (const float bad : {-1.0f, 64.5f, kNan}) {
    LevelTable levels = kSsaoLevels;
    levels[1].maskVariance = bad;
    effect.setLevels(levels);
    EXPECT_THAT([&] { multiResolution_.render(effect, gbuffer.frame()); },
                refusesInASentence("LevelSettings::maskVariance must be 0 to 64 pixels^2."));
  }
  effect.setLevels(kSsaoLevels);
  EXPECT_THAT(mixed(effect, gbuffer.frame()), testing::Each(0.25f));
}

TEST_F(MultiResolutionTest, RefusesImpossibleFramesAndStaysUsable) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao(ssaoWith(15));
  const Picture before = mixed(ssao, gbuffer.frame());
  Frame bad = gbuffer.frame();
  bad.depth = 0;
  EXPECT_THROW(static_cast<void>(multiResolution_.render(ssao, bad)), std::invalid_argument);
  EXPECT_EQ(mixed(ssao, gbuffer.frame()), before);
}

class DebugViews : public MultiResolutionTest {
 protected:
  static glm::vec3 colorAt(GLuint texture, glm::ivec2 size, glm::ivec2 pixel) {
    const std::vector<float> texels = readPixels(texture, size, 3);
    const auto index = static_cast<std::size_t>(3 * (pixel.y * size.x + pixel.x));
    return {texels[index], texels[index + 1], texels[index + 2]};
  }
};

TEST_F(DebugViews, ThrowBeforeTheFirstFrame) {
  EXPECT_THROW(multiResolution_.debugView(DebugView::levels), std::logic_error);
}

TEST_F(DebugViews, ShowEdgesWhereTheyAre) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(
      size, perspective(size),
      nearest({plane({0.0, 0.0, 1.0}, -6.0), box({-1.0, -1.0, -5.0}, {1.0, 1.0, -4.0})}));
  Ssao ssao(ssaoWith(15, 1));
  static_cast<void>(mixed(ssao, gbuffer.frame()));
  const GLuint edges = multiResolution_.debugView(DebugView::edges);
  EXPECT_EQ(colorAt(edges, size, {2, 2}), glm::vec3(0.0f));
  const std::vector<float> texels = readPixels(edges, size, 3);
  EXPECT_GT(std::ranges::count(texels, 1.0f), 100);
}

TEST_F(DebugViews, ShowTheLevelThatRendered) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.1, 0.1, 1.0}, -6.0));
  Ssao ssao(ssaoWith(15, 1));
  static_cast<void>(mixed(ssao, gbuffer.frame()));
  EXPECT_EQ(colorAt(multiResolution_.debugView(DebugView::levels), size, {20, 20}), glm::vec3(0.0f))
      << "eighth";
  Ssao half(ssaoWith(3, 1));
  static_cast<void>(mixed(half, gbuffer.frame()));
  EXPECT_GT(colorAt(multiResolution_.debugView(DebugView::levels), size, {20, 20}).g, 0.5f)
      << "half is green";
  static_cast<void>(full(ssao, gbuffer.frame()));
  EXPECT_GT(colorAt(multiResolution_.debugView(DebugView::levels), size, {20, 20}).r, 0.5f) << "full is red";
}

TEST_F(DebugViews, ShowThatOnlyTheHalfWithDetailIsRefined) {
  const glm::ivec2 size(192, 128);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect({.body = "return vec4(surface.pixel.x < 96.0 ? log2(float(levelStride)) / 4.0 : 0.5);"});
  static_cast<void>(mixed(effect, gbuffer.frame()));
  const std::vector<float> colors = readPixels(multiResolution_.debugView(DebugView::levels), size, 3);
  constexpr int kBorder = 96 + 16;  // two pixels of the coarsest level see both halves
  int refinedLeft = 0;
  int refinedRight = 0;
  for (int i = 0; i < size.x * size.y; ++i) {
    const bool refined = std::max(colors[3 * i], colors[3 * i + 1]) > 0.5f;  // red full, green half
    (i % size.x < kBorder ? refinedLeft : refinedRight) += refined ? 1 : 0;
  }
  EXPECT_GT(refinedLeft, 96 * size.y / 10);
  EXPECT_EQ(refinedRight, 0);
}

TEST_F(DebugViews, OfTheFullTechniqueHaveNoEdges) {
  const glm::ivec2 size(64, 48);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao(ssaoWith(15, 1));
  static_cast<void>(full(ssao, gbuffer.frame()));
  EXPECT_THAT(readPixels(multiResolution_.debugView(DebugView::edges), size, 3), testing::Each(0.0f));
}

}  // namespace
}  // namespace mres::test
