#include "host/bench/workbench.h"

#include <utility>

namespace host {
namespace {

constexpr glm::ivec2 kWarmUpSize{64, 36};

}  // namespace

const Scene& Workbench::scene(const BenchScene& wanted) {
  if (source_ == wanted.source) return scene_;
  comparison_.reset();  // it refers to the old scene
  source_.clear();      // of neither scene if loading fails
  scene_ = loadScene(wanted.source);
  scene_.name = wanted.name;
  source_ = wanted.source;
  return scene_;
}

Comparison& Workbench::comparison(const PictureSettings& settings, const PictureSettings& reference,
                                  const Json& values) {
  Json key{settings.effect, settings.technique, values, sampleCount(reference)};
  if (comparison_ && key_ == key) return *comparison_;
  comparison_.reset();  // before the next takes memory
  comparison_ = std::make_unique<Comparison>(scene_, settings, reference, softwareRasterizer_);
  key_ = std::move(key);
  // Compiles everything, so that slow cases need not be warmed up at their own size.
  comparison_->measure({0, kWarmUpSize, std::nullopt});
  return *comparison_;
}

}  // namespace host
