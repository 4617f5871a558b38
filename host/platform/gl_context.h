#pragma once

#include <memory>
#include <string>

namespace host {

/// A headless OpenGL core context, current on the creating thread until it is destroyed.
class GlContext {
 public:
  /// Tries EGL's surfaceless platform, then its device platform. Throws std::runtime_error with a sentence if
  /// there is no device, or its OpenGL is below 3.3.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  struct Info {
    std::string renderer;
    std::string vendor;
    std::string version;      ///< GL_VERSION
    std::string platform;     ///< "EGL surfaceless" or "EGL device"
    bool software = false;    ///< a CPU rasteriser such as llvmpipe
  };
  [[nodiscard]] const Info& info() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace host
