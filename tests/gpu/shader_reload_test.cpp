// Shader errors name their file and line; shaders on disk win over embedded ones; a broken one changes
// nothing.
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

#include "effects/ssao/ssao.h"
#include "mres/mres.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::ThrowsMessage;

// A wrong type: for undeclared names Mesa itself tells the line, but always file 0.
TEST_F(GlTest, ShaderErrorsNameTheIncludedFileAndItsLine) {
  gl::ShaderLibrary library = shaderLibrary();
  library.add("test/broken.glsl", "float fine() { return 1.0; }\n\nfloat broken() { return vec2(1.0); }\n");
  library.add("test/main.frag",
              "#version 330 core\n#include \"mres/level.glsl\"\n#include \"test/broken.glsl\"\n"
              "out vec4 color;\nvoid main() { color = vec4(fine()); }\n");
  EXPECT_THAT(
      [&] {
        gl::Program(library, {"common/full_screen.vert", "test/main.frag", "#define A\n#define B\n"});
      },
      ThrowsMessage<std::runtime_error>(
          AllOf(HasSubstr("Shader 'test/main.frag' does not compile"), HasSubstr("test/broken.glsl:3"))));
}

TEST_F(GlTest, ShaderErrorsAfterDefinesAndIncludesNameTheirOwnLine) {
  gl::ShaderLibrary library = shaderLibrary();
  library.add("test/main.frag",
              "// about\n#version 330 core\n#include \"mres/level.glsl\"\nout vec4 color;\n"
              "void main() { color = nothing; }\n");
  EXPECT_THAT(
      [&] {
        gl::Program(library, {"common/full_screen.vert", "test/main.frag", "#define A\n#define B\n"});
      },
      ThrowsMessage<std::runtime_error>(HasSubstr("test/main.frag:5")));
}

class ShaderReload : public GlTest {
 protected:
  ShaderReload() : gbuffer_({64, 48}, perspective({64, 48}), room()) {}
  void SetUp() override {
    directory_ =
        std::filesystem::path(testing::TempDir()) /
        (std::string("mres_reload_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(directory_ / "mres");
    std::filesystem::create_directories(directory_ / "effects");
    multiResolution_.emplace(Options{.shaderDirectory = directory_.string()});
  }
  void TearDown() override {
    std::filesystem::remove_all(directory_);
    GlTest::TearDown();
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_ / name) << text;
  }
  Picture render() { return renderPicture(*multiResolution_, ssao_, gbuffer_.frame()); }

  std::filesystem::path directory_;
  SyntheticGBuffer gbuffer_;
  std::optional<MultiResolution> multiResolution_;
  Ssao ssao_{{.samples = 4}};
};

TEST_F(ShaderReload, TakesAnEffectFromDiskAndBack) {
  const Picture embedded = render();
  write("effects/ssao.glsl", "vec4 shade(Surface surface) { return vec4(0.25); }\n");
  EXPECT_EQ(render(), embedded) << "not before reloadShaders()";
  multiResolution_->reloadShaders();
  EXPECT_THAT(render(), Each(0.25f));
  std::filesystem::remove(directory_ / "effects/ssao.glsl");
  multiResolution_->reloadShaders();
  EXPECT_EQ(render(), embedded);
}

TEST_F(ShaderReload, KeepsTheOldShadersIfOneIsBroken) {
  const Picture before = render();
  for (const char* name : {"effects/ssao.glsl", "mres/composite.frag", "mres/edges.frag", "mres/filter.glsl",
                           "mres/zone.frag", "mres/debug_view.frag", "mres/mask_blur.frag"}) {
    const bool isMain = std::string(name).ends_with(".frag");
    write(name, std::string(isMain ? "#version 330 core" : "") + "\nthis is no GLSL\n");
    EXPECT_THAT([&] { multiResolution_->reloadShaders(); },
                ThrowsMessage<std::runtime_error>(HasSubstr(std::string(name) + ":2")))
        << name;
    EXPECT_EQ(render(), before) << name;
    EXPECT_NO_THROW(static_cast<void>(multiResolution_->debugView(DebugView::levels))) << name;
    std::filesystem::remove(directory_ / name);
  }
  multiResolution_->reloadShaders();
  EXPECT_EQ(render(), before);
}

TEST_F(ShaderReload, NeedsNothingOfAnEffectThatIsGone) {
  const TestEffect::Recipe recipe{.body = "return vec4(0.25);  // " + std::string(5000, '-')};
  auto effect = std::make_unique<TestEffect>(recipe);
  static_cast<void>(renderPicture(*multiResolution_, *effect, gbuffer_.frame()));
  effect.reset();
  const std::vector<std::string> reusedMemory(100, std::string(5100, '#'));
  EXPECT_NO_THROW(multiResolution_->reloadShaders());
  TestEffect again(recipe);
  EXPECT_THAT(renderPicture(*multiResolution_, again, gbuffer_.frame()), Each(0.25f));
}

TEST_F(ShaderReload, DebugViewsWaitForTheNextFrame) {
  static_cast<void>(render());
  multiResolution_->reloadShaders();
  EXPECT_THAT([&] { multiResolution_->debugView(DebugView::edges); },
              ThrowsMessage<std::logic_error>(HasSubstr("call render() first")));
  static_cast<void>(render());
  EXPECT_NO_THROW(multiResolution_->debugView(DebugView::edges));
}

TEST_F(ShaderReload, ABrokenShaderAtTheStartIsSaidInTheConstructor) {
  write("mres/edges.frag", "#version 330 core\nvoid main() { undefined(); }\n");
  EXPECT_THAT([&] { MultiResolution({.shaderDirectory = directory_.string()}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("mres/edges.frag:2")));
}

}  // namespace
}  // namespace mres::test
