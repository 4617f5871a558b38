// The *_params.h headers are read by C++ and by GLSL: both must put every member at the same place.
#include "tests/support/params_layout.h"

#include "shaders/effects/soft_shadows_params.h"
#include "shaders/effects/ssao_params.h"
#include "shaders/effects/ssgi_params.h"
#include "shaders/mres/edges_params.h"
#include "shaders/mres/frame_params.h"
#include "shaders/mres/level_params.h"
#include "shaders/mres/mask_blur_params.h"
#include "tests/support/gl_test.h"

namespace mres::test {
namespace {

std::vector<ParamsBlock> allBlocks() {
  return {
      {"mres/frame_params.h",
       "FrameParams",
       sizeof(params::FrameParams),
       "linearise.x",
       {MEMBER(FrameParams, viewFromNormals), MEMBER(FrameParams, pixelX), MEMBER(FrameParams, pixelY),
        MEMBER(FrameParams, clipW), MEMBER(FrameParams, unprojectScaled),
        MEMBER(FrameParams, unprojectConstant), MEMBER(FrameParams, linearise),
        MEMBER(FrameParams, normalDecode), MEMBER(FrameParams, size), MEMBER(FrameParams, filterDepth),
        MEMBER(FrameParams, filterTolerance), MEMBER(FrameParams, depthRounding),
        MEMBER(FrameParams, backgroundDepth), MEMBER(FrameParams, pixelsPerMetre),
        MEMBER(FrameParams, pyramidLevels), MEMBER(FrameParams, framePadding0),
        MEMBER(FrameParams, framePadding1), MEMBER(FrameParams, framePadding2)}},
      {"mres/level_params.h",
       "LevelParams",
       sizeof(params::LevelParams),
       "blendWeight",
       {MEMBER(LevelParams, levelSize), MEMBER(LevelParams, levelStride),
        MEMBER(LevelParams, levelHalfStride), MEMBER(LevelParams, coarserFromPixel),
        MEMBER(LevelParams, maskFromPixel), MEMBER(LevelParams, blendWeight),
        MEMBER(LevelParams, refineThreshold), MEMBER(LevelParams, zoneFromPixel),
        MEMBER(LevelParams, lastInterval), MEMBER(LevelParams, noisePeriod), MEMBER(LevelParams, levelJitter),
        MEMBER(LevelParams, coarserJitter), MEMBER(LevelParams, coarserStride)}},
      {"mres/edges_params.h",
       "EdgesParams",
       sizeof(params::EdgesParams),
       "depthThreshold",
       {MEMBER(EdgesParams, normalDifference2), MEMBER(EdgesParams, depthThreshold),
        MEMBER(EdgesParams, edgesPadding0), MEMBER(EdgesParams, edgesPadding1)}},
      {"mres/mask_blur_params.h",
       "MaskBlurParams",
       sizeof(params::MaskBlurParams),
       "float(radius)",
       {MEMBER(MaskBlurParams, axis), MEMBER(MaskBlurParams, radius), MEMBER(MaskBlurParams, finerRatio),
        ARRAY_MEMBER(MaskBlurParams, weights)}},
      {"effects/soft_shadows_params.h",
       "SoftShadowsParams",
       sizeof(params::SoftShadowsParams),
       "bias",
       {MEMBER(SoftShadowsParams, shadowU), MEMBER(SoftShadowsParams, shadowV),
        MEMBER(SoftShadowsParams, shadowDepth), MEMBER(SoftShadowsParams, shadowW),
        MEMBER(SoftShadowsParams, light), MEMBER(SoftShadowsParams, shadowMapSize),
        MEMBER(SoftShadowsParams, mapDistance), MEMBER(SoftShadowsParams, filterRadius),
        MEMBER(SoftShadowsParams, penumbraScale), MEMBER(SoftShadowsParams, bias),
        MEMBER(SoftShadowsParams, sampleCount)}},
      {"effects/soft_shadows_params.h",
       "SoftShadowsSamples",
       sizeof(params::SoftShadowsSamples),
       "samples[0].x",
       {ARRAY_MEMBER(SoftShadowsSamples, samples), ARRAY_MEMBER(SoftShadowsSamples, blockerSamples),
        ARRAY_MEMBER(SoftShadowsSamples, previewSamples)}},
      {"effects/ssao_params.h",
       "SsaoParams",
       sizeof(params::SsaoParams),
       "radius",
       {MEMBER(SsaoParams, radius), MEMBER(SsaoParams, bias), MEMBER(SsaoParams, intensity),
        MEMBER(SsaoParams, sampleCount), ARRAY_MEMBER(SsaoParams, samples)}},
      {"effects/ssgi_params.h",
       "SsgiParams",
       sizeof(params::SsgiParams),
       "bounce",
       {MEMBER(SsgiParams, radius), MEMBER(SsgiParams, bias), MEMBER(SsgiParams, bounce),
        MEMBER(SsgiParams, sampleCount), MEMBER(SsgiParams, up), MEMBER(SsgiParams, environmentAbove),
        MEMBER(SsgiParams, environmentBelow), MEMBER(SsgiParams, radianceScale),
        MEMBER(SsgiParams, maxRadiance), MEMBER(SsgiParams, ssgiPadding)}},
      {"effects/ssgi_params.h",
       "SsgiPoints",
       sizeof(params::SsgiPoints),
       "points[0].x",
       {ARRAY_MEMBER(SsgiPoints, points)}}};
}

class ParamsLayout : public GlTest {};

TEST_F(ParamsLayout, EveryMemberIsWhereTheCompilersOfBothSidesPutIt) {
  for (const ParamsBlock& block : allBlocks()) {
    expectSameLayout(block, "#include \"" + block.header + "\"");
  }
}

}  // namespace
}  // namespace mres::test
