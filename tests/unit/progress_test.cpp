#include "host/console/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace host {
namespace {

using std::chrono::milliseconds;
using testing::EndsWith;
using testing::HasSubstr;

class Progress : public testing::Test {
 protected:
  ProgressBar bar(int columns) {
    return {out_, columns, [this] { return now_; }};
  }

  std::ostringstream out_;
  ProgressBar::Clock::time_point now_;
};

TEST_F(Progress, IsSilentForTheFirstSecond) {
  ProgressBar progress = bar(80);
  now_ += milliseconds(999);
  progress.update(0.5, "timing");
  EXPECT_EQ(out_.str(), "");
}

TEST_F(Progress, ShowsShareAndWork) {
  ProgressBar progress = bar(80);
  now_ += milliseconds(1000);
  progress.update(0.5, "timing pair 3 of 31");
  EXPECT_THAT(out_.str(), HasSubstr("[############............]  50 % timing pair 3 of 31"));
}

TEST_F(Progress, StaysWithinItsEnds) {
  ProgressBar progress = bar(80);
  now_ += milliseconds(2000);
  progress.update(1.7, "");
  EXPECT_THAT(out_.str(), HasSubstr("[########################] 100 %"));
  progress.update(-1.0, "");
  EXPECT_THAT(out_.str(), HasSubstr("[........................]   0 %"));
}

TEST_F(Progress, WritesNothingWhereThereIsNoTerminal) {
  {
    ProgressBar progress = bar(0);
    now_ += milliseconds(5000);
    progress.update(0.5, "timing");
  }
  EXPECT_EQ(out_.str(), "");
}

TEST_F(Progress, NeverWraps) {
  ProgressBar progress = bar(40);
  now_ += milliseconds(2000);
  progress.update(0.5, "hall 0 1920x1080 64 samples: timed pair 3 of at most 31");
  EXPECT_THAT(out_.str(), EndsWith("\033[K[############............]  50 % hall 0"));
}

TEST_F(Progress, TakesItsLineAwayAtTheEnd) {
  {
    ProgressBar progress = bar(80);
    now_ += milliseconds(1500);
    progress.update(0.5, "timing");
    out_.str("");
  }
  EXPECT_THAT(out_.str(), EndsWith("\033[K"));
}

TEST_F(Progress, AnUndrawnLineNeedsNoClearing) {
  { const ProgressBar progress = bar(80); }
  EXPECT_EQ(out_.str(), "");
}

}  // namespace
}  // namespace host
