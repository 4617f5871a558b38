#include "host/console/output.h"

#include <climits>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

#include "gltf_test_file.h"

namespace host {
namespace {

namespace fs = std::filesystem;
using gltf_test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string failureOf(const fs::path& path) {
  try {
    const OutputDirectory directory(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(OutputDirectory, IsTakenAwayAgainWhereItStaysEmpty) {
  const TemporaryFolder folder;
  {
    const OutputDirectory kept(folder.path() / "kept/");
    writeTextFile(kept.path() / "report.json", "{}");
    const OutputDirectory left(folder.path() / "kept/left/empty");
    EXPECT_TRUE(fs::is_directory(left.path()));
  }
  EXPECT_TRUE(fs::exists(folder.path() / "kept/report.json"));
  EXPECT_FALSE(fs::exists(folder.path() / "kept/left"));
}

TEST(OutputDirectory, ANameThatIsTooLongIsOneSentence) {
  const TemporaryFolder folder;
  EXPECT_THAT(failureOf(folder.path() / "made" / std::string(NAME_MAX + 1, 'x')),
              AllOf(HasSubstr("Cannot write '"), HasSubstr("too long; choose another place"),
                    Not(HasSubstr("filesystem error"))));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

/// A folder that can be made, in which no file can.
TEST(OutputDirectory, AFailureAfterFoldersWereMadeTakesThemAway) {
  const TemporaryFolder folder;
  fs::path deep = folder.path();
  while (deep.native().size() < PATH_MAX - 110) deep /= std::string(100, 'd');
  deep /= std::string(PATH_MAX - 5 - deep.native().size(), 'e');
  EXPECT_THAT(failureOf(deep), HasSubstr("too long; choose another place"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(RequireWritableFile, ANameThatIsTooLongIsOneSentence) {
  const TemporaryFolder folder;
  try {
    requireWritableFile(folder.path() / (std::string(NAME_MAX, 'x') + ".png"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("too long"), Not(HasSubstr("filesystem error"))));
  }
}

}  // namespace
}  // namespace host
