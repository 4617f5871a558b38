#include "mres/gl/state_guard.h"

#include <algorithm>

namespace mres::gl {
namespace {

// Whatever of these a host has enabled would change our draws. Blending (per draw buffer) and the scissor
// (per viewport) are handled apart; blend functions matter to neither us nor, since we leave them alone, the
// host.
constexpr std::array<GLenum, 24> kGuardedCapabilities = {GL_CULL_FACE,
                                                         GL_DEPTH_TEST,
                                                         GL_STENCIL_TEST,
                                                         GL_DEPTH_CLAMP,
                                                         GL_DITHER,
                                                         GL_MULTISAMPLE,
                                                         GL_SAMPLE_COVERAGE,
                                                         GL_SAMPLE_ALPHA_TO_COVERAGE,
                                                         GL_RASTERIZER_DISCARD,
                                                         GL_COLOR_LOGIC_OP,
                                                         GL_FRAMEBUFFER_SRGB,
                                                         GL_SAMPLE_ALPHA_TO_ONE,
                                                         GL_SAMPLE_MASK,
                                                         GL_POLYGON_SMOOTH,
                                                         GL_POLYGON_OFFSET_FILL,
                                                         GL_PRIMITIVE_RESTART,
                                                         GL_CLIP_DISTANCE0,
                                                         GL_CLIP_DISTANCE1,
                                                         GL_CLIP_DISTANCE2,
                                                         GL_CLIP_DISTANCE3,
                                                         GL_CLIP_DISTANCE4,
                                                         GL_CLIP_DISTANCE5,
                                                         GL_CLIP_DISTANCE6,
                                                         GL_CLIP_DISTANCE7};

GLint integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

void setEnabled(GLenum capability, GLboolean enabled) {
  if (enabled == GL_TRUE) {
    glEnable(capability);
  } else {
    glDisable(capability);
  }
}

}  // namespace

GLuint StateGuard::countViewports() {
  if (epoxy_gl_version() < 41 && !epoxy_has_gl_extension("GL_ARB_viewport_array")) return 1;
  return std::min(static_cast<GLuint>(integer(GL_MAX_VIEWPORTS)), kMaxViewports);
}

StateGuard::StateGuard(GLuint viewports) : viewportCount_(viewports) {
  static_assert(kGuardedCapabilities.size() == kCapabilities);
  saveBindings();
  saveRasterState();
  setDefaults();
}

StateGuard::~StateGuard() {
  restoreRasterState();
  restoreBindings();
}

void StateGuard::saveBindings() {
  program_ = integer(GL_CURRENT_PROGRAM);
  vertexArray_ = integer(GL_VERTEX_ARRAY_BINDING);
  drawFramebuffer_ = integer(GL_DRAW_FRAMEBUFFER_BINDING);
  readFramebuffer_ = integer(GL_READ_FRAMEBUFFER_BINDING);
  renderbuffer_ = integer(GL_RENDERBUFFER_BINDING);
  pixelUnpackBuffer_ = integer(GL_PIXEL_UNPACK_BUFFER_BINDING);
  pixelPackBuffer_ = integer(GL_PIXEL_PACK_BUFFER_BINDING);
  activeTexture_ = integer(GL_ACTIVE_TEXTURE);
  for (GLuint unit = 0; unit < kTextureUnits; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    textureUnits_.at(unit) = {integer(GL_TEXTURE_BINDING_2D), integer(GL_SAMPLER_BINDING)};
  }
  uniformBuffer_ = integer(GL_UNIFORM_BUFFER_BINDING);
  for (GLuint binding = 0; binding < kUniformBindings; ++binding) {
    UniformBinding& saved = uniformBindings_.at(binding);
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, binding, &saved.buffer);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_START, binding, &saved.start);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, binding, &saved.size);
  }
}

