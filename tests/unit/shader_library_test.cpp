#include "mres/gl/shader_library.h"

#include <array>
#include <fstream>
#include <gmock/gmock.h>
#include <stdexcept>

namespace mres::gl {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

/// A directory of its own for shader files, removed at the end.
class ShaderDirectory : public testing::Test {
 protected:
  void SetUp() override {
    directory_ =
        std::filesystem::path(testing::TempDir()) /
        (std::string("mres_shaders_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(directory_ / "mres");
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_ / name) << text;
  }

  std::filesystem::path directory_;
};

ShaderLibrary libraryOf(std::initializer_list<ShaderFile> files) {
  ShaderLibrary library;
  library.add(std::span(files.begin(), files.size()));
  return library;
}

/// Line of the preprocessed text -> (line, file) as #line directives tell a compiler.
struct Place {
  int line;
  std::string file;
  bool operator==(const Place&) const = default;
};

Place placeOf(const PreprocessedShader& shader, const std::string& needle) {
  std::istringstream text(shader.text);
  std::string line;
  int number = 0;
  std::size_t file = 0;
  while (std::getline(text, line)) {
    ++number;
    if (line.find(needle) != std::string::npos) return {number, shader.fileNames.at(file)};
    int directed = 0;
    if (std::sscanf(line.c_str(), "#line %d %zu", &directed, &file) == 2) number = directed - 1;
  }
  return {0, "not found"};
}

TEST(ShaderLibrary, IncludesAFileOnce) {
  const auto library = libraryOf({{"main", "#include \"a\"\n#include \"b\"\n#include \"a\"\nMAIN\n"},
                                  {"a", "CONTENT_A\n"},
                                  {"b", "#include \"a\"\nCONTENT_B\n"}});
  const PreprocessedShader shader = preprocess(library, "main");
  EXPECT_EQ(shader.text.find("CONTENT_A"), shader.text.rfind("CONTENT_A"));
  EXPECT_LT(shader.text.find("CONTENT_A"), shader.text.find("CONTENT_B"));
  EXPECT_LT(shader.text.find("CONTENT_B"), shader.text.find("MAIN"));
  EXPECT_THAT(shader.fileNames, ElementsAre("main", "a", "b"));
}

TEST(ShaderLibrary, CyclesEnd) {
  const auto library = libraryOf({{"a", "#include \"b\"\nA\n"}, {"b", "#include \"a\"\nB\n"}});
  EXPECT_THAT(preprocess(library, "a").text, AllOf(HasSubstr("A\n"), HasSubstr("B\n")));
}

TEST(ShaderLibrary, LineDirectivesKeepTheNumbersOfEveryFile) {
  const auto library = libraryOf({{"main", "#version 330\nM2\n#include \"a\"\nM4\n\n#include \"c\"\nM7\n"},
                                  {"a", "A1\n#include \"b\"\nA3\n"},
                                  {"b", "B1\nB2"},
                                  {"c", "C1\n"}});
  const PreprocessedShader shader = preprocess(library, "main", "#define FIRST\n#define SECOND\n");
  EXPECT_EQ(placeOf(shader, "M2"), (Place{2, "main"}));
  EXPECT_EQ(placeOf(shader, "A1"), (Place{1, "a"}));
  EXPECT_EQ(placeOf(shader, "B2"), (Place{2, "b"}));
  EXPECT_EQ(placeOf(shader, "A3"), (Place{3, "a"}));
  EXPECT_EQ(placeOf(shader, "M4"), (Place{4, "main"}));
  EXPECT_EQ(placeOf(shader, "C1"), (Place{1, "c"}));
  EXPECT_EQ(placeOf(shader, "M7"), (Place{7, "main"}));
}

TEST(ShaderLibrary, DefinesFollowTheVersion) {
  const auto library = libraryOf({{"main", "// about\n#version 330 core\nBODY\n"}});
  const std::string text = preprocess(library, "main", "#define X 1\n").text;
  EXPECT_LT(text.find("#version"), text.find("#define X 1"));
  EXPECT_LT(text.find("#define X 1"), text.find("BODY"));
}

TEST(ShaderLibrary, AngleBracketsAreTheCompilersOwn) {
  const auto library = libraryOf({{"main", "#include <system>\nBODY\n"}});
  EXPECT_THAT(preprocess(library, "main").text, HasSubstr("#include <system>"));
}

TEST(ShaderLibrary, DirectivesMayBeIndentedAndSpaced) {
  const auto library = libraryOf({{"main", "  #include   \"a\"\n"}, {"a", "CONTENT\n"}});
  EXPECT_THAT(preprocess(library, "main").text, AllOf(HasSubstr("CONTENT"), Not(HasSubstr("#include"))));
}

TEST(ShaderLibrary, WindowsLineEndsAreFine) {
  const auto library =
      libraryOf({{"main", "#version 330\r\n#include \"a\"\r\nBODY\r\n"}, {"a", "CONTENT\r\n"}});
  EXPECT_THAT(preprocess(library, "main").text, AllOf(HasSubstr("CONTENT"), HasSubstr("BODY")));
}

TEST(ShaderLibrary, AMissingFileIsNamed) {
  const auto library = libraryOf({{"main", "#include \"mres/nowhere.glsl\"\n"}});
  EXPECT_THAT([&] { static_cast<void>(preprocess(library, "main")); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("'mres/nowhere.glsl' was not found"), HasSubstr("check the name"))));
}

TEST_F(ShaderDirectory, WinsOverEmbeddedFiles) {
  auto library = libraryOf({{"mres/a", "EMBEDDED_A"}, {"mres/b", "EMBEDDED_B"}});
  write("mres/a", "DISK_A");
  library.setDirectory(directory_);
  EXPECT_EQ(library.read("mres/a"), "DISK_A");
  EXPECT_EQ(library.read("mres/b"), "EMBEDDED_B");
}

TEST_F(ShaderDirectory, IsNamedWhereAFileIsMissing) {
  auto library = libraryOf({});
  library.setDirectory(directory_);
  EXPECT_THAT([&] { static_cast<void>(library.read("mres/a")); },
              ThrowsMessage<std::runtime_error>(HasSubstr(directory_.string())));
}

TEST_F(ShaderDirectory, FoldersAreNoFiles) {
  auto library = libraryOf({});
  library.setDirectory(directory_);
  EXPECT_THROW(static_cast<void>(library.read("mres")), std::runtime_error);
}

}  // namespace
}  // namespace mres::gl
