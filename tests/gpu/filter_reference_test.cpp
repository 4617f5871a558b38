// The filter of a level against double precision, on random depths, normals and holes.
#include <algorithm>
#include <cmath>
#include <random>

#include "mres/composite/composite_pass.h"
#include "mres/level/frame_params.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"
#include "tests/support/mask_bench.h"
#include "tests/support/pictures.h"

namespace mres::test {
namespace {

/// The share of one pixel in a period that is symmetric about the centre: one that is half inside counts
/// half.
double kernel(int offset, int period) {
  const double inside = std::clamp(0.5 * period - std::abs(offset) + 0.5, 0.0, 1.0);
  return inside / period;
}

/// Values and filter depth of a level before the filter, and the full resolution's normals.
struct Input {
  glm::ivec2 fullSize{0};
  PlannedLevel level;
  Frame frame;
  Image raw;  // the last channel is filter depth
  std::vector<glm::vec4> normals;
};

/// The filter written anew.
class FilterReference {
 public:
  explicit FilterReference(const Input& input) : input_(input), params_(frameParams(input.frame)) {}

  [[nodiscard]] double filtered(glm::ivec2 pixel, int channel) const {
    return along({0, 1}, pixel, [&](glm::ivec2 p) {
      return along({1, 0}, p, [&](glm::ivec2 q) { return static_cast<double>(input_.raw.at(q, channel)); });
    });
  }

  [[nodiscard]] bool isHole(glm::ivec2 pixel) const { return filterDepth(pixel) == 0.0; }

 private:
  [[nodiscard]] double filterDepth(glm::ivec2 pixel) const {
    return static_cast<double>(input_.raw.at(pixel, input_.raw.channels - 1));
  }

  [[nodiscard]] glm::ivec2 representative(glm::ivec2 pixel) const {
    const int stride = 1 << input_.level.index;
    const bool jitter = stride > 1 && period() % 2 == 0;
    const glm::ivec2 turn = jitter ? glm::ivec2(pixel.y % 2, pixel.x % 2) : glm::ivec2(0);
    return glm::min(pixel * stride + stride / 2 - turn, input_.fullSize - 1);
  }

  [[nodiscard]] int period() const { return input_.level.settings.noisePeriod; }

  /// Off the screen, the pixel of the same phase of the pattern on the other side.
  [[nodiscard]] glm::ivec2 inside(glm::ivec2 pixel) const {
    for (int axis = 0; axis < 2; ++axis) {
      if (pixel[axis] < 0) pixel[axis] += period();
      if (pixel[axis] >= input_.raw.size[axis]) pixel[axis] -= period();
    }
    return pixel;
  }

  [[nodiscard]] glm::dvec3 position(glm::ivec2 pixel) const {
    const glm::dmat4 p(input_.frame.projection);
    const glm::dvec2 ndc =
        (glm::dvec2(representative(pixel)) + 0.5) / glm::dvec2(input_.fullSize) * 2.0 - 1.0;
    const double depth = filterDepth(pixel) / static_cast<double>(params_.filterDepth.x);
    return depth * glm::dvec3((ndc.x + p[2][0]) / p[0][0], (ndc.y + p[2][1]) / p[1][1], -1.0);
  }

  /// How far a tap is trusted: fully up to the tolerance off the centre's tangent plane, not at all from
  /// twice on.
  [[nodiscard]] double trust(glm::ivec2 centre, glm::ivec2 tap) const {
    const glm::ivec2 full = representative(centre);
    const glm::dvec3 normal(input_.normals.at(static_cast<std::size_t>(full.y * input_.fullSize.x + full.x)));
    if (isHole(tap) || glm::length(normal) == 0.0) return 0.0;
    const glm::dvec3 origin = position(centre);
    const double offPlane = std::abs(glm::dot(glm::normalize(normal), position(tap) - origin));
    return std::clamp(2.0 - offPlane / (static_cast<double>(params_.filterTolerance.x) * -origin.z), 0.0,
                      1.0);
  }

  template <class Value>
  [[nodiscard]] double along(glm::ivec2 axis, glm::ivec2 pixel, const Value& value) const {
    double sum = kernel(0, period()) * value(pixel);
    double weights = kernel(0, period());
    for (int offset = -period(); offset <= period(); ++offset) {
      if (offset == 0) continue;
      const glm::ivec2 tap = inside(pixel + offset * axis);
      const double weight = kernel(offset, period()) * trust(pixel, tap);
      if (weight == 0.0) continue;
      sum += weight * value(tap);
      weights += weight;
    }
    return sum / weights;
  }

