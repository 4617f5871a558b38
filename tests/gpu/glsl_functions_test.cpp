// The GLSL functions of frame.glsl and hemisphere.glsl against double-precision C++ on random input.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "mres/gl/uniform_buffer.h"
#include "mres/level/frame_params.h"
#include "mres/level/pass_context.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"

namespace mres::test {
namespace {

constexpr const char* kFrame = "#include \"mres/frame.glsl\"";
constexpr std::size_t kInputs = 64;

struct Camera {
  const char* name;
  glm::mat4 projection;
  ClipDepth clipDepth = ClipDepth::minusOneToOne;
  bool reversed = false;
};

/// Window depth 0 and 1 exchanged; for a projection to a clip depth of 0..1.
glm::mat4 reversedDepth(const glm::mat4& projection) {
  glm::mat4 flip(1.0f);
  flip[2][2] = -1.0f;
  flip[3][2] = 1.0f;
  return flip * projection;
}

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  float operator()(float min, float max) {
    return std::uniform_real_distribution<float>(min, max)(generator_);
  }

 private:
  std::mt19937 generator_;
};

std::vector<Camera> randomCameras(unsigned seed) {
  Random random(seed);
  const float near = std::exp(random(-4.0f, 1.0f));
  const float far = near * std::exp(random(2.0f, 9.0f));
  const float fov = random(0.2f, 2.2f);
  const float aspect = random(0.4f, 2.5f);
  const float left = -near * random(0.1f, 2.0f);
  const float bottom = -near * random(0.1f, 2.0f);
  const float right = left + near * random(0.3f, 2.0f);
  const float top = bottom + near * random(0.3f, 2.0f);
  const float height = random(0.5f, 50.0f);
  return {{"perspective", glm::perspectiveNO(fov, aspect, near, far)},
          {"off-centre", glm::frustumNO(left, right, bottom, top, near, far)},
          {"orthographic", glm::orthoNO(-height * aspect, 1.2f * height, -0.7f * height, height, near, far)},
          {"orthographic, eye inside", glm::orthoNO(-height, height, -height, height, -far, far)},
          {"infinite", glm::infinitePerspective(fov, aspect, near)},
          {"zero to one", glm::perspectiveZO(fov, aspect, near, far), ClipDepth::zeroToOne},
          {"reversed", reversedDepth(glm::perspectiveZO(fov, aspect, near, far)), ClipDepth::zeroToOne, true},
          {"reversed, infinite",
           glm::mat4(glm::vec4(1.0f / (aspect * std::tan(fov / 2.0f)), 0.0f, 0.0f, 0.0f),
                     glm::vec4(0.0f, 1.0f / std::tan(fov / 2.0f), 0.0f, 0.0f),
                     glm::vec4(0.0f, 0.0f, 0.0f, -1.0f), glm::vec4(0.0f, 0.0f, near, 0.0f)),
           ClipDepth::zeroToOne, true},
          {"reversed, orthographic", reversedDepth(glm::orthoZO(-height, height, -height, height, near, far)),
           ClipDepth::zeroToOne, true}};
}

Frame frameOf(const Camera& camera, glm::ivec2 size) {
  return {
      .depth = 1, .normals = 1, .size = size, .projection = camera.projection, .clipDepth = camera.clipDepth};
}

double ndcDepth(const Camera& camera, double windowDepth) {
  return camera.clipDepth == ClipDepth::minusOneToOne ? 2.0 * windowDepth - 1.0 : windowDepth;
}

/// View position of window coordinates (0..1 each), by the inverse of the projection.
glm::dvec3 unprojectExactly(const Camera& camera, glm::dvec2 window, double windowDepth) {
  const glm::dvec4 ndc(window * 2.0 - 1.0, ndcDepth(camera, windowDepth), 1.0);
  const glm::dvec4 position = glm::inverse(glm::dmat4(camera.projection)) * ndc;
  return glm::dvec3(position) / position.w;
}

/// How much rounding in the coefficients is amplified by cancellation, times what a float rounds.
double toleranceOf(const params::FrameParams& params, double t) {
  const glm::dvec4 l(params.linearise);
  const double above = (std::abs(l.x) + std::abs(l.y * t)) / std::abs(l.x + l.y * t);
  const double below = (std::abs(l.z) + std::abs(l.w * t)) / std::abs(l.z + l.w * t);
  return 3e-7 * (above + below);
}

class GlslFunctions : public GlTest {
 protected:
  /// Runs frame.glsl's functions with the block of a frame.
  std::vector<glm::vec4> evaluateFrame(const std::string& expression, std::span<const glm::vec4> a,
                                       const params::FrameParams& params,
                                       const gl::Texture2D* normals = nullptr) {
    return evaluate(kFrame, expression, a, {}, [&](const gl::Program& program) {
      if (normals != nullptr) gl::bindTexture(kNormalUnit, normals->id(), nearest_);
      program.setTextureUnit("normalTexture", kNormalUnit);
      program.setBlockBinding("FrameParams", 0);
      frameBlock_.upload(params);
      frameBlock_.bind(0);
    });
  }

