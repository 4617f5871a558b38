#include <cstdio>
#include <cstdlib>
#include <epoxy/gl.h>
#include <exception>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

#include "host/platform/gl_context.h"

namespace host {
namespace {

/// Runs `body` with no context of another test current.
template <class Body>
void onFreshThread(Body body) {
  std::thread(body).join();
}

constexpr int kNotMesa = 77;

/// Makes a context as the executable would: its sentence goes to stderr, and the exit code is 1.
[[noreturn]] void makeContextAndExit() {
  try {
    const GlContext context;
    std::exit(context.info().version.find("Mesa") == std::string::npos ? kNotMesa : 0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::exit(1);
  }
}

/// Death tests run in a new process, so that EGL reads the environment afresh.
class GlContextDeathTest : public testing::Test {
 protected:
  GlContextDeathTest() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

TEST(GlContextTest, IsAnOpenGl33CoreContext) {
  onFreshThread([] {
    const GlContext context;
    EXPECT_GE(epoxy_gl_version(), 33);
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_TRUE((profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0);
    EXPECT_THAT(context.info().platform, testing::AnyOf("EGL surfaceless", "EGL device"));
    EXPECT_THAT(context.info().version, testing::Not(testing::IsEmpty()));
    EXPECT_THAT(context.info().vendor, testing::Not(testing::IsEmpty()));
    EXPECT_EQ(context.info().software, context.info().renderer.find("llvmpipe") != std::string::npos);
  });
}

TEST(GlContextTest, OutlivesAnotherContextOfTheSameDisplay) {
  onFreshThread([] {
    const GlContext kept;
    onFreshThread([] { const GlContext shortLived; });
    GLint units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    EXPECT_GE(units, 16);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  });
}

TEST(GlContextTest, KeepsErrorMessagesOnlyWhenDebugging) {
  onFreshThread([] {
    GlContext context(GlContext::Debug::on);
    if (epoxy_gl_version() < 43 && !epoxy_has_gl_extension("GL_KHR_debug")) GTEST_SKIP() << "no GL_KHR_debug";
    EXPECT_THAT(context.takeErrors(), testing::IsEmpty());
    glEnable(GL_TEXTURE_BINDING_2D);  // a name, but none that can be enabled
    EXPECT_THAT(context.takeErrors(), testing::SizeIs(1));
    EXPECT_THAT(context.takeErrors(), testing::IsEmpty());
  });
  onFreshThread([] {
    GlContext context;
    glEnable(GL_TEXTURE_BINDING_2D);
    EXPECT_THAT(context.takeErrors(), testing::IsEmpty());
  });
}

TEST_F(GlContextDeathTest, SaysThatTheVersionIsTooLow) {
  const auto exits = [](int status) {  // only Mesa can pretend to be older
    return testing::ExitedWithCode(1)(status) || testing::ExitedWithCode(kNotMesa)(status);
  };
  EXPECT_EXIT(
      {
        setenv("MESA_GL_VERSION_OVERRIDE", "3.1", 1);
        makeContextAndExit();
      },
      exits, "^$|No OpenGL device.*no OpenGL 3.3 core context but only 3.1.*install a driver");
}

TEST_F(GlContextDeathTest, SaysThatThereIsNoDevice) {
  EXPECT_EXIT(
      {
        setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);  // libglvnd finds no driver
        makeContextAndExit();
      },
      testing::ExitedWithCode(1), "No OpenGL device.*install a driver");
}

}  // namespace
}  // namespace host
