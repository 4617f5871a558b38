#include "tests/support/hostile_state.h"

#include <array>

#include "tests/support/glsl_function.h"

namespace mres::test {
namespace {

bool hasVersion(int version) {
  return epoxy_gl_version() >= version;
}

GLuint limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return static_cast<GLuint>(value);
}

constexpr std::array kSpoilingCapabilities = {GL_CULL_FACE,          GL_DEPTH_TEST,
                                              GL_SCISSOR_TEST,       GL_STENCIL_TEST,
                                              GL_DEPTH_CLAMP,        GL_DITHER,
                                              GL_MULTISAMPLE,        GL_SAMPLE_ALPHA_TO_COVERAGE,
                                              GL_SAMPLE_COVERAGE,    GL_RASTERIZER_DISCARD,
                                              GL_COLOR_LOGIC_OP,     GL_FRAMEBUFFER_SRGB,
                                              GL_SAMPLE_MASK,        GL_POLYGON_OFFSET_FILL,
                                              GL_PRIMITIVE_RESTART,  GL_SAMPLE_ALPHA_TO_ONE,
                                              GL_POLYGON_SMOOTH,     GL_LINE_SMOOTH,
                                              GL_PROGRAM_POINT_SIZE, GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                              GL_CLIP_DISTANCE0,     GL_CLIP_DISTANCE1,
                                              GL_CLIP_DISTANCE2,     GL_CLIP_DISTANCE3,
                                              GL_CLIP_DISTANCE4,     GL_CLIP_DISTANCE5,
                                              GL_CLIP_DISTANCE6,     GL_CLIP_DISTANCE7,
                                              GL_POLYGON_OFFSET_LINE};

void setCapabilities(bool hostile) {
  for (const GLenum capability : kSpoilingCapabilities) {
    const bool enabledByDefault = capability == GL_DITHER || capability == GL_MULTISAMPLE;
    if (hostile || enabledByDefault) {
      glEnable(capability);
    } else {
      glDisable(capability);
    }
  }
}

void spoilRasterState() {
  glCullFace(GL_FRONT_AND_BACK);
  glFrontFace(GL_CW);
  glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  glPolygonOffset(3.0f, 5.0f);
  glLineWidth(1.0f);
  glPointSize(3.0f);
  glScissor(1, 2, 0, 1);
  glViewport(5, 6, 7, 8);
  glDepthRange(0.75, 0.25);
  glDepthFunc(GL_NEVER);
  glDepthMask(GL_TRUE);
  glLogicOp(GL_INVERT);
  glSampleCoverage(0.0f, GL_TRUE);
  glSampleMaski(0, 0);
  glPrimitiveRestartIndex(1);
  glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
  glClearColor(0.1f, 0.2f, 0.3f, 0.4f);
  glClearDepth(0.3);
  glClearStencil(77);
  glStencilFuncSeparate(GL_FRONT, GL_NEVER, 3, 0x5A);
  glStencilFuncSeparate(GL_BACK, GL_LESS, 4, 0x3C);
  glStencilOpSeparate(GL_FRONT, GL_INVERT, GL_INCR, GL_DECR_WRAP);
  glStencilOpSeparate(GL_BACK, GL_ZERO, GL_DECR, GL_INCR_WRAP);
  glStencilMaskSeparate(GL_FRONT, 0x10);
  glStencilMaskSeparate(GL_BACK, 0x02);
}

void spoilDrawBuffers() {
  glBlendColor(0.5f, 0.25f, 0.125f, 0.75f);
  glBlendFuncSeparate(GL_ZERO, GL_DST_COLOR, GL_CONSTANT_ALPHA, GL_ONE);
  glBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
  const GLuint count = limit(GL_MAX_DRAW_BUFFERS);
  for (GLuint i = 0; i < count; ++i) {
    glColorMaski(i, i % 2 == 0, i % 3 == 1, GL_FALSE, i % 5 == 2);
    (i % 3 == 2 ? glDisablei : glEnablei)(GL_BLEND, i);
    if (hasVersion(40)) {
      glBlendFunci(i, i % 2 == 0 ? GL_ZERO : GL_DST_ALPHA, i % 3 == 0 ? GL_ONE : GL_SRC_COLOR);
      glBlendEquationi(i, i % 2 == 0 ? GL_MIN : GL_FUNC_SUBTRACT);
    }
  }
}

void spoilPixelStore() {
  for (const GLenum name :
       {GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT}) {
    glPixelStorei(name, 3);
  }
  for (const GLenum name : {GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES,
                            GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES, GL_UNPACK_SWAP_BYTES,
                            GL_PACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_PACK_LSB_FIRST}) {
    glPixelStorei(name, 1);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  glPixelStorei(GL_PACK_ALIGNMENT, 8);
}

void resetPixelStore() {
  for (const GLenum name :
       {GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT,
        GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES, GL_PACK_SKIP_ROWS,
        GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES, GL_UNPACK_SWAP_BYTES, GL_PACK_SWAP_BYTES,
        GL_UNPACK_LSB_FIRST, GL_PACK_LSB_FIRST}) {
    glPixelStorei(name, 0);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
}

void spoilNewerState() {
  if (hasVersion(40)) glPatchParameteri(GL_PATCH_VERTICES, 5);
  if (hasVersion(41)) {
    const GLuint count = limit(GL_MAX_VIEWPORTS);
    for (GLuint i = 0; i < count; ++i) {
      const auto shift = static_cast<float>(i) + 0.25f;
      glViewportIndexedf(i, shift, 2.0f * shift, 3.0f + shift, 4.0f + shift);
      (i % 2 == 0 ? glEnablei : glDisablei)(GL_SCISSOR_TEST, i);
      glScissorIndexed(i, static_cast<GLint>(i), 1, 0, 2);
      glDepthRangeIndexed(i, 0.5, 0.5 / (i + 1.0));
    }
  }
  if (hasVersion(43)) glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  if (hasVersion(45)) glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
}

void resetRasterState() {
  setCapabilities(false);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glPolygonOffset(0.0f, 0.0f);
  glPointSize(1.0f);
  glScissor(0, 0, 1, 1);
  glViewport(0, 0, 1, 1);
  glDepthRange(0.0, 1.0);
  glDepthFunc(GL_LESS);
  glLogicOp(GL_COPY);
  glSampleCoverage(1.0f, GL_FALSE);
  glSampleMaski(0, ~0u);
  glPrimitiveRestartIndex(0);
  glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
  glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(1.0);
  glClearStencil(0);
  glStencilFunc(GL_ALWAYS, 0, ~0u);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glStencilMask(~0u);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_BLEND);
  glBlendColor(0.0f, 0.0f, 0.0f, 0.0f);
  glBlendFunc(GL_ONE, GL_ZERO);
  glBlendEquation(GL_FUNC_ADD);
  if (hasVersion(40)) glPatchParameteri(GL_PATCH_VERTICES, 3);
  if (hasVersion(43)) glDisable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  if (hasVersion(45)) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

gl::Program makeProgram() {
  gl::ShaderLibrary library = shaderLibrary();
  library.add("test/host.frag", "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  return {library, {"common/full_screen.vert", "test/host.frag", {}}};
}

}  // namespace

HostileState::HostileState() : program_(makeProgram()) {
  bindObjects();
  bindTextures();
  setCapabilities(true);
  spoilRasterState();
  spoilDrawBuffers();
  spoilPixelStore();
  spoilNewerState();
}

void HostileState::bindObjects() {
  glUseProgram(program_.id());
  glBindVertexArray(vertexArray_.id());
  glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
  glBufferData(GL_UNIFORM_BUFFER, 65536, nullptr, GL_STATIC_DRAW);
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, feedbackBuffer_.id());
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 1024, nullptr, GL_STATIC_DRAW);
  glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 1, feedbackBuffer_.id(), 64, 128);
  const auto alignment = static_cast<GLintptr>(limit(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT));
  const GLuint bindings = limit(GL_MAX_UNIFORM_BUFFER_BINDINGS);
  for (GLuint i = 0; i < bindings; ++i) {
    if (i % 3 == 2) {
      glBindBufferBase(GL_UNIFORM_BUFFER, i, buffer_.id());
    } else {
      glBindBufferRange(GL_UNIFORM_BUFFER, i, buffer_.id(), alignment * (i % 7),
                        16 * (static_cast<GLsizeiptr>(i) + 1));
    }
  }
  for (const GLenum target :
       {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER,
        GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER, GL_UNIFORM_BUFFER}) {
    glBindBuffer(target, buffer_.id());
  }
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, drawFramebuffer_.id());
  glDrawBuffer(GL_NONE);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, readFramebuffer_.id());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
}

