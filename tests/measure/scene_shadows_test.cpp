// Soft shadows of the built-in scenes, at their defaults, against rays: what lies in the sun has no acne, and
// no light creeps under what shades it.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <vector>

#include "effects/soft_shadows/disk_samples.h"
#include "host/measure/effect_instance.h"
#include "host/platform/gl_context.h"
#include "host/truth/ray_scene.h"
#include "host/truth/surface_frame.h"
#include "host/truth/surface_loop.h"

namespace host {
namespace {

constexpr glm::ivec2 kSize(160, 90);
constexpr int kRays = 64;  // from each pixel

constexpr float kLit = 0.98f;
constexpr float kDark = 0.02f;
constexpr int kOneIn = 200;  // pixels may be wrong

/// Of pixels whose rays are all open, or all blocked.
struct Tally {
  int compared = 0;
  int wrong = 0;
  void add(bool isWrong) {
    ++compared;
    wrong += isWrong ? 1 : 0;
  }
};

/// What the filter of soft shadows stands for, by rays: how much of the sun is seen from a disk of a
/// surface's tangent plane.
class SunOverDisk {
 public:
  SunOverDisk(const RayScene& scene, const mres::Frame& frame, const mres::ShadowInputs& shadow)
      : scene_(scene),
        toSun_(glm::inverse(frame.view) * shadow.light),
        acrossSun_(frameAround(toSun_)),
        texel_(1.0f / (glm::length(glm::vec3(glm::row(shadow.shadowFromView, 0))) *
                       static_cast<float>(shadow.mapSize.x))) {}

  /// Neither turned away nor so grazed by light that a surface's normal, which is smooth, and its triangles
  /// disagree on whether it is lit.
  [[nodiscard]] bool isSunny(const SurfacePoint& surface) const {
    constexpr float kLeastCosine = 0.1f;
    return !surface.background && glm::dot(toSun_, surface.normal) > kLeastCosine;
  }

  /// 0 for surfaces that face away. `seed` turns the rays.
  [[nodiscard]] float openShare(const SurfacePoint& surface, int seed) const {
    const float cosine = glm::dot(toSun_, surface.normal);
    if (cosine <= 0.0f) return 0.0f;
    const float radius = filterRadius(cosine);
    const glm::vec3 raised = surface.origin + kRise * radius * surface.normal;
    const glm::vec3 segment = scene_.diameter() * toSun_;
    int blocked = 0;
    for (const glm::vec2 sample : mres::diskSamples(kRays, seed)) {
      const glm::vec3 across = acrossSun_ * glm::vec3((kWider * radius + texel_) * sample, 0.0f);
      const glm::vec3 onPlane = across - glm::dot(across, surface.normal) / cosine * toSun_;
      blocked += scene_.countBlocked(raised + onPlane, std::span(&segment, 1));
    }
    return 1.0f - static_cast<float>(blocked) / kRays;
  }

 private:
  static constexpr float kWider = 1.25f;  // than the filter, lest its rim see what falls between two rays
  static constexpr float kRise = 0.08f;   // less than the filter's bias, a tenth of its radius

  /// In metres. As in shaders/effects/soft_shadows.glsl: it shrinks, down to a texel, where light grazes.
  [[nodiscard]] float filterRadius(float cosine) const {
    constexpr float kSteepestSlope = 4.0f;
    const float slope = std::sqrt(std::max(1.0f - cosine * cosine, 0.0f)) / cosine;
    const float share = std::min(kSteepestSlope / slope, 1.0f);
    return std::max(share * mres::SoftShadowSettings().filterRadius, texel_);
  }

  const RayScene& scene_;
  glm::vec3 toSun_;
  glm::mat3 acrossSun_;
  float texel_;  // of the shadow map, metres
};

/// Of the pixels of a grid.
struct Sunlight {
  PixelGrid grid;
  FloatImage open;          ///< SunOverDisk::openShare(), 1 where there is no surface
  std::vector<bool> sunny;  ///< SunOverDisk::isSunny()
};

std::size_t indexOf(glm::ivec2 point, glm::ivec2 size) {
  return static_cast<std::size_t>(point.y * size.x + point.x);
}

/// At a point of the grid and all its neighbours: what the filter of a level may mix.
bool isAllAround(glm::ivec2 point, float share, const FloatImage& open) {
  for (int i = 0; i < 25; ++i) {
    const glm::ivec2 neighbour = point + glm::ivec2(i % 5, i / 5) - 2;
    const glm::ivec2 inside = glm::clamp(neighbour, glm::ivec2(0), open.size - 1);
    if (open.pixels[indexOf(inside, open.size)] != share) return false;
  }
  return true;
}

PictureSettings softShadowsByDefault() {
  PictureSettings settings;
  settings.effect = kSoftShadowEffect;
  return settings;
}

/// The shadows of one technique, and how they compare.
class Shadows {
 public:
  explicit Shadows(const std::string& technique)
      : name_(technique),
        instance_(softShadowsByDefault(), technique, EffectInstance::Coverage::unmeasured) {}