  const Input& input_;
  params::FrameParams params_;
};

/// A bumpy wall: neighbours lie about as far off each other's planes as the filter tolerates.
Input randomInput(glm::ivec2 fullSize, int level, int period, int valueChannels, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> random(0.0f, 1.0f);
  std::normal_distribution<float> bump;
  Input input{.fullSize = fullSize,
              .level = {level, levelSize(fullSize, level), {.noisePeriod = period}},
              .frame = {.depth = 1, .normals = 1, .size = fullSize, .projection = perspective(fullSize)},
              .raw = {levelSize(fullSize, level), valueChannels + 1, {}},
              .normals = {}};
  input.frame.normalSpace = NormalSpace::view;
  input.frame.normalEncoding = NormalEncoding::signedXyz;
  const float scale = frameParams(input.frame).filterDepth.x;
  for (int i = 0; i < input.raw.size.x * input.raw.size.y; ++i) {
    for (int channel = 0; channel < valueChannels; ++channel) input.raw.texels.push_back(random(generator));
    const bool isHole = random(generator) < 0.1f;
    input.raw.texels.push_back(isHole ? 0.0f : scale * (5.0f + 0.02f * bump(generator)));
  }
  for (int i = 0; i < fullSize.x * fullSize.y; ++i) {
    const glm::vec3 normal(0.1f * bump(generator), 0.1f * bump(generator), 1.0f);
    const bool isMissing = random(generator) < 0.05f;
    input.normals.emplace_back(isMissing ? glm::vec3(0.0f) : glm::normalize(normal), 0.0f);
  }
  return input;
}

class FilterReferenceTest : public GlTest {
 protected:
  FilterReferenceTest() { context_.library = shaderLibrary(); }

  /// What the composite pass makes of the input, whose texels become what half floats hold of them.
  Image filter(Input& input) {
    const int channels = input.raw.channels - 1;
    const EffectDescription effect{
        .name = "test", .shader = "", .shaders = {}, .channels = channels, .filtered = true};
    CompositePass composite(context_.library, effect);
    LevelTargets targets;
    targets.ensure(effect, input.level.size, LevelRole::coarsest);
    const gl::Texture2D& raw = targets.raw().color();
    glBindTexture(GL_TEXTURE_2D, raw.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, raw.size().x, raw.size().y, channels == 1 ? GL_RG : GL_RGBA,
                    GL_FLOAT, input.raw.texels.data());
    input.raw.texels = readPixels(raw.id(), raw.size(), input.raw.channels);

    const gl::Texture2D normals(GL_RGBA32F, input.fullSize, "test.normals", 1, input.normals.data());
    gl::bindTexture(kNormalUnit, normals.id(), context_.nearest);
    frameBlock_.upload(frameParams(input.frame));
    frameBlock_.bind(kFrameBlock);
    targets.params().upload(levelParams({input.level}, input.fullSize, 0.0f));
    targets.params().bind(kLevelBlock);
    composite.drawAlone(context_, targets);
    return readImage(targets.composed().color(), channels);
  }

  PassContext context_;
  gl::UniformBuffer<params::FrameParams> frameBlock_;
};

class FilterOfPeriod : public FilterReferenceTest, public testing::WithParamInterface<int> {};

TEST_P(FilterOfPeriod, OfRandomDepthsNormalsAndHoles) {
  for (const int level : {0, 2}) {
    for (const int channels : {1, 3}) {
      const glm::ivec2 fullSize = glm::ivec2(45, 37) * (1 << level) - 1;
      Input input =
          randomInput(fullSize, level, GetParam(), channels, static_cast<unsigned>(level + channels));
      const Image image = filter(input);
      const FilterReference reference(input);
      int changed = 0;
      for (int y = 0; y < image.size.y; ++y) {
        for (int x = 0; x < image.size.x; ++x) {
          if (reference.isHole({x, y})) continue;
          for (int channel = 0; channel < channels; ++channel) {
            const double expected = reference.filtered({x, y}, channel);
            ASSERT_NEAR(static_cast<double>(image.at({x, y}, channel)), expected, 0.002)
                << "level " << level << ", channel " << channel << ", at " << x << ", " << y;
            changed += std::abs(expected - static_cast<double>(input.raw.at({x, y}, channel))) > 0.1 ? 1 : 0;
          }
        }
      }
      if (GetParam() == 1)
        EXPECT_EQ(changed, 0) << "a period of one pixel needs no filter";
      else
        EXPECT_GT(changed, 400) << "the filter does something";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Periods, FilterOfPeriod, testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace mres::test
