#pragma once

#include <memory>
#include <string>
#include <vector>

namespace host {

/// A headless OpenGL core context, current on the creating thread until it is destroyed.
class GlContext {
 public:
  /// With Debug::on the driver checks more, and its error messages (GL_KHR_debug) are kept for takeErrors().
  /// Nothing is ever printed.
  enum class Debug { off, on };

  /// Tries EGL's surfaceless platform, then every device of its device platform. Throws std::runtime_error
  /// with a sentence if there is no device, or its OpenGL is below 3.3.
  explicit GlContext(Debug debug = Debug::off);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  GlContext(GlContext&&) = delete;
  GlContext& operator=(GlContext&&) = delete;

  struct Info {
    std::string renderer;
    std::string vendor;
    std::string version;    ///< GL_VERSION
    std::string platform;   ///< "EGL surfaceless" or "EGL device"
    bool software = false;  ///< a CPU rasteriser such as llvmpipe
  };
  [[nodiscard]] const Info& info() const;

  /// The driver's error messages since the last call; always empty without Debug::on.
  std::vector<std::string> takeErrors();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace host
