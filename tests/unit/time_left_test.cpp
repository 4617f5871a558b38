#include "host/bench/time_left.h"

#include <gtest/gtest.h>

namespace host {
namespace {

using Seconds = TimeLeft::Seconds;

TEST(TimeLeft, IsUnknownAtTheBeginning) {
  EXPECT_FALSE(TimeLeft().at(0.0, Seconds(10.0)));
}

TEST(TimeLeft, FollowsFromTheShareDone) {
  EXPECT_DOUBLE_EQ(TimeLeft().at(0.25, Seconds(60.0))->count(), 180.0);
  EXPECT_DOUBLE_EQ(TimeLeft().at(1.0, Seconds(60.0))->count(), 0.0);
}

TEST(TimeLeft, DoesNotCountWhatWasSkipped) {
  TimeLeft left;
  left.skip(0.5);
  EXPECT_FALSE(left.at(0.5, Seconds(1.0)));
  EXPECT_DOUBLE_EQ(left.at(0.75, Seconds(60.0))->count(), 60.0);
}

TEST(TimeLeft, ReadsAsMinutesOrHours) {
  EXPECT_EQ(describe(Seconds(0.2)), "0:00 min left");
  EXPECT_EQ(describe(Seconds(247.0)), "4:07 min left");
  EXPECT_EQ(describe(Seconds(3599.7)), "1:00 h left");
  EXPECT_EQ(describe(Seconds(5690.0)), "1:35 h left");
  EXPECT_EQ(describe(Seconds(36000.0)), "10:00 h left");
}

}  // namespace
}  // namespace host
