#include "host/platform/egl_display.h"

#include <array>
#include <fmt/format.h>
#include <utility>

namespace host::egl {
namespace {

bool clientHas(const char* extension) {
  return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension);
}

void addSurfaceless(std::vector<Display>& displays) {
  if (!clientHas("EGL_MESA_platform_surfaceless")) return;
  EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display != EGL_NO_DISPLAY) displays.push_back({display, "EGL surfaceless"});
}

std::vector<EGLDeviceEXT> devices() {
  EGLint count = 0;
  if (eglQueryDevicesEXT(0, nullptr, &count) == EGL_FALSE) return {};
  std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
  if (eglQueryDevicesEXT(count, found.data(), &count) == EGL_FALSE) return {};
  found.resize(static_cast<std::size_t>(count));
  return found;
}

void addDevices(std::vector<Display>& displays) {
  const bool enumerates = clientHas("EGL_EXT_device_enumeration") || clientHas("EGL_EXT_device_base");
  if (!enumerates || !clientHas("EGL_EXT_platform_device")) return;
  for (EGLDeviceEXT device : devices()) {
    EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (display != EGL_NO_DISPLAY) displays.push_back({display, "EGL device"});
  }
}

}  // namespace

std::vector<Display> headlessDisplays() {
  std::vector<Display> displays;
  // Both ways of making a display without a window system need this one.
  if (!clientHas("EGL_EXT_platform_base")) return displays;
  addSurfaceless(displays);
  addDevices(displays);
  return displays;
}

std::string errorName(EGLint error) {
  static constexpr auto kNames = std::to_array<std::pair<EGLint, const char*>>({
      {EGL_SUCCESS, "EGL_SUCCESS"},
      {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
      {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
      {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
      {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
      {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
      {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
      {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
      {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
      {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
      {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
  });
  for (const auto& [value, name] : kNames) {
    if (value == error) return name;
  }
  return fmt::format("EGL error {:#x}", error);
}

}  // namespace host::egl
