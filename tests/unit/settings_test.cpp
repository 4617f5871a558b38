#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/parse.h"
#include "host/console/settings_table.h"
#include "host/console/usage_error.h"

namespace host {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

struct Example {
  float radius = 0.4f;
  int samples = 64;
  bool filter = true;
};

template <class Visitor>
void visit(Example& settings, Visitor&& visitor) {
  visitor("radius", settings.radius, mres::SettingInfo{"metres", 0.001, 10.0, "Reach of the occlusion."});
  visitor("samples", settings.samples, mres::SettingInfo{"", 1.0, 256.0, "Taps a pixel."});
  visitor("filter", settings.filter, mres::SettingInfo{"", 0.0, 1.0, "Remove the noise."});
}

class Settings : public testing::Test {
 protected:
  Settings() { table_.add(example_); }

  std::string messageOf(const std::string& assignment) {
    try {
      table_.set(parseAssignment(assignment));
    } catch (const UsageError& error) {
      return error.what();
    }
    return "no error";
  }

  Example example_;
  SettingsTable table_;
};

TEST_F(Settings, AreSetByName) {
  table_.set(parseAssignment("radius=1.25"));
  table_.set(parseAssignment("samples=16"));
  table_.set(parseAssignment("filter=off"));
  EXPECT_EQ(example_.radius, 1.25f);
  EXPECT_EQ(example_.samples, 16);
  EXPECT_FALSE(example_.filter);
}

TEST_F(Settings, TheEndsOfTheRangeAreInside) {
  EXPECT_EQ(messageOf("samples=1"), "no error");
  EXPECT_EQ(messageOf("samples=256"), "no error");
}

TEST_F(Settings, ValuesOutsideOfTheRangeNameTheRange) {
  EXPECT_THAT(messageOf("samples=257"),
              AllOf(HasSubstr("'257'"), HasSubstr("samples"), HasSubstr("1 to 256")));
  EXPECT_THAT(messageOf("radius=0"), HasSubstr("0.001 to 10 metres"));
  EXPECT_EQ(example_.samples, 64);
}

TEST_F(Settings, OnlyWholeFiniteNumbersAreNumbers) {
  for (const char* assignment :
       {"samples=1.5", "samples=many", "radius=nan", "radius=inf", "radius=1m", "samples=64 "})
    EXPECT_THAT(messageOf(assignment), HasSubstr("is no value")) << assignment;
}

TEST_F(Settings, AnUnknownNameListsTheNearOnes) {
  EXPECT_THAT(messageOf("radios=1"), HasSubstr("did you mean radius?"));
  EXPECT_THAT(messageOf("colour=1"), HasSubstr("use one of radius, samples, filter."));
}

TEST_F(Settings, OfSeveralStructsOfOneKindAreToldApartByAPrefix) {
  Example second;
  table_.add(second, "second.");
  table_.set(parseAssignment("second.samples=3"));
  EXPECT_EQ(second.samples, 3);
  EXPECT_EQ(example_.samples, 64);
}

TEST_F(Settings, AssignmentsNeedBothSides) {
  for (const char* text : {"radius", "=1", "radius=", ""})
    EXPECT_THROW(parseAssignment(text), UsageError) << text;
}

TEST_F(Settings, ValuesReadAsTheyWereWritten) {
  EXPECT_EQ(table_.values().dump(), R"({"radius":0.4,"samples":64,"filter":true})");
}

TEST_F(Settings, AreDescribedWithDefaultRangeUnitAndMeaning) {
  EXPECT_THAT(table_.describe(), AllOf(HasSubstr("radius=0.4"), HasSubstr("0.001 to 10 metres"),
                                       HasSubstr("Reach of the occlusion.")));
}

TEST(ParseSize, ReadsPixelsAndUsualNames) {
  EXPECT_EQ(parseSize("1x1"), glm::ivec2(1, 1));
  EXPECT_EQ(parseSize("16384x16384"), glm::ivec2(16384, 16384));
  EXPECT_EQ(parseSize("4k"), glm::ivec2(3840, 2160));
}

TEST(ParseSize, RejectsEverythingElse) {
  for (const char* text : {"0x0", "0x5", "16385x1", "-1x5", "1920", "1920x", "x1080", "1920x1080x3",
                           "1920 x 1080", "axb", "", "99999999999x1", "1.5x2", "+3x3"})
    EXPECT_THROW(parseSize(text), UsageError) << text;
}

TEST(ParseCamera, ReadsANumberOrAll) {
  EXPECT_EQ(parseCamera("7"), 7);
  EXPECT_EQ(parseCamera("all"), std::nullopt);
  for (const char* text : {"-1", "first", "", "1.0"}) EXPECT_THROW(parseCamera(text), UsageError) << text;
}

TEST(ClosestNames, AreNearestFirstAndNeverFar) {
  const std::vector<std::string> names{"hall", "office", "breakfast"};
  EXPECT_THAT(closestNames("hal", names), ElementsAre("hall"));
  EXPECT_THAT(closestNames("break", names), ElementsAre("breakfast"));
  EXPECT_THAT(closestNames("kitchen", names), testing::IsEmpty());
}

}  // namespace
}  // namespace host
