#include "host/measure/temporal_errors.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace host {
namespace {

constexpr glm::ivec2 kSize(24, 16);  // three by two blocks
constexpr std::size_t kPixels = 24 * 16;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

FloatImage gray(float value) {
  return {kSize, 1, std::vector<float>(kPixels, value)};
}

/// Of values that float adds and subtracts without rounding.
FloatImage noise(unsigned seed, int channels = 1) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> uniform(0, 1024);
  FloatImage image{kSize, channels, {}};
  for (std::size_t i = 0; i < kPixels * channels; ++i)
    image.pixels.push_back(static_cast<float>(uniform(random)) / 1024.0f);
  return image;
}

FloatImage brighter(FloatImage image, float offset) {
  for (float& value : image.pixels) value += offset;
  return image;
}

TEST(TemporalErrors, OfTheReferenceItselfAreNoneHoweverMuchItChanges) {
  TemporalErrorSum sum;
  for (unsigned frame = 0; frame < 4; ++frame) sum.add(noise(frame), noise(frame));
  const TemporalErrors errors = sum.result();
  EXPECT_EQ(errors.frames, 4);
  EXPECT_EQ(errors.rms, 0.0);
  EXPECT_EQ(errors.max, 0.0);
  EXPECT_EQ(errors.blockMax, 0.0);
  EXPECT_GT(errors.referenceChange, 0.3);
  EXPECT_EQ(errors.techniqueChange, errors.referenceChange);
}

TEST(TemporalErrors, AnErrorThatStaysIsNoFlicker) {
  TemporalErrorSum sum;
  for (unsigned frame = 0; frame < 4; ++frame) sum.add(brighter(noise(frame), 0.25f), noise(frame));
  EXPECT_EQ(sum.result().rms, 0.0);
  EXPECT_EQ(sum.result().max, 0.0);
}

TEST(TemporalErrors, AnErrorThatBlinksIsFlickerAsItComesAndAsItGoes) {
  for (const float offset : {0.25f, -0.25f}) {
    TemporalErrorSum sum;
    for (const float error : {0.0f, offset, 0.0f}) sum.add(gray(0.5f + error), gray(0.5f));
    const TemporalErrors errors = sum.result();
    EXPECT_EQ(errors.rms, 0.25);
    EXPECT_EQ(errors.max, 0.25);
    EXPECT_EQ(errors.techniqueChange, 0.25);
    EXPECT_EQ(errors.referenceChange, 0.0);
  }
}

TEST(TemporalErrors, HaveTheSignsOfBothChanges) {
  const auto rmsOf = [](float techniqueChange, float referenceChange) {
    TemporalErrorSum sum;
    sum.add(gray(0.5f), gray(0.5f));
    sum.add(gray(0.5f + techniqueChange), gray(0.5f + referenceChange));
    return sum.result().rms;
  };
  EXPECT_EQ(rmsOf(0.25f, 0.125f), 0.125);
  EXPECT_EQ(rmsOf(0.125f, 0.25f), 0.125);
  EXPECT_EQ(rmsOf(0.25f, -0.125f), 0.375);
  EXPECT_EQ(rmsOf(0.0f, 0.25f), 0.25) << "what should change and does not is as wrong";
}

TEST(TemporalErrors, AgreeWithTheDefinitionWrittenPlainly) {
  constexpr int kFrames = 5;
  constexpr int kChannels = 3;
  std::vector<FloatImage> technique;
  std::vector<FloatImage> reference;
  TemporalErrorSum sum;
  for (unsigned frame = 0; frame < kFrames; ++frame) {
    technique.push_back(noise(frame, kChannels));
    reference.push_back(noise(100 + frame, kChannels));
    sum.add(technique.back(), reference.back());
  }
  const auto errorAt = [&](int frame, std::size_t i) {
    return double(technique[frame].pixels[i]) - double(reference[frame].pixels[i]);
  };
  double squares = 0.0;
  double greatest = 0.0;
  for (int frame = 1; frame < kFrames; ++frame)
    for (std::size_t i = 0; i < kPixels * kChannels; ++i) {
      const double change = errorAt(frame, i) - errorAt(frame - 1, i);
      squares += change * change;
      greatest = std::max(greatest, std::abs(change));
    }
  EXPECT_NEAR(sum.result().rms, std::sqrt(squares / (kPixels * kChannels * (kFrames - 1))), 1e-12);
  EXPECT_EQ(sum.result().max, greatest);
}

TEST(TemporalErrors, ABlockThatBlinksOnceIsFoundAmongAllBlocks) {
  TemporalErrorSum sum;
  for (int frame = 0; frame < 21; ++frame) {
    FloatImage technique = gray(0.5f);
    if (frame == 20)
      for (int i = 0; i < 64; ++i) technique.pixels[(8 + i / 8) * kSize.x + 16 + i % 8] = 0.75f;
    sum.add(technique, gray(0.5f));
  }
  const TemporalErrors errors = sum.result();
  EXPECT_EQ(errors.blockMax, 0.25);
  EXPECT_EQ(errors.blockPercentile99, 0.0) << "one of 120";
  EXPECT_NEAR(errors.rms, 0.25 / std::sqrt(120.0), 1e-12);
}

TEST(TemporalErrors, OneBlockOfSixIsMoreThanOneInAHundred) {
  FloatImage technique = gray(0.5f);
  for (int i = 0; i < 64; ++i) technique.pixels[i / 8 * kSize.x + i % 8] = 0.75f;
  TemporalErrorSum sum;
  sum.add(gray(0.5f), gray(0.5f));
  sum.add(technique, gray(0.5f));
  EXPECT_EQ(sum.result().blockPercentile99, 0.25);
}

TEST(TemporalErrors, WhatIsNotFiniteCountsAsOneAsItComesAndAsItGoes) {
  for (const float broken : {kNaN, kInfinity, -kInfinity}) {
    for (const bool inBoth : {false, true}) {
      FloatImage frame = gray(0.5f);
      frame.pixels[30] = broken;
      TemporalErrorSum sum;
      sum.add(gray(0.5f), gray(0.5f));
      sum.add(frame, inBoth ? frame : gray(0.5f));
      sum.add(gray(0.5f), gray(0.5f));
      const TemporalErrors errors = sum.result();
      EXPECT_EQ(errors.nonFinite, 2);
      EXPECT_EQ(errors.max, 1.0);
      EXPECT_NEAR(errors.rms, std::sqrt(1.0 / kPixels), 1e-12);
      EXPECT_NEAR(errors.blockMax, std::sqrt(1.0 / 64.0), 1e-12);
      EXPECT_NEAR(errors.techniqueChange, std::sqrt(1.0 / kPixels), 1e-12);
    }
  }
}

TEST(TemporalErrors, NeedTwoFramesOfOneShape) {
  TemporalErrorSum sum;
  EXPECT_THROW((void)sum.result(), std::invalid_argument);
  sum.add(gray(0.5f), gray(0.5f));
  EXPECT_THROW((void)sum.result(), std::invalid_argument);
  EXPECT_THROW(sum.add(noise(1, 3), noise(1, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace host
