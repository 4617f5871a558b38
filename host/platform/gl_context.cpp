#include "host/platform/gl_context.h"

#include <array>
#include <cstdlib>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host/platform/egl_display.h"

namespace host {
namespace {

constexpr const char* kAdvice =
    "install a driver for OpenGL 3.3 (on Debian, libegl1 and libgl1-mesa-dri bring a software one)";

/// A context on a display. The display itself is never terminated: EGL shares it with every other context of
/// the process, and gives no count of its users.
class EglContext {
 public:
  EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
  EglContext(EglContext&& other) noexcept
      : display_(other.display_), context_(std::exchange(other.context_, EGL_NO_CONTEXT)) {}
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  EglContext& operator=(EglContext&&) = delete;
  ~EglContext() {
    if (context_ == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context_) {
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display_, context_);
  }

  [[nodiscard]] bool makeCurrent() const {
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

std::string text(GLenum name) {
  const GLubyte* value = glGetString(name);
  return value == nullptr ? "unknown" : reinterpret_cast<const char*>(value);
}

/// A configuration for desktop OpenGL; surfaces are of no interest here.
EGLConfig chooseConfig(EGLDisplay display) {
  static constexpr std::array<EGLint, 5> kWanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                                    EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (eglChooseConfig(display, kWanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
    return EGL_NO_CONFIG_KHR;  // fine where EGL_KHR_no_config_context is known, else the context fails
  }
  return config;
}

std::optional<EglContext> createContext(EGLDisplay display, const EGLint* attributes) {
  EGLContext context = eglCreateContext(display, chooseConfig(display), EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) return std::nullopt;
  return EglContext(display, context);
}

std::optional<EglContext> createCoreContext(EGLDisplay display, GlContext::Debug debug) {
  std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE,
                                      EGL_TRUE,
                                      EGL_NONE};
  if (debug == GlContext::Debug::on) attributes[6] = EGL_CONTEXT_OPENGL_DEBUG;
  return createContext(display, attributes.data());
}

/// The version that the driver would give to who asks for none, so that the sentence can name it.
std::string versionOnOffer(EGLDisplay display) {
  static constexpr std::array<EGLint, 1> kAny = {EGL_NONE};
  const std::optional<EglContext> context = createContext(display, kAny.data());
  if (!context || !context->makeCurrent()) return "none at all";
  return fmt::format("only {}", text(GL_VERSION));
}

/// Makes a context on one display current, or says in `reason` why it can't.
std::optional<EglContext> tryDisplay(const egl::Display& display, GlContext::Debug debug,
                                     std::string& reason) {
  if (eglInitialize(display.handle, nullptr, nullptr) == EGL_FALSE) {
    reason = fmt::format("{} does not start ({})", display.platform, egl::errorName(eglGetError()));
    return std::nullopt;
  }
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
    reason = fmt::format("{} has no desktop OpenGL", display.platform);
    return std::nullopt;
  }
  std::optional<EglContext> context = createCoreContext(display.handle, debug);
  if (!context) {
    reason = fmt::format("{} offers no OpenGL 3.3 core context but {}", display.platform,
                         versionOnOffer(display.handle));
    return std::nullopt;
  }
  if (!context->makeCurrent()) {
    reason =
        fmt::format("{} cannot draw without a window ({})", display.platform, egl::errorName(eglGetError()));
    return std::nullopt;
  }
  if (epoxy_gl_version() < 33) {  // a driver may hand out less than was asked for
    reason = fmt::format("{} offers OpenGL {} where 3.3 is needed", display.platform, text(GL_VERSION));
    return std::nullopt;
  }
  return context;
}

bool isSoftware(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "SWR", "swrast", "Software Rasterizer", "SwiftShader"}) {
    if (renderer.find(name) != std::string::npos) return true;
  }
  return false;
}

void GLAPIENTRY keepError(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum /*severity*/,
                          GLsizei /*length*/, const GLchar* message, const void* errors) {
  if (type != GL_DEBUG_TYPE_ERROR) return;
  // The callback's user pointer is const by its signature; it is ours and points to a mutable list.
  static_cast<std::vector<std::string>*>(const_cast<void*>(errors))->emplace_back(message);
}

}  // namespace

struct GlContext::Implementation {
  std::vector<std::string> errors;  // outlives the context, which may still report while it is destroyed
  EglContext context;
  Info info;

  void listen() {
    if (epoxy_gl_version() < 43 && !epoxy_has_gl_extension("GL_KHR_debug")) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(keepError, &errors);
  }
};

GlContext::GlContext(Debug debug) {
  // Mesa's EGL warns on stderr of each driver that it cannot load; what matters of it is thrown.
  setenv("EGL_LOG_LEVEL", "fatal", 0);
  std::string reasons;
  for (const egl::Display& display : egl::headlessDisplays()) {
    std::string reason;
    std::optional<EglContext> context = tryDisplay(display, debug, reason);
    if (!context) {
      reasons += (reasons.empty() ? "" : "; ") + reason;
      continue;
    }
    const std::string renderer = text(GL_RENDERER);
    implementation_ = std::make_unique<Implementation>(Implementation{
        {},
        std::move(*context),
        {renderer, text(GL_VENDOR), text(GL_VERSION), display.platform, isSoftware(renderer)}});
    if (debug == Debug::on) implementation_->listen();
    return;
  }
  if (reasons.empty()) reasons = "EGL here knows neither the surfaceless nor the device platform";
  throw std::runtime_error(fmt::format("No OpenGL device to draw with: {}; {}.", reasons, kAdvice));
}

GlContext::~GlContext() = default;

const GlContext::Info& GlContext::info() const {
  return implementation_->info;
}

std::vector<std::string> GlContext::takeErrors() {
  return std::exchange(implementation_->errors, {});
}

}  // namespace host
