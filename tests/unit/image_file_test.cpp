#include "host/image/image_file.h"

#include <cmath>
#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <sys/resource.h>

#include "gltf_test_file.h"

namespace {

using gltf_test::TemporaryFolder;
using testing::HasSubstr;

host::FloatImage gradient(glm::ivec2 size, int channels, float scale) {
  host::FloatImage image{size, channels, {}};
  const std::size_t count = std::size_t(size.x) * std::size_t(size.y) * std::size_t(channels);
  for (std::size_t i = 0; i < count; ++i) image.pixels.push_back(scale * float(i) / float(count));
  return image;
}

std::string writeError(const std::filesystem::path& path, const host::FloatImage& image) {
  try {
    host::writeImage(path, image);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::size_t filesIn(const std::filesystem::path& folder) {
  return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {}));
}

void expectNear(const host::FloatImage& actual, const host::FloatImage& expected, float relative,
                float absolute) {
  ASSERT_EQ(actual.size, expected.size);
  ASSERT_EQ(actual.channels, expected.channels);
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    EXPECT_NEAR(actual.pixels[i], expected.pixels[i], absolute + relative * std::abs(expected.pixels[i]))
        << i;
  }
}

TEST(ImageFile, PngKeepsEightBits) {
  const TemporaryFolder folder;
  for (const int channels : {1, 3, 4}) {
    const host::FloatImage image = gradient({13, 7}, channels, 1.0f);
    host::writeImage(folder.path() / "a.png", image);
    expectNear(host::readImage(folder.path() / "a.png"), image, 0.0f, 0.5f / 255.0f + 1e-6f);
  }
}

TEST(ImageFile, ExrKeepsHalfFloats) {
  const TemporaryFolder folder;
  for (const int channels : {1, 3, 4}) {
    const host::FloatImage image = gradient({5, 11}, channels, 1000.0f);
    host::writeImage(folder.path() / "a.exr", image);
    expectNear(host::readImage(folder.path() / "a.exr"), image, 1.0f / 2048.0f, 1e-6f);
  }
}

TEST(ImageFile, PngClampsAndNanIsBlack) {
  const TemporaryFolder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  host::writeImage(folder.path() / "a.png", {{4, 1}, 1, {-1.0f, 2.0f, nan, 0.2f}});
  const auto pixels = host::readImage(folder.path() / "a.png").pixels;
  EXPECT_THAT(pixels, testing::ElementsAre(0.0f, 1.0f, 0.0f, testing::FloatNear(0.2f, 1e-6f)));
}

TEST(ImageFile, ColoursUnderZeroAlphaAreKept) {
  const TemporaryFolder folder;
  host::writeImage(folder.path() / "a.png", {{1, 1}, 4, {1.0f, 0.2f, 0.4f, 0.0f}});
  EXPECT_FLOAT_EQ(host::readImage(folder.path() / "a.png").pixels[0], 1.0f);
}

TEST(ImageFile, WritingReplacesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  host::writeImage(folder.path() / "a.png", gradient({3, 3}, 3, 1.0f));
  host::writeImage(folder.path() / "a.png", gradient({4, 2}, 3, 1.0f));
  EXPECT_EQ(host::readImage(folder.path() / "a.png").size, glm::ivec2(4, 2));
  EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(ImageFile, FailuresAreOneSentenceAndLeaveNoFile) {
  const TemporaryFolder folder;
  const host::FloatImage image = gradient({3, 3}, 3, 1.0f);
  EXPECT_THAT(writeError(folder.path() / "a.gif", image), HasSubstr("must end in .png or .exr"));
  EXPECT_THAT(writeError(folder.path() / "nowhere" / "a.png", image), HasSubstr("does not exist; create it"));
  EXPECT_THAT(writeError(folder.path() / "a.png", {{3, 3}, 2, image.pixels}), HasSubstr("no picture"));
  EXPECT_EQ(filesIn(folder.path()), 0U);
  std::filesystem::create_directory(folder.path() / "b.png");
  EXPECT_THAT(writeError(folder.path() / "b.png", image), HasSubstr("it is a folder"));
  EXPECT_EQ(filesIn(folder.path()), 1U);
}

/// libpng's own limit on widths: the encoder fails when it is half set up.
TEST(ImageFile, WhatTheEncoderRefusesIsOneSentence) {
  const TemporaryFolder folder;
  EXPECT_THAT(writeError(folder.path() / "a.png", gradient({1'000'001, 1}, 1, 1.0f)),
              HasSubstr("can't write '"));
  EXPECT_EQ(filesIn(folder.path()), 0U);
}

/// Makes every file end after `bytes`, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limit{bytes, previous_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    previousHandler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &previous_);
    std::signal(SIGXFSZ, previousHandler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  FileSizeLimit(FileSizeLimit&&) = delete;
  FileSizeLimit& operator=(FileSizeLimit&&) = delete;

 private:
  rlimit previous_{};
  void (*previousHandler_)(int) = nullptr;
};

TEST(ImageFile, AFullDiskKeepsTheOldPicture) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.exr"}) {
    const auto path = folder.path() / name;
    host::writeImage(path, gradient({2, 2}, 3, 1.0f));
    host::FloatImage noise = gradient({256, 256}, 3, 1.0f);
    std::minstd_rand random;  // incompressible
    for (float& value : noise.pixels) value = float(random() % 1000U) / 999.0f;
    {
      const FileSizeLimit limit(4096);
      EXPECT_THAT(writeError(path, noise), HasSubstr("can't write '")) << name;
    }
    EXPECT_EQ(host::readImage(path).size, glm::ivec2(2, 2)) << name;
  }
  EXPECT_EQ(filesIn(folder.path()), 2U);
}

TEST(ImageFile, UnreadableImagesAreNamed) {
  EXPECT_THROW(host::readImage("nowhere.png"), std::runtime_error);
  const TemporaryFolder folder;
  folder.write("a.png", "no image");
  EXPECT_THROW(host::readImage(folder.path() / "a.png"), std::runtime_error);
}

TEST(EncodeSrgb, FollowsTheStandardAndLeavesAlpha) {
  const host::FloatImage encoded =
      host::encodeSrgb({{1, 2}, 4, {0.0f, 0.0031308f, 0.5f, 0.5f, 1.0f, 0.2140411f, 0.0f, 0.25f}});
  const float expected[] = {0.0f, 0.04045f, 0.7353570f, 0.5f, 1.0f, 0.5f, 0.0f, 0.25f};
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(encoded.pixels[std::size_t(i)], expected[i], 1e-5f) << i;
}

}  // namespace
