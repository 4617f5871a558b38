// `mres export`: what it writes is seen as the scene itself is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "host/image/image_file.h"
#include "tests/cli/command_support.h"

namespace host::test {
namespace {

TEST_F(Command, ExportedSceneHasTheSameAmbientOcclusion) {
  EXPECT_EQ(succeed({"export", scene_, "--camera", "1", "-o", folder_ / "copy.glb"}),
            folder_ / "copy.glb" + std::string("\n"));
  const auto occlusion = [&](const std::string& scene, const std::string& camera) {
    succeed({"compare", scene, "--camera", camera, "--size", "64x36", "--no-timing", "-o", folder_ / "out"});
    return readImage(folder_ / "out/effect_full.exr").pixels;
  };
  EXPECT_EQ(occlusion(folder_ / "copy.glb", "0"), occlusion(scene_, "1"));
}

TEST_F(Command, ExportsAllCameras) {
  succeed({"export", scene_, "--camera", "all", "-o", folder_ / "copy.glb"});
  succeed({"render", folder_ / "copy.glb", "--camera", "1", "--size", "8x8", "-o", folder_ / "a.png"});
}

}  // namespace
}  // namespace host::test
