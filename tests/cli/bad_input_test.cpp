// Whatever is wrong: one sentence on stderr, the right exit code, and no file left behind.
#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/cli/process.h"

namespace host::test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class BadInput : public testing::Test {
 protected:
  /// The one line on stderr; all else about the failure is checked here.
  std::string failureOf(const std::vector<std::string>& arguments, int exitCode,
                        const std::vector<std::string>& environment = {}) {
    const ProcessResult result = runMres(arguments, environment);
    EXPECT_EQ(result.exitCode, exitCode) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, AllOf(StartsWith("mres: "), EndsWith("\n")));
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_TRUE(output_.isEmpty()) << "files were left behind";
    return result.err;
  }
  std::string renderFailure(std::vector<std::string> arguments, int exitCode) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"-o", picture_});
    return failureOf(arguments, exitCode);
  }
  std::string compareFailure(std::vector<std::string> arguments, int exitCode) {
    arguments.insert(arguments.begin(), "compare");
    arguments.insert(arguments.end(), {"-o", output_ / "report"});
    return failureOf(arguments, exitCode);
  }

  TemporaryFolder input_;
  TemporaryFolder output_;
  std::string picture_ = output_ / "picture.png";
};

TEST_F(BadInput, UnknownSceneNamesTheScenes) {
  EXPECT_THAT(renderFailure({"hal"}, 1),
              AllOf(HasSubstr("'hal'"), HasSubstr("hall"), HasSubstr("breakfast")));
}

TEST_F(BadInput, MissingSceneFile) {
  EXPECT_THAT(renderFailure({input_ / "missing.glb"}, 1), HasSubstr("missing.glb"));
}

TEST_F(BadInput, BrokenSceneFiles) {
  writeFile(input_.path() / "text.gltf", "this is no JSON");
  EXPECT_THAT(renderFailure({input_ / "text.gltf"}, 1), HasSubstr("text.gltf"));
  writeFile(input_.path() / "empty.glb", "");
  EXPECT_THAT(compareFailure({input_ / "empty.glb"}, 1), HasSubstr("empty.glb"));
  writeFile(input_.path() / "cut.glb", std::string("glTF\2\0\0\0\xff\xff\0\0", 12));
  EXPECT_THAT(renderFailure({input_ / "cut.glb"}, 1), HasSubstr("cut.glb"));
}

TEST_F(BadInput, ImpossibleSizes) {
  for (const char* size : {"0x0", "16385x1", "1x99999999999", "-4x4", "1920", "big"})
    EXPECT_THAT(renderFailure({"--size", size}, 2), AllOf(HasSubstr(size), HasSubstr("16384x16384")));
}

TEST_F(BadInput, ExportsThatCannotBe) {
  const std::string scene = writeCornerScene(input_);
  EXPECT_THAT(failureOf({"export", scene, "-o", output_ / "copy.obj"}, 2), HasSubstr(".glb"));
  EXPECT_THAT(failureOf({"export", scene, "--camera", "2", "-o", output_ / "copy.glb"}, 1),
              HasSubstr("0 to 1"));
  EXPECT_THAT(failureOf({"export", "hal", "-o", output_ / "copy.glb"}, 1), HasSubstr("'hal'"));
}

TEST_F(BadInput, CameraOutOfRangeTellsTheRange) {
  const std::string scene = writeCornerScene(input_);
  EXPECT_THAT(renderFailure({scene, "--camera", "2"}, 1), HasSubstr("0 to 1"));
  EXPECT_THAT(renderFailure({scene, "--camera", "first"}, 2), HasSubstr("'first'"));
  EXPECT_THAT(renderFailure({scene, "--camera", "all"}, 2), HasSubstr("one camera"));
}

