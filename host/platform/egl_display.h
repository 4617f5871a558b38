// The EGL displays that need no window system, in the order in which they are worth trying.
#pragma once

#include <epoxy/egl.h>
#include <string>
#include <vector>

namespace host::egl {

struct Display {
  EGLDisplay handle = EGL_NO_DISPLAY;  ///< not yet initialised
  std::string platform;                ///< for users, e.g. "EGL surfaceless"
};

/// Empty where this EGL knows neither platform.
std::vector<Display> headlessDisplays();

/// Name of an eglGetError() value, for messages.
std::string errorName(EGLint error);

}  // namespace host::egl
