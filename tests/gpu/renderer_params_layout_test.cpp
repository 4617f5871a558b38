// The host's *_params.h headers: C++ and GLSL must put every member at the same place.
#include "host/renderer/embedded_shaders.h"
#include "shaders/host/environment_params.h"
#include "shaders/host/light_params.h"
#include "shaders/host/material_params.h"
#include "shaders/host/shadow_params.h"
#include "shaders/host/tone_map_params.h"
#include "shaders/host/view_params.h"
#include "tests/support/gl_test.h"
#include "tests/support/params_layout.h"

namespace host::test {
namespace {

namespace params = mres::params;
using mres::test::ParamsBlock;

std::vector<ParamsBlock> sceneBlocks() {
  return {{"host/view_params.h",
           "ViewParams",
           sizeof(params::ViewParams),
           "eye",
           {MEMBER(ViewParams, worldToClip), MEMBER(ViewParams, clipToWorld), MEMBER(ViewParams, eye)}},
          {"host/material_params.h",
           "MaterialParams",
           sizeof(params::MaterialParams),
           "alphaCutoff",
           {MEMBER(MaterialParams, baseColorFactor), MEMBER(MaterialParams, emissiveFactor),
            ARRAY_MEMBER(MaterialParams, baseColorUv), ARRAY_MEMBER(MaterialParams, metallicRoughnessUv),
            ARRAY_MEMBER(MaterialParams, normalUv), ARRAY_MEMBER(MaterialParams, emissiveUv),
            MEMBER(MaterialParams, metallicFactor), MEMBER(MaterialParams, roughnessFactor),
            MEMBER(MaterialParams, normalScale), MEMBER(MaterialParams, alphaCutoff)}},
          {"host/tone_map_params.h",
           "ToneMapParams",
           sizeof(params::ToneMapParams),
           "exposure",
           {MEMBER(ToneMapParams, exposure), MEMBER(ToneMapParams, toneMapPadding0),
            MEMBER(ToneMapParams, toneMapPadding1), MEMBER(ToneMapParams, toneMapPadding2)}}};
}

std::vector<ParamsBlock> lightBlocks() {
  return {{"host/environment_params.h",
           "EnvironmentParams",
           sizeof(params::EnvironmentParams),
           "skyZenith",
           {MEMBER(EnvironmentParams, skyZenith), MEMBER(EnvironmentParams, skyHorizon),
            MEMBER(EnvironmentParams, skyGround), MEMBER(EnvironmentParams, ambientAbove),
            MEMBER(EnvironmentParams, ambientBelow)}},
          {"host/shadow_params.h",
           "ShadowParams",
           sizeof(params::ShadowParams),
           "shadowTexel",
           {MEMBER(ShadowParams, worldToShadow), MEMBER(ShadowParams, shadowTexel),
            MEMBER(ShadowParams, shadowTexelMetres), MEMBER(ShadowParams, shadowPadding0),
            MEMBER(ShadowParams, shadowPadding1)}},
          {"host/light_params.h",
           "LightParams",
           sizeof(params::LightParams),
           "float(lightCount)",
           {ARRAY_MEMBER(LightParams, lightPosition), ARRAY_MEMBER(LightParams, lightIntensity),
            ARRAY_MEMBER(LightParams, lightDirection), MEMBER(LightParams, lightCount),
            MEMBER(LightParams, lightPadding0), MEMBER(LightParams, lightPadding1),
            MEMBER(LightParams, shadowedLights)}}};
}

class RendererParamsLayout : public mres::test::GlTest {};

TEST_F(RendererParamsLayout, EveryMemberIsWhereTheCompilersOfBothSidesPutIt) {
  const mres::gl::ShaderLibrary library = shaderLibrary();
  for (const std::vector<ParamsBlock>& blocks : {sceneBlocks(), lightBlocks()}) {
    for (const ParamsBlock& block : blocks) expectSameLayout(block, library.read(block.header));
  }
}

}  // namespace
}  // namespace host::test
