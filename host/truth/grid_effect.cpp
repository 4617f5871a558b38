#include "host/truth/grid_effect.h"

#include <fmt/format.h>
#include <utility>

namespace host {
namespace {

constexpr const char* kShaderName = "truth/grid_effect.glsl";

/// The effect's shader with a shade() around its own.
std::string shaderOf(const mres::EffectDescription& effect, const PixelGrid& grid) {
  return fmt::format(R"(#define shade shadeAnywhere
#include "{}"
#undef shade

vec4 shade(Surface surface) {{
    ivec2 tile = ivec2(surface.pixel) / {};
    if (tile % ivec2({}, {}) != ivec2(0)) return vec4(0.0);
    return shadeAnywhere(surface);
}}
)",
                     effect.shader, grid.tile, grid.stride.x, grid.stride.y);
}

}  // namespace

GridEffect::GridEffect(std::unique_ptr<mres::Effect> effect, const PixelGrid& grid)
    : effect_(std::move(effect)),
      shader_(shaderOf(effect_->description(), grid)),
      files_(effect_->description().shaders.begin(), effect_->description().shaders.end()),
      description_(effect_->description()) {
  files_.push_back({kShaderName, shader_});
  description_.shader = kShaderName;
  description_.shaders = files_;
  description_.filtered = false;
  description_.hasPreview = false;  // edges would be sought for nothing
}

}  // namespace host