 private:
  gl::SamplerName nearest_ = gl::makeSampler(gl::Filter::nearest);
  gl::UniformBuffer<params::FrameParams> frameBlock_;
};

TEST_F(GlslFunctions, ViewDepthOfEveryKindOfProjection) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    Random random(seed + 100);
    std::vector<glm::vec4> depths;
    for (std::size_t i = 0; i < kInputs; ++i) {
      depths.emplace_back(i % 2 == 0 ? random(0.001f, 0.999f) : 1.0f - std::exp(random(-9.0f, -0.1f)));
    }
    for (const Camera& camera : randomCameras(seed)) {
      const params::FrameParams params = frameParams(frameOf(camera, {640, 480}));
      const auto values = evaluateFrame("vec4(viewDepthOf(a.x))", depths, params);
      for (std::size_t i = 0; i < depths.size(); ++i) {
        const auto t = static_cast<double>(depths[i].x);
        const double expected = -unprojectExactly(camera, glm::dvec2(0.5), t).z;
        ASSERT_NEAR(static_cast<double>(values[i].x) / expected, 1.0, toleranceOf(params, t))
            << camera.name << ", seed " << seed << ", window depth " << t << ", view depth " << expected;
      }
    }
  }
}

TEST_F(GlslFunctions, UnprojectOfEveryKindOfProjection) {
  const glm::ivec2 size(643, 481);
  for (unsigned seed = 0; seed < 3; ++seed) {
    for (const Camera& camera : randomCameras(seed)) {
      Random random(seed + 200);
      std::vector<glm::vec4> inputs;
      std::vector<glm::dvec3> expected;
      for (std::size_t i = 0; i < kInputs; ++i) {
        const glm::vec2 pixel(random(0.0f, 643.0f), random(0.0f, 481.0f));
        const glm::dvec3 position = unprojectExactly(camera, glm::dvec2(pixel) / glm::dvec2(size),
                                                     static_cast<double>(random(0.01f, 0.95f)));
        expected.push_back(position);
        inputs.emplace_back(pixel, static_cast<float>(-position.z), 0.0f);
      }
      const auto values =
          evaluateFrame("vec4(unproject(a.xy, a.z), 0.0)", inputs, frameParams(frameOf(camera, size)));
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double scale = glm::length(expected[i]) +
                             glm::length(glm::dvec3(unprojectExactly(camera, glm::dvec2(0.0), 0.5)));
        ASSERT_LT(glm::distance(glm::dvec3(values[i]), expected[i]), 2e-6 * scale)
            << camera.name << ", seed " << seed << ", depth " << inputs[i].z;
      }
    }
  }
}

TEST_F(GlslFunctions, ProjectionCoefficientsUndoUnproject) {
  const glm::ivec2 size(320, 200);
  for (const Camera& camera : randomCameras(7)) {
    Random random(300);
    std::vector<glm::vec4> inputs;
    for (std::size_t i = 0; i < kInputs; ++i) {
      const glm::dvec3 position =
          unprojectExactly(camera, glm::dvec2(0.5), static_cast<double>(random(0.05f, 0.9f)));
      inputs.emplace_back(random(0.0f, 320.0f), random(0.0f, 200.0f), static_cast<float>(-position.z), 0.0f);
    }
    const auto values = evaluateFrame(
        "vec4(vec2(dot(pixelX, vec4(unproject(a.xy, a.z), 1.0)), dot(pixelY, vec4(unproject(a.xy, a.z), "
        "1.0))) / "
        "dot(clipW, vec4(unproject(a.xy, a.z), 1.0)), 0.0, 0.0)",
        inputs, frameParams(frameOf(camera, size)));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      ASSERT_LT(glm::distance(glm::vec2(values[i]), glm::vec2(inputs[i])), 2e-3f) << camera.name;
    }
  }
}

