// Stage times are of the mode that is on, whatever was on before.
#include "mres/gl/profiler.h"

#include <gmock/gmock.h>

#include "tests/support/gl_test.h"

namespace mres::gl {
namespace {

using testing::Each;
using testing::Field;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Profiler::Mode kModes[] = {Profiler::Mode::off, Profiler::Mode::query, Profiler::Mode::finish};
constexpr int kEnoughFrames = 6;  // for the results of queries to be read

class ProfilerTest : public test::GlTest {
 protected:
  static void runFrame(Profiler& profiler, const char* scopeName) {
    profiler.beginFrame();
    {
      const Scope outer(profiler, scopeName);
      const Scope inner(profiler, scopeName);
    }
    profiler.endFrame();
    glFinish();
  }

  static void expectStages(const Profiler& profiler, Profiler::Mode mode, const char* name) {
    if (mode == Profiler::Mode::off) {
      EXPECT_THAT(profiler.stages(), IsEmpty());
    } else {
      EXPECT_THAT(profiler.stages(), SizeIs(2));
      EXPECT_THAT(profiler.stages(), Each(Field(&StageTime::name, name)));
      EXPECT_THAT(profiler.stages(), Each(Field(&StageTime::milliseconds, testing::Ge(0.0))));
    }
  }
};

TEST_F(ProfilerTest, ChangesOfModeLeaveNoOldTimes) {
  for (const Profiler::Mode from : kModes) {
    for (const Profiler::Mode to : kModes) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(from) << " to " << static_cast<int>(to));
      Profiler profiler(from);
      for (int frame = 0; frame < kEnoughFrames; ++frame) runFrame(profiler, "before");
      expectStages(profiler, from, "before");
      if (from == to) continue;
      profiler.setMode(to);
      for (int frame = 0; frame < kEnoughFrames; ++frame) {
        runFrame(profiler, "after");
        EXPECT_THAT(profiler.stages(), Each(Field(&StageTime::name, "after"))) << frame;
      }
      expectStages(profiler, to, "after");
    }
  }
}

TEST_F(ProfilerTest, QueriesOfAnEarlierTimeAreForgotten) {
  Profiler profiler(Profiler::Mode::query);
  for (int frame = 0; frame < kEnoughFrames; ++frame) runFrame(profiler, "before");
  profiler.setMode(Profiler::Mode::off);
  runFrame(profiler, "off");
  profiler.setMode(Profiler::Mode::query);
  for (int frame = 0; frame < kEnoughFrames; ++frame) {
    runFrame(profiler, "after");
    EXPECT_THAT(profiler.stages(), Each(Field(&StageTime::name, "after"))) << frame;
  }
}

}  // namespace
}  // namespace mres::gl
