// Which scenes `mres bench --scenes` finds, and what it calls them.
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

#include "host/bench/scenes.h"
#include "tests/support/temporary_folder.h"

namespace host {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class BenchScenes : public testing::Test {
 protected:
  BenchScenes() {
    for (const char* file : {"box.glb", "a/scene.gltf", "a/scene.bin", "b/scene.GLTF", "b/c/scene.glb",
                             "b/c/scene.gltf", "empty/readme.txt"}) {
      fs::create_directories((folder_ / file).parent_path());
      std::ofstream(folder_ / file) << "";
    }
  }
  [[nodiscard]] std::vector<std::string> namesOf(const std::vector<fs::path>& paths) const {
    std::vector<std::string> names;
    for (const BenchScene& scene : findScenes(paths)) names.push_back(scene.name);
    return names;
  }

  test::TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(BenchScenes, AreAllBelowAFolder) {
  EXPECT_THAT(namesOf({folder_}), testing::SizeIs(5));
  EXPECT_THAT(namesOf({folder_ / "a"}), ElementsAre("scene"));
  EXPECT_EQ(findScenes({folder_ / "a"})[0].source, (folder_ / "a/scene.gltf").string());
}

TEST_F(BenchScenes, AreCalledSoThatNoTwoShareAName) {
  EXPECT_THAT(namesOf({folder_ / "a", folder_ / "box.glb", folder_ / "b/scene.GLTF"}),
              ElementsAre("a-scene", "b-scene", "box"));
  EXPECT_THAT(namesOf({folder_ / "b/c"}),
              ElementsAre(testing::EndsWith("c-scene.glb"), testing::EndsWith("c-scene.gltf")));
}

TEST_F(BenchScenes, CountOnceHoweverOftenTheyAreNamed) {
  EXPECT_THAT(namesOf({folder_ / "a", folder_ / "b/../a/scene.gltf"}), ElementsAre("scene"));
}

TEST_F(BenchScenes, ThatAreMissingAreTold) {
  EXPECT_THROW(findScenes({folder_ / "nowhere"}), std::runtime_error);
  EXPECT_THROW(findScenes({folder_ / "empty"}), std::runtime_error);
}

}  // namespace
}  // namespace host