  void compare(const Sunlight& sunlight, const mres::Frame& frame, const EffectInputs& inputs) {
    instance_.setInputs(inputs);
    const FloatImage seen = valuesAt(sunlight.grid, readTexture(instance_.render(frame), kSize, 1));
    for (int y = 0; y < seen.size.y; ++y)
      for (int x = 0; x < seen.size.x; ++x) {
        const std::size_t i = indexOf({x, y}, seen.size);
        if (!sunlight.sunny[i]) continue;
        if (isAllAround({x, y}, 1.0f, sunlight.open)) lit_.add(seen.pixels[i] < kLit);
        if (isAllAround({x, y}, 0.0f, sunlight.open)) dark_.add(seen.pixels[i] > kDark);
      }
  }

  void expectRight() const {
    EXPECT_GT(lit_.compared, 100) << name_;
    EXPECT_LE(lit_.wrong, lit_.compared / kOneIn) << name_ << ": acne, of " << lit_.compared;
    EXPECT_GT(dark_.compared, 300) << name_;
    EXPECT_LE(dark_.wrong, dark_.compared / kOneIn) << name_ << ": leaks, of " << dark_.compared;
  }

 private:
  std::string name_;
  EffectInstance instance_;
  Tally lit_;
  Tally dark_;
};

struct SunlitFloor {
  const char* scene;
  glm::vec3 middle;
  glm::vec3 eye;  ///< from which it is well seen
};

class SceneShadows : public testing::TestWithParam<SunlitFloor> {
 protected:
  [[nodiscard]] std::array<Camera, 3> cameras() const {
    return {scene_.cameras.at(1), lookAt("sunlit floor", GetParam().eye, GetParam().middle, 50.0f),
            besideTheSun()};
  }

  Sunlight sunlightIn(const mres::Frame& frame, const mres::ShadowInputs& shadow) {
    const SunOverDisk sun(rays_, frame, shadow);
    const GridSurfaces surfaces = readSurfaces({.pictureSize = frame.size, .stride = glm::ivec2(1)}, frame);
    const auto openShare = [&](const SurfacePoint& point, int index) { return sun.openShare(point, index); };
    Sunlight sunlight{surfaces.grid, evaluateEach(surfaces, openShare, [](auto&&...) {}), {}};
    for (const SurfacePoint& point : surfaces.points) sunlight.sunny.push_back(sun.isSunny(point));
    return sunlight;
  }

  GlContext context_;
  mres::gl::Profiler profiler_;
  Scene scene_ = loadScene(GetParam().scene);
  RayScene rays_{scene_};
  Renderer renderer_{scene_, profiler_, rendererSettings(softShadowsByDefault())};

 private:
  /// From outside, with the sun 30 degrees to the side: most of what is seen there lies in it.
  [[nodiscard]] Camera besideTheSun() const {
    const Bounds bounds = boundsOf(scene_);
    const glm::vec3 middle = 0.5f * (bounds.min + bounds.max);
    const float radius = 0.5f * glm::distance(bounds.min, bounds.max);
    const glm::quat turn = glm::angleAxis(glm::radians(30.0f), glm::vec3(0.0f, 1.0f, 0.0f));
    const glm::vec3 eye = middle - 2.0f * radius * (turn * scene_.lights.front().direction);
    Camera camera = lookAt("beside the sun", eye, middle, 40.0f);
    camera.nearPlane = 0.5f * radius;  // depths so far away would be coarse
    return camera;
  }
};

TEST_P(SceneShadows, AreLitWhereRaysAreOpenAndDarkWhereTheyAreBlocked) {
  Shadows full(kFullTechnique);
  Shadows mixed(kMresTechnique);
  for (const Camera& camera : cameras()) {
    const mres::Frame frame = frameOf(renderer_, renderer_.drawGeometry(camera, kSize), kSize);
    const EffectInputs inputs = drawInputs(renderer_, softShadowsByDefault());
    const Sunlight sunlight = sunlightIn(frame, inputs.shadow);
    for (Shadows* shadows : {&full, &mixed}) shadows->compare(sunlight, frame, inputs);
  }
  full.expectRight();
  mixed.expectRight();
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, SceneShadows,
                         testing::Values(SunlitFloor{"hall", {2.8f, 0.0f, 8.8f}, {2.0f, 1.7f, 13.0f}},
                                         SunlitFloor{"breakfast", {2.1f, 0.0f, -0.6f}, {2.4f, 1.7f, 1.2f}},
                                         SunlitFloor{"office", {0.8f, 0.0f, -1.0f}, {1.3f, 1.5f, 0.6f}}),
                         [](const auto& floor) { return std::string(floor.param.scene); });

}  // namespace
}  // namespace host
