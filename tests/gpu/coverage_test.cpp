// Coverage is each effect's own, and known in the end also where the driver takes its time.
#include <map>
#include <vector>

#include "mres/mres.h"
#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

/// While it lives, results of queries are there three frames after the query has begun, not earlier.
class SlowQueries {
 public:
  SlowQueries() {
    GLuint result = 0;  // libepoxy looks up functions on first use
    const gl::QueryName query = gl::QueryName::create();
    glBeginQuery(GL_SAMPLES_PASSED, query.id());
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(query.id(), GL_QUERY_RESULT, &result);
    driversBegin = glBeginQuery;
    driversGet = glGetQueryObjectuiv;
    glBeginQuery = begin;
    glGetQueryObjectuiv = get;
  }
  ~SlowQueries() {
    glBeginQuery = driversBegin;
    glGetQueryObjectuiv = driversGet;
  }
  SlowQueries(const SlowQueries&) = delete;
  SlowQueries& operator=(const SlowQueries&) = delete;
  SlowQueries(SlowQueries&&) = delete;
  SlowQueries& operator=(SlowQueries&&) = delete;

  static void nextFrame() { ++frame; }

 private:
  static void begin(GLenum target, GLuint query) {
    begun[query] = frame;
    driversBegin(target, query);
  }
  static void get(GLuint query, GLenum parameter, GLuint* value) {
    glFinish();
    driversGet(query, parameter, value);
    if (parameter == GL_QUERY_RESULT_AVAILABLE && frame < begun[query] + 3) *value = GL_FALSE;
  }

  static inline decltype(glBeginQuery) driversBegin = nullptr;
  static inline decltype(glGetQueryObjectuiv) driversGet = nullptr;
  static inline std::map<GLuint, int> begun;
  static inline int frame = 0;
};

class Coverage : public GlTest {
 protected:
  Coverage() : gbuffer_(kSize, perspective(kSize), room()) {}

  static std::vector<double> coverageOf(const MultiResolution& multiResolution) {
    std::vector<double> coverage;
    for (const LevelReport& level : multiResolution.report().levels) coverage.push_back(level.coverage);
    return coverage;
  }

  /// Coverage of an effect that is rendered alone.
  std::vector<double> measured(Effect& effect) {
    MultiResolution multiResolution({.measureCoverage = true});
    refineByMasks(multiResolution);
    multiResolution.render(effect, gbuffer_.frame());
    glFinish();
    multiResolution.render(effect, gbuffer_.frame());
    return coverageOf(multiResolution);
  }

  static constexpr glm::ivec2 kSize{193, 129};
  SyntheticGBuffer gbuffer_;
};

TestEffect effectOf(const std::string& name, float variance) {
  LevelTable levels = kSsaoLevels;
  for (LevelSettings& level : levels) level.maskVariance = variance;
  return TestEffect({.body = "return vec4(surface.depth * 0.1);", .levels = levels, .name = name});
}

TEST_F(Coverage, IsEachEffectsOwn) {
  TestEffect narrow = effectOf("narrow", 0.0f);
  TestEffect wide = effectOf("wide", 30.0f);
  const std::vector<double> narrowAlone = measured(narrow);
  const std::vector<double> wideAlone = measured(wide);
  ASSERT_LT(narrowAlone[2], wideAlone[2]);
  MultiResolution multiResolution({.measureCoverage = true});
  refineByMasks(multiResolution);
  const SlowQueries driver;
  for (int frame = 0; frame < 8; ++frame) {
    multiResolution.render(narrow, gbuffer_.frame());
    multiResolution.render(wide, gbuffer_.frame());
    SlowQueries::nextFrame();
  }
  EXPECT_EQ(coverageOf(multiResolution), wideAlone);
  multiResolution.render(narrow, gbuffer_.frame());
  EXPECT_EQ(coverageOf(multiResolution), narrowAlone);
}

TEST_F(Coverage, IsKnownInTheEndWhereResultsTakeSeveralFrames) {
  TestEffect effect = effectOf("test", 1.0f);
  const std::vector<double> expected = measured(effect);
  MultiResolution multiResolution({.measureCoverage = true});
  refineByMasks(multiResolution);
  const SlowQueries driver;
  for (int frame = 0; frame < 8; ++frame) {
    multiResolution.render(effect, gbuffer_.frame());
    SlowQueries::nextFrame();
  }
  EXPECT_EQ(coverageOf(multiResolution), expected);
}

TEST_F(Coverage, OfAResultThatComesLateIsThatOfItsOwnSize) {
  TestEffect effect = effectOf("test", 1.0f);
  const std::vector<double> expected = measured(effect);
  const glm::ivec2 otherSize(96, 72);
  const SyntheticGBuffer other(otherSize, perspective(otherSize), room());
  MultiResolution multiResolution({.measureCoverage = true});
  refineByMasks(multiResolution);
  const SlowQueries driver;
  multiResolution.render(effect, gbuffer_.frame());
  SlowQueries::nextFrame();
  multiResolution.render(effect, other.frame());
  SlowQueries::nextFrame();
  SlowQueries::nextFrame();
  multiResolution.render(effect, other.frame());
  EXPECT_EQ(coverageOf(multiResolution), expected);
}

}  // namespace
}  // namespace mres::test
