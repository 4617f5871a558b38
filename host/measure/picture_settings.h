#pragma once

#include <memory>
#include <string>
#include <vector>

#include "effects/soft_shadows/soft_shadows.h"
#include "effects/ssao/ssao.h"
#include "effects/ssgi/ssgi.h"
#include "host/measure/techniques.h"
#include "host/renderer/renderer.h"
#include "mres/mres.h"

namespace host {

/// Everything of a picture that users choose besides scene, camera and size.
struct PictureSettings {
  std::string effect = "ssao";             ///< one of effectNames(), or kNoEffect
  std::string technique = kMresTechnique;  ///< one of techniqueNames()
  mres::PlanSettings plan;
  mres::MaskSettings mask;
  mres::SsaoSettings ssao;
  mres::SoftShadowSettings softShadows;
  mres::SsgiSettings ssgi;
  RendererSettings renderer;
  std::string importance;  ///< picture whose first channel is mres::Frame::importance; empty: none
};

inline constexpr const char* kSsaoEffect = "ssao";
inline constexpr const char* kSoftShadowEffect = "ssm";
inline constexpr const char* kSsgiEffect = "ssgi";
inline constexpr const char* kNoEffect = "none";

const std::vector<std::string>& effectNames();

/// The effect that the settings name; nullptr for kNoEffect. Needs a current OpenGL context.
std::unique_ptr<mres::Effect> makeEffect(const PictureSettings& settings);

/// Those of the renderer, with what the effect asks of it.
RendererSettings rendererSettings(const PictureSettings& settings);

/// What effects read of a frame besides the G-buffer.
struct EffectInputs {
  mres::ShadowInputs shadow;
  mres::SsgiInputs ssgi;
};

/// After the renderer's drawGeometry(): draws what the effect that the settings name reads.
EffectInputs drawInputs(Renderer& renderer, const PictureSettings& settings);
void setInputs(mres::Effect& effect, const EffectInputs& inputs);

/// Where the lighting takes the values of the effect that the settings name.
ScreenEffects screenEffects(const PictureSettings& settings, GLuint values);

/// Calls `visitor` with the settings of the effect that `settings` names.
template <class Visitor>
void visitEffect(PictureSettings& settings, Visitor&& visitor) {
  if (settings.effect == kSoftShadowEffect)
    visitor(settings.softShadows);
  else if (settings.effect == kSsgiEffect)
    visitor(settings.ssgi);
  else
    visitor(settings.ssao);
}

/// How many samples a pixel the effect takes; 0 for kNoEffect.
int sampleCount(const PictureSettings& settings);

}  // namespace host