void StateGuard::saveRasterState() {
  for (std::size_t i = 0; i < kCapabilities; ++i) {
    capabilities_.at(i) = glIsEnabled(kGuardedCapabilities.at(i));
  }
  for (GLuint buffer = 0; buffer < kDrawBuffers; ++buffer) {
    glGetBooleani_v(GL_COLOR_WRITEMASK, buffer, colorMasks_.at(buffer).data());
    blendEnabled_.at(buffer) = glIsEnabledi(GL_BLEND, buffer);
  }
  stencil_[0] = {integer(GL_STENCIL_FUNC),           integer(GL_STENCIL_REF),
                 integer(GL_STENCIL_VALUE_MASK),     integer(GL_STENCIL_WRITEMASK),
                 integer(GL_STENCIL_FAIL),           integer(GL_STENCIL_PASS_DEPTH_FAIL),
                 integer(GL_STENCIL_PASS_DEPTH_PASS)};
  stencil_[1] = {integer(GL_STENCIL_BACK_FUNC),           integer(GL_STENCIL_BACK_REF),
                 integer(GL_STENCIL_BACK_VALUE_MASK),     integer(GL_STENCIL_BACK_WRITEMASK),
                 integer(GL_STENCIL_BACK_FAIL),           integer(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                 integer(GL_STENCIL_BACK_PASS_DEPTH_PASS)};
  saveViewports();
  glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
  glGetIntegerv(GL_POLYGON_MODE, polygonMode_.data());
}

// glViewport() and glDisable(GL_SCISSOR_TEST) change all viewports of OpenGL 4.1.
void StateGuard::saveViewports() {
  if (viewportCount_ == 1) {
    glGetFloatv(GL_VIEWPORT, &viewports_[0].rectangle.x);
    viewports_[0].scissored = glIsEnabled(GL_SCISSOR_TEST);
    return;
  }
  for (GLuint i = 0; i < viewportCount_; ++i) {
    glGetFloati_v(GL_VIEWPORT, i, &viewports_.at(i).rectangle.x);
    viewports_.at(i).scissored = glIsEnabledi(GL_SCISSOR_TEST, i);
  }
}

void StateGuard::setDefaults() const {
  for (const GLenum capability : kGuardedCapabilities) glDisable(capability);
  glDisable(GL_SCISSOR_TEST);
  for (GLuint buffer = 0; buffer < kDrawBuffers; ++buffer) {
    glColorMaski(buffer, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisablei(GL_BLEND, buffer);
  }
  glStencilMask(0xFF);
  glDepthMask(GL_FALSE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void StateGuard::restoreRasterState() const {
  for (std::size_t i = 0; i < kCapabilities; ++i) {
    setEnabled(kGuardedCapabilities.at(i), capabilities_.at(i));
  }
  for (GLuint buffer = 0; buffer < kDrawBuffers; ++buffer) {
    const auto& mask = colorMasks_.at(buffer);
    glColorMaski(buffer, mask[0], mask[1], mask[2], mask[3]);
    if (blendEnabled_.at(buffer) == GL_TRUE) {
      glEnablei(GL_BLEND, buffer);
    } else {
      glDisablei(GL_BLEND, buffer);
    }
  }
  constexpr std::array<GLenum, 2> kFaces = {GL_FRONT, GL_BACK};
  for (std::size_t i = 0; i < kFaces.size(); ++i) {
    const StencilFace& face = stencil_.at(i);
    glStencilFuncSeparate(kFaces.at(i), static_cast<GLenum>(face.func), face.ref,
                          static_cast<GLuint>(face.valueMask));
    glStencilMaskSeparate(kFaces.at(i), static_cast<GLuint>(face.writeMask));
    glStencilOpSeparate(kFaces.at(i), static_cast<GLenum>(face.fail), static_cast<GLenum>(face.depthFail),
                        static_cast<GLenum>(face.depthPass));
  }
  restoreViewports();
  glDepthMask(depthMask_);
  glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygonMode_[0]));
}

void StateGuard::restoreViewports() const {
  if (viewportCount_ == 1) {
    const glm::ivec4 rectangle(viewports_[0].rectangle);
    glViewport(rectangle.x, rectangle.y, rectangle.z, rectangle.w);
    setEnabled(GL_SCISSOR_TEST, viewports_[0].scissored);
    return;
  }
  for (GLuint i = 0; i < viewportCount_; ++i) {
    glViewportIndexedfv(i, &viewports_.at(i).rectangle.x);
    (viewports_.at(i).scissored == GL_TRUE ? glEnablei : glDisablei)(GL_SCISSOR_TEST, i);
  }
}

// A texture of ours that the host had bound (a result), or a program that the host has deleted while it was
// current, may be gone by now.
void StateGuard::restoreBindings() const {
  for (GLuint unit = 0; unit < kTextureUnits; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    const auto texture = static_cast<GLuint>(textureUnits_.at(unit).texture);
    glBindTexture(GL_TEXTURE_2D, glIsTexture(texture) == GL_TRUE ? texture : 0);
    glBindSampler(unit, static_cast<GLuint>(textureUnits_.at(unit).sampler));
  }
  glActiveTexture(static_cast<GLenum>(activeTexture_));
  for (GLuint binding = 0; binding < kUniformBindings; ++binding) {
    const UniformBinding& saved = uniformBindings_.at(binding);
    const auto buffer = static_cast<GLuint>(saved.buffer);
    if (saved.size > 0) {
      glBindBufferRange(GL_UNIFORM_BUFFER, binding, buffer, saved.start, saved.size);
    } else {
      glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
    }
  }
  glBindBuffer(GL_UNIFORM_BUFFER, static_cast<GLuint>(uniformBuffer_));
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(pixelUnpackBuffer_));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(pixelPackBuffer_));
  glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(renderbuffer_));
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer_));
  glBindVertexArray(static_cast<GLuint>(vertexArray_));
  const auto program = static_cast<GLuint>(program_);
  glUseProgram(glIsProgram(program) == GL_TRUE ? program : 0);
}

}  // namespace mres::gl
