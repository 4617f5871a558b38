#pragma once

#include <memory>

#include "host/bench/suite.h"
#include "host/measure/comparison.h"

namespace host {

/// The scene and the comparison of the case at hand, kept for the next one if it needs the same.
class Workbench {
 public:
  explicit Workbench(bool softwareRasterizer) : softwareRasterizer_(softwareRasterizer) {}

  /// Throws as loadScene() does.
  const Scene& scene(const BenchScene& wanted);

  /// Of the scene that was asked for last, with its shaders compiled.
  Comparison& comparison(const PictureSettings& settings, const PictureSettings& reference,
                         const Json& values);

 private:
  bool softwareRasterizer_;
  std::string source_;
  Scene scene_;
  Json key_;  // what comparison_ is of
  std::unique_ptr<Comparison> comparison_;
};

}  // namespace host