TEST_F(BadInput, UnknownNamesSuggestNearOnes) {
  EXPECT_THAT(failureOf({"compar", "hall"}, 2), HasSubstr("no command 'compar'; did you mean compare?"));
  EXPECT_THAT(failureOf({"hall"}, 2),
              HasSubstr("no command 'hall'; use one of info, render, compare, bench"));
  EXPECT_THAT(compareFailure({"--effect", "sao"}, 2), HasSubstr("did you mean ssao?"));
  EXPECT_THAT(compareFailure({"--technique", "mre"}, 2),
              HasSubstr("did you mean mres or mres-paper or mres-min-max?"));
  EXPECT_THAT(compareFailure({"--technique", "half-joined"}, 2), HasSubstr("did you mean half-joint?"));
  EXPECT_THAT(
      compareFailure({"--technique", "third"}, 2),
      AllOf(HasSubstr("no technique 'third'; use one of full, mres-paper, mres-min-max, mres, half-bilinear"),
            HasSubstr("interleaved, adaptive-tiles.")));
  EXPECT_THAT(compareFailure({"--set", "radios=1"}, 2), HasSubstr("did you mean radius?"));
  EXPECT_THAT(failureOf({"bench", "--suite", "quik", "-o", output_ / "bench"}, 2),
              HasSubstr("did you mean quick?"));
}

TEST_F(BadInput, EffectsThatCannotBeCompared) {
  EXPECT_THAT(compareFailure({"--effect", "ssr"}, 2), HasSubstr("no effect 'ssr'"));
  EXPECT_THAT(compareFailure({"--effect", "none"}, 2), HasSubstr("nothing to compare"));
}

TEST_F(BadInput, SettingsOutOfRangeTellTheRange) {
  EXPECT_THAT(compareFailure({"--samples", "257"}, 2), HasSubstr("1 to 256"));
  EXPECT_THAT(compareFailure({"--samples", "many"}, 2), HasSubstr("'many'"));
  EXPECT_THAT(compareFailure({"--set", "radius=-1"}, 2), HasSubstr("radius"));
  EXPECT_THAT(compareFailure({"--set", "radius"}, 2), HasSubstr("key=value"));
  EXPECT_THAT(compareFailure({"--repeat", "0"}, 2), HasSubstr("1 to 10000"));
}

TEST_F(BadInput, PathsOfTooFewOrTooManyFrames) {
  for (const char* frames : {"0", "1", "-8", "99999999999", "2.5", "many"})
    EXPECT_THAT(compareFailure({"--frames", frames}, 2),
                AllOf(HasSubstr(fmt::format("'{}'", frames)), HasSubstr("2 to 100")));
  EXPECT_THAT(renderFailure({"--frames", "8"}, 2), HasSubstr("--frames"));
}

TEST_F(BadInput, WrongUsage) {
  EXPECT_THAT(failureOf({"frobnicate"}, 2), HasSubstr("frobnicate"));
  EXPECT_THAT(failureOf({"render", "hall"}, 2), HasSubstr("--output"));
  EXPECT_THAT(failureOf({"info", "--frob"}, 2), HasSubstr("--frob"));
  EXPECT_THAT(compareFailure({"--repeat", "3", "--no-timing"}, 2), HasSubstr("--no-timing"));
}

TEST_F(BadInput, OutputsThatCannotBeWrittenAreFoundBeforeTheWork) {
  const std::string missing = input_ / "missing.glb";  // never looked at
  EXPECT_THAT(failureOf({"render", missing, "-o", output_ / "no/such/folder/a.png"}, 1), HasSubstr("a.png"));
  EXPECT_THAT(failureOf({"render", missing, "-o", output_ / "a.gif"}, 2), HasSubstr(".png or .exr"));
  EXPECT_THAT(failureOf({"render", missing, "-o", ""}, 2), HasSubstr(".png or .exr"));
  EXPECT_THAT(failureOf({"compare", missing, "-o", "/proc/mres"}, 1), HasSubstr("/proc/mres"));
  EXPECT_THAT(failureOf({"compare", missing, "-o", ""}, 1), HasSubstr("empty"));
  writeFile(input_.path() / "file", "");
  EXPECT_THAT(failureOf({"compare", missing, "-o", input_ / "file"}, 1), HasSubstr("file"));
  EXPECT_THAT(failureOf({"bench", "-o", input_ / "file/below"}, 1), HasSubstr("below"));
  EXPECT_THAT(failureOf({"bench", "-o", ""}, 1), HasSubstr("empty"));
}