void HostileState::bindTextures() {
  glSamplerParameteri(sampler_.id(), GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
  glSamplerParameteri(sampler_.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glSamplerParameterf(sampler_.id(), GL_TEXTURE_MIN_LOD, 3.0f);
  glSamplerParameterf(sampler_.id(), GL_TEXTURE_LOD_BIAS, 2.0f);
  const GLuint units = limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  for (GLuint unit = 0; unit < units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture2D_.id());
    glBindTexture(GL_TEXTURE_CUBE_MAP, textureCube_.id());
    glBindTexture(GL_TEXTURE_3D, texture3D_.id());
    glBindTexture(GL_TEXTURE_2D_ARRAY, textureArray_.id());
    glBindSampler(unit, sampler_.id());
  }
  glActiveTexture(GL_TEXTURE0 + 11);
}

HostileState::~HostileState() {
  resetRasterState();
  resetPixelStore();
  glUseProgram(0);
  glBindVertexArray(0);
  for (const GLenum target :
       {GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_PIXEL_PACK_BUFFER,
        GL_PIXEL_UNPACK_BUFFER, GL_UNIFORM_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER}) {
    glBindBuffer(target, 0);
  }
  const GLuint bindings = limit(GL_MAX_UNIFORM_BUFFER_BINDINGS);
  for (GLuint i = 0; i < bindings; ++i) glBindBufferBase(GL_UNIFORM_BUFFER, i, 0);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 1, 0);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  const GLuint units = limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  for (GLuint unit = 0; unit < units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum target : {GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY}) {
      glBindTexture(target, 0);
    }
    glBindSampler(unit, 0);
  }
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace mres::test
