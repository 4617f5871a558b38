// Odd files of shared/scenes/edge, all the way to a picture.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

#include "host/measure/effect_instance.h"
#include "host/platform/gl_context.h"

namespace host {
namespace {

std::filesystem::path edgeFolder() {
  if (const char* folder = std::getenv("MRES_SCENES")) return std::filesystem::path(folder) / "edge";
  return std::filesystem::path(__FILE__).parent_path() / "../../../shared/scenes/edge";
}

/// Each is odd in another way.
constexpr const char* kFiles[] = {
    "asset_generator/Positive/Buffer_Interleaved/Buffer_Interleaved_04.gltf",
    "asset_generator/Positive/Animation_Skin/Animation_Skin_01.gltf",
    "asset_generator/Positive/Instancing/Instancing_07.gltf",
    "asset_generator/Positive/Material_AlphaBlend/Material_AlphaBlend_04.gltf",
    "asset_generator/Positive/Material_AlphaMask/Material_AlphaMask_05.gltf",
    "asset_generator/Positive/Material_DoubleSided/Material_DoubleSided_03.gltf",
    "asset_generator/Positive/Material_SpecularGlossiness/Material_SpecularGlossiness_11.gltf",
    "asset_generator/Positive/Mesh_PrimitiveMode/Mesh_PrimitiveMode_06.gltf",
    "asset_generator/Positive/Mesh_PrimitiveVertexColor/Mesh_PrimitiveVertexColor_01.gltf",
    "asset_generator/Positive/Node_NegativeScale/Node_NegativeScale_05.gltf",
    "asset_generator/Positive/Texture_Sampler/Texture_Sampler_05.gltf",
    "bevy/gltf_primitives.glb",
    "tinygltf/box01.glb",
    "made_here/image_formats/image_formats.gltf",
};

FloatImage picture(const Scene& scene, const PictureSettings& settings) {
  constexpr glm::ivec2 kSize(33, 19);
  mres::gl::Profiler profiler;
  Renderer renderer(scene, profiler);
  const GBufferTextures& gbuffer = renderer.drawGeometry(scene.cameras.front(), kSize);
  EffectInstance instance(settings, kMresTechnique, EffectInstance::Coverage::unmeasured);
  instance.setInputs(drawInputs(renderer, settings));
  const GLuint values = instance.render(frameOf(renderer, gbuffer, kSize));
  return readTexture(renderer.drawLighting(screenEffects(settings, values)), kSize, 3);
}

TEST(EdgeScenes, AreDrawn) {
  if (!std::filesystem::exists(edgeFolder()))
    GTEST_SKIP() << "set MRES_SCENES to the folder with the test scenes";
  GlContext context(GlContext::Debug::on);
  for (const char* file : kFiles) {
    SCOPED_TRACE(file);
    const Scene scene = loadScene((edgeFolder() / file).string());
    for (const std::string& effect : effectNames()) {
      PictureSettings settings;
      settings.effect = effect;
      for (const float value : picture(scene, settings).pixels) ASSERT_TRUE(std::isfinite(value)) << effect;
    }
    ASSERT_EQ(context.takeErrors(), std::vector<std::string>());
  }
}

}  // namespace
}  // namespace host
