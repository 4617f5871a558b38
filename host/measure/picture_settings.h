#pragma once

#include <memory>
#include <string>
#include <vector>

#include "effects/ssao/ssao.h"
#include "host/renderer/renderer.h"
#include "mres/mres.h"

namespace host {

/// Everything of a picture that users choose besides scene, camera and size.
struct PictureSettings {
  std::string effect = "ssao";  ///< one of effectNames(), or kNoEffect
  mres::Technique technique = mres::Technique::multiResolution;
  mres::MaskSettings mask;
  mres::SsaoSettings ssao;
  RendererSettings renderer;
};

inline constexpr const char* kNoEffect = "none";

const std::vector<std::string>& effectNames();
const std::vector<std::string>& techniqueNames();
std::string nameOf(mres::Technique technique);

/// The effect that the settings name; nullptr for kNoEffect. Needs a current OpenGL context.
std::unique_ptr<mres::Effect> makeEffect(const PictureSettings& settings);

/// How many samples a pixel the effect takes; 0 for kNoEffect.
int sampleCount(const PictureSettings& settings);

}  // namespace host