TEST_F(BadInput, NoOpenGlDevice) {
  for (const char* nothing :
       {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json", "LIBGL_DRIVERS_PATH=/nonexistent"}) {
    EXPECT_THAT(failureOf({"info"}, 1, {nothing}), HasSubstr("OpenGL"));
    EXPECT_THAT(failureOf({"compare", "-o", output_ / "report"}, 1, {nothing}),
                HasSubstr("install a driver"));
  }
}

TEST_F(BadInput, OpenGlTooOld) {
  EXPECT_THAT(failureOf({"render", "-o", picture_}, 1, {"MESA_GL_VERSION_OVERRIDE=3.1"}),
              AllOf(HasSubstr("3.3"), HasSubstr("3.1")));
}

TEST_F(BadInput, AFullStandardOutputIsAnError) {
  for (const std::string arguments : {"--help", "info", "info --json"}) {
    const std::string errors = input_ / "err";
    const std::string command = fmt::format("{} {} > /dev/full 2> {}", MRES_EXECUTABLE, arguments, errors);
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status)) << arguments;
    EXPECT_EQ(WEXITSTATUS(status), 1) << arguments;
    EXPECT_EQ(readFile(errors), "mres: Cannot write to the standard output; is its disk full?\n")
        << arguments;
  }
}

TEST_F(BadInput, AShaderErrorIsOneSentence) {
  writeFile(input_.path() / "effects/ssao.glsl", "vec4 shade(Surface surface) { return }\n");
  EXPECT_THAT(
      renderFailure({writeCornerScene(input_), "--shaders", input_.path().string()}, 1),
      AllOf(HasSubstr("does not compile"), HasSubstr("effects/ssao.glsl:1"), HasSubstr("syntax error")));
  EXPECT_THAT(renderFailure({"--shaders", input_ / "missing"}, 2), HasSubstr("no folder of shaders"));
}

TEST_F(BadInput, ABrokenReportIsNotResumedFrom) {
  for (const char* text :
       {"", "[]", R"({"results":[{}]})", R"({"schema":"1"})", R"({"schema":1,"results":3})"}) {
    writeFile(input_.path() / "results.json", text);
    const ProcessResult result =
        runMres({"bench", "--suite", "smoke", "--resume", "-o", input_.path().string()});
    EXPECT_EQ(result.exitCode, 1) << text;
    EXPECT_THAT(result.err, AllOf(StartsWith("mres: Cannot resume from '"),
                                  EndsWith("leave out --resume to begin anew.\n")));
    EXPECT_EQ(readFile(input_.path() / "results.json"), text);
  }
}

TEST_F(BadInput, WithoutResultsThereIsNothingToReport) {
  EXPECT_THAT(failureOf({"bench", "--report", "-o", output_ / "bench"}, 1),
              AllOf(HasSubstr("there is no such file"), HasSubstr("leave out --report")));
  writeFile(input_.path() / "results.json", "[]");
  EXPECT_THAT(failureOf({"bench", "--report", "-o", input_.path().string()}, 1), HasSubstr("not JSON"));
  EXPECT_THAT(failureOf({"bench", "--report", "--resume"}, 2), HasSubstr("--resume"));
}

TEST_F(BadInput, WithoutAnEffectThereIsNothingToTime) {
  EXPECT_THAT(renderFailure({"--effect", "none", "--repeat", "2"}, 2), HasSubstr("nothing to time"));
}

TEST_F(BadInput, ASecondSceneIsWrongUsage) {
  EXPECT_THAT(renderFailure({"hall", "office"}, 2), HasSubstr("office"));
}

}  // namespace
}  // namespace host::test