TEST_F(GlslFunctions, BackgroundIsWhereTheFarPlaneIs) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    for (const Camera& camera : randomCameras(seed)) {
      EXPECT_EQ(frameParams(frameOf(camera, {64, 64})).backgroundDepth, camera.reversed ? 0.0f : 1.0f)
          << camera.name << ", seed " << seed;
    }
  }
}

TEST_F(GlslFunctions, ViewNormalOfEverySpaceAndEncoding) {
  Random random(400);
  std::vector<glm::vec4> texels;
  std::vector<glm::vec4> places;
  for (std::size_t i = 0; i < kInputs; ++i) {
    texels.emplace_back(random(-1.0f, 1.0f), random(-1.0f, 1.0f), random(-1.0f, 1.0f), 1.0f);
    places.emplace_back(i, 0, 0, 0);
  }
  const gl::Texture2D texture(GL_RGBA32F, {kInputs, 1}, "test.normals", 1, texels.data());
  const glm::mat4 view =
      glm::translate(glm::rotate(glm::mat4(1.0f), 2.0f, glm::normalize(glm::vec3(1, 2, 3))), {5, 6, 7});
  for (const NormalSpace space : {NormalSpace::view, NormalSpace::world}) {
    for (const NormalEncoding encoding : {NormalEncoding::signedXyz, NormalEncoding::unsignedXyz}) {
      Frame frame = frameOf({"", glm::perspective(1.0f, 1.0f, 0.1f, 9.0f)}, {64, 64});
      frame.view = view;
      frame.normalSpace = space;
      frame.normalEncoding = encoding;
      const auto values =
          evaluateFrame("vec4(viewNormal(ivec2(a.xy)), 0.0)", places, frameParams(frame), &texture);
      for (std::size_t i = 0; i < kInputs; ++i) {
        glm::dvec3 expected(texels[i]);
        if (encoding == NormalEncoding::unsignedXyz) expected = expected * 2.0 - 1.0;
        if (space == NormalSpace::world) expected = glm::dmat3(view) * expected;
        ASSERT_LT(glm::distance(glm::dvec3(values[i]), glm::normalize(expected)), 3e-6) << i;
      }
    }
  }
}

TEST_F(GlslFunctions, TangentFrameIsOrthonormalForEveryNormal) {
  Random random(1);
  std::vector<glm::vec4> normals;
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 any(random(-1.0f, 1.0f), random(-1.0f, 1.0f), random(-1.0f, 1.0f));
    normals.emplace_back(glm::normalize(any), 0.0f);
  }
  for (const float z : {1.0f, -1.0f}) {
    normals.emplace_back(0.0f, 0.0f, z, 0.0f);
    for (int power = 0; power < 17; ++power) {
      const auto tilt = static_cast<float>(1e-8 * std::pow(3.0, power));
      normals.emplace_back(glm::normalize(glm::vec3(random(-tilt, tilt), random(-tilt, tilt), z)), 0.0f);
    }
  }
  normals.emplace_back(1.0f, 0.0f, 0.0f, 0.0f);
  normals.emplace_back(0.0f, -1.0f, -0.0f, 0.0f);

  const std::string functions =
      "#include \"effects/common/hemisphere.glsl\"\n"
      "vec4 angles(vec3 n) { vec3 t, b; tangentFrame(n, t, b); return vec4(dot(t, b), dot(t, n), dot(b, n), "
      "0.0); }\n"
      "vec4 lengths(vec3 n) { vec3 t, b; tangentFrame(n, t, b); return vec4(length(t), length(b), "
      "dot(cross(t, b), n), "
      "1.0); }\n";
  const auto angles = evaluate(functions, "angles(a.xyz)", normals);
  const auto lengths = evaluate(functions, "lengths(a.xyz)", normals);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    ASSERT_LT(glm::length(angles[i]), 3e-6f) << normals[i].x << ", " << normals[i].y << ", " << normals[i].z;
    ASSERT_LT(glm::distance(lengths[i], glm::vec4(1.0f)), 3e-6f) << normals[i].x << ", " << normals[i].y;
  }
}

}  // namespace
}  // namespace mres::test
