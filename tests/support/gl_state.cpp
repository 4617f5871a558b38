#include "tests/support/gl_state.h"

#include <array>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mres::test {
namespace {

struct Named {
  const char* name;
  GLenum value;
  int version = 33;  // the OpenGL version that has it
};
#define NAMED(x) \
  Named {        \
#x, x        \
  }
#define NAMED_SINCE(version, x) \
  Named {                       \
#x, x, version              \
  }

constexpr std::array kCapabilities = {NAMED(GL_COLOR_LOGIC_OP),
                                      NAMED(GL_CULL_FACE),
                                      NAMED(GL_DEPTH_CLAMP),
                                      NAMED(GL_DEPTH_TEST),
                                      NAMED(GL_DITHER),
                                      NAMED(GL_FRAMEBUFFER_SRGB),
                                      NAMED(GL_LINE_SMOOTH),
                                      NAMED(GL_MULTISAMPLE),
                                      NAMED(GL_POLYGON_OFFSET_FILL),
                                      NAMED(GL_POLYGON_OFFSET_LINE),
                                      NAMED(GL_POLYGON_OFFSET_POINT),
                                      NAMED(GL_POLYGON_SMOOTH),
                                      NAMED(GL_PRIMITIVE_RESTART),
                                      NAMED(GL_PROGRAM_POINT_SIZE),
                                      NAMED(GL_RASTERIZER_DISCARD),
                                      NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                      NAMED(GL_SAMPLE_ALPHA_TO_ONE),
                                      NAMED(GL_SAMPLE_COVERAGE),
                                      NAMED(GL_SAMPLE_MASK),
                                      NAMED(GL_STENCIL_TEST),
                                      NAMED(GL_TEXTURE_CUBE_MAP_SEAMLESS),
                                      NAMED(GL_CLIP_DISTANCE0),
                                      NAMED(GL_CLIP_DISTANCE1),
                                      NAMED(GL_CLIP_DISTANCE2),
                                      NAMED(GL_CLIP_DISTANCE3),
                                      NAMED(GL_CLIP_DISTANCE4),
                                      NAMED(GL_CLIP_DISTANCE5),
                                      NAMED(GL_CLIP_DISTANCE6),
                                      NAMED(GL_CLIP_DISTANCE7),
                                      NAMED_SINCE(40, GL_SAMPLE_SHADING),
                                      NAMED_SINCE(43, GL_PRIMITIVE_RESTART_FIXED_INDEX)};

constexpr std::array kValues = {NAMED(GL_ACTIVE_TEXTURE),
                                NAMED(GL_ARRAY_BUFFER_BINDING),
                                NAMED(GL_BLEND_COLOR),
                                NAMED(GL_CLAMP_READ_COLOR),
                                NAMED(GL_COLOR_CLEAR_VALUE),
                                NAMED(GL_COPY_READ_BUFFER_BINDING),
                                NAMED(GL_COPY_WRITE_BUFFER_BINDING),
                                NAMED(GL_CULL_FACE_MODE),
                                NAMED(GL_CURRENT_PROGRAM),
                                NAMED(GL_DEPTH_CLEAR_VALUE),
                                NAMED(GL_DEPTH_FUNC),
                                NAMED(GL_DEPTH_RANGE),
                                NAMED(GL_DEPTH_WRITEMASK),
                                NAMED(GL_DRAW_FRAMEBUFFER_BINDING),
                                NAMED(GL_DRAW_BUFFER),
                                NAMED(GL_ELEMENT_ARRAY_BUFFER_BINDING),
                                NAMED(GL_FRONT_FACE),
                                NAMED(GL_LINE_WIDTH),
                                NAMED(GL_LOGIC_OP_MODE),
                                NAMED(GL_PACK_ALIGNMENT),
                                NAMED(GL_PACK_IMAGE_HEIGHT),
                                NAMED(GL_PACK_LSB_FIRST),
                                NAMED(GL_PACK_ROW_LENGTH),
                                NAMED(GL_PACK_SKIP_IMAGES),
                                NAMED(GL_PACK_SKIP_PIXELS),
                                NAMED(GL_PACK_SKIP_ROWS),
                                NAMED(GL_PACK_SWAP_BYTES),
                                NAMED(GL_PIXEL_PACK_BUFFER_BINDING),
                                NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING),
                                NAMED(GL_POINT_FADE_THRESHOLD_SIZE),
                                NAMED(GL_POINT_SIZE),
                                NAMED(GL_POLYGON_MODE),
                                NAMED(GL_POLYGON_OFFSET_FACTOR),
                                NAMED(GL_POLYGON_OFFSET_UNITS),
                                NAMED(GL_PRIMITIVE_RESTART_INDEX),
                                NAMED(GL_PROVOKING_VERTEX),
                                NAMED(GL_READ_BUFFER),
                                NAMED(GL_READ_FRAMEBUFFER_BINDING),
                                NAMED(GL_RENDERBUFFER_BINDING),
                                NAMED(GL_SAMPLE_COVERAGE_INVERT),
                                NAMED(GL_SAMPLE_COVERAGE_VALUE),
                                NAMED(GL_STENCIL_BACK_FAIL),
                                NAMED(GL_STENCIL_BACK_FUNC),
                                NAMED(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                                NAMED(GL_STENCIL_BACK_PASS_DEPTH_PASS),
                                NAMED(GL_STENCIL_BACK_REF),
                                NAMED(GL_STENCIL_BACK_VALUE_MASK),
                                NAMED(GL_STENCIL_BACK_WRITEMASK),
                                NAMED(GL_STENCIL_CLEAR_VALUE),
                                NAMED(GL_STENCIL_FAIL),
                                NAMED(GL_STENCIL_FUNC),
                                NAMED(GL_STENCIL_PASS_DEPTH_FAIL),
                                NAMED(GL_STENCIL_PASS_DEPTH_PASS),
                                NAMED(GL_STENCIL_REF),
                                NAMED(GL_STENCIL_VALUE_MASK),
                                NAMED(GL_STENCIL_WRITEMASK),
                                NAMED(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING),
                                NAMED(GL_UNIFORM_BUFFER_BINDING),
                                NAMED(GL_UNPACK_ALIGNMENT),
                                NAMED(GL_UNPACK_IMAGE_HEIGHT),
                                NAMED(GL_UNPACK_LSB_FIRST),
                                NAMED(GL_UNPACK_ROW_LENGTH),
                                NAMED(GL_UNPACK_SKIP_IMAGES),
                                NAMED(GL_UNPACK_SKIP_PIXELS),
                                NAMED(GL_UNPACK_SKIP_ROWS),
                                NAMED(GL_UNPACK_SWAP_BYTES),
                                NAMED(GL_VERTEX_ARRAY_BINDING),
                                NAMED(GL_VIEWPORT),
                                NAMED(GL_SCISSOR_BOX),
                                NAMED_SINCE(40, GL_PATCH_VERTICES),
                                NAMED_SINCE(40, GL_DRAW_INDIRECT_BUFFER_BINDING),
                                NAMED_SINCE(40, GL_TRANSFORM_FEEDBACK_BINDING),
                                NAMED_SINCE(41, GL_PROGRAM_PIPELINE_BINDING),
                                NAMED_SINCE(43, GL_SHADER_STORAGE_BUFFER_BINDING),
                                NAMED_SINCE(43, GL_DEBUG_GROUP_STACK_DEPTH),
                                NAMED_SINCE(45, GL_CLIP_ORIGIN),
                                NAMED_SINCE(45, GL_CLIP_DEPTH_MODE)};

constexpr std::array kTextureBindings = {NAMED(GL_TEXTURE_BINDING_1D),
                                         NAMED(GL_TEXTURE_BINDING_1D_ARRAY),
                                         NAMED(GL_TEXTURE_BINDING_2D),
                                         NAMED(GL_TEXTURE_BINDING_2D_ARRAY),
                                         NAMED(GL_TEXTURE_BINDING_3D),
                                         NAMED(GL_TEXTURE_BINDING_CUBE_MAP),
                                         NAMED(GL_TEXTURE_BINDING_RECTANGLE),
                                         NAMED(GL_TEXTURE_BINDING_BUFFER),
                                         NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
                                         NAMED(GL_SAMPLER_BINDING)};

constexpr std::array kIndexedBlend = {NAMED(GL_BLEND_SRC_RGB),      NAMED(GL_BLEND_DST_RGB),
                                      NAMED(GL_BLEND_SRC_ALPHA),    NAMED(GL_BLEND_DST_ALPHA),
                                      NAMED(GL_BLEND_EQUATION_RGB), NAMED(GL_BLEND_EQUATION_ALPHA)};

constexpr std::array kQueries = {NAMED(GL_SAMPLES_PASSED), NAMED(GL_PRIMITIVES_GENERATED),
                                 NAMED(GL_TIME_ELAPSED), NAMED(GL_ANY_SAMPLES_PASSED)};
#undef NAMED
#undef NAMED_SINCE

bool hasVersion(int version) {
  return epoxy_gl_version() >= version;
}

GLuint limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return static_cast<GLuint>(value);
}

template <class Get>
void capture(GlState& state, const std::string& name, Get get) {
  constexpr double kUntouched = 7.25e77;
  std::vector<double> values(16, kUntouched);
  get(values.data());
  while (!values.empty() && values.back() == kUntouched) values.pop_back();
  state.emplace(name, std::move(values));
}

void captureIndexedIntegers(GlState& state, const std::string& name, GLenum value, GLuint count) {
  for (GLuint i = 0; i < count; ++i) {
    GLint64 result = 0;
    glGetInteger64i_v(value, i, &result);
    state[fmt::format("{}[{}]", name, i)] = {static_cast<double>(result)};
  }
}

void captureDrawBuffers(GlState& state) {
  const GLuint count = limit(GL_MAX_DRAW_BUFFERS);
  for (GLuint i = 0; i < count; ++i) {
    std::array<GLboolean, 4> mask{};
    glGetBooleani_v(GL_COLOR_WRITEMASK, i, mask.data());
    state[fmt::format("GL_COLOR_WRITEMASK[{}]", i)] = {mask.begin(), mask.end()};
    state[fmt::format("GL_BLEND[{}]", i)] = {static_cast<double>(glIsEnabledi(GL_BLEND, i))};
    capture(state, fmt::format("GL_DRAW_BUFFER{}", i),
            [&](double* values) { glGetDoublev(GL_DRAW_BUFFER0 + i, values); });
  }
  for (const Named& blend : kIndexedBlend) {
    captureIndexedIntegers(state, blend.name, blend.value, hasVersion(40) ? count : 1);
  }
}

void captureTextures(GlState& state) {
  const GLuint active = limit(GL_ACTIVE_TEXTURE);
  const GLuint units = limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  for (GLuint unit = 0; unit < units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const Named& binding : kTextureBindings) {
      state[fmt::format("{}[{}]", binding.name, unit)] = {static_cast<double>(limit(binding.value))};
    }
  }
  glActiveTexture(active);
}

void captureViewports(GlState& state) {
  if (!hasVersion(41)) {
    state["GL_SCISSOR_TEST"] = {static_cast<double>(glIsEnabled(GL_SCISSOR_TEST))};
    return;
  }
  const GLuint count = limit(GL_MAX_VIEWPORTS);
  for (GLuint i = 0; i < count; ++i) {
    state[fmt::format("GL_SCISSOR_TEST[{}]", i)] = {static_cast<double>(glIsEnabledi(GL_SCISSOR_TEST, i))};
    for (const auto& [name, value] : {std::pair{"GL_VIEWPORT", static_cast<GLenum>(GL_VIEWPORT)},
                                      std::pair{"GL_SCISSOR_BOX", static_cast<GLenum>(GL_SCISSOR_BOX)},
                                      std::pair{"GL_DEPTH_RANGE", static_cast<GLenum>(GL_DEPTH_RANGE)}}) {
      capture(state, fmt::format("{}[{}]", name, i),
              [value = value, i](double* values) { glGetDoublei_v(value, i, values); });
    }
  }
}

}  // namespace

GlState captureGlState() {
  GlState state;
  for (const Named& capability : kCapabilities) {
    if (hasVersion(capability.version)) {
      state[capability.name] = {static_cast<double>(glIsEnabled(capability.value))};
    }
  }
  for (const Named& value : kValues) {
    if (hasVersion(value.version)) {
      capture(state, value.name, [&](double* values) { glGetDoublev(value.value, values); });
    }
  }
  captureDrawBuffers(state);
  captureTextures(state);
  captureViewports(state);
  const GLuint uniformBindings = limit(GL_MAX_UNIFORM_BUFFER_BINDINGS);
  captureIndexedIntegers(state, "GL_UNIFORM_BUFFER_BINDING", GL_UNIFORM_BUFFER_BINDING, uniformBindings);
  captureIndexedIntegers(state, "GL_UNIFORM_BUFFER_START", GL_UNIFORM_BUFFER_START, uniformBindings);
  captureIndexedIntegers(state, "GL_UNIFORM_BUFFER_SIZE", GL_UNIFORM_BUFFER_SIZE, uniformBindings);
  captureIndexedIntegers(state, "GL_TRANSFORM_FEEDBACK_BUFFER_BINDING", GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
                         4);
  captureIndexedIntegers(state, "GL_SAMPLE_MASK_VALUE", GL_SAMPLE_MASK_VALUE, 1);
  for (const Named& query : kQueries) {
    GLint current = 0;
    glGetQueryiv(query.value, GL_CURRENT_QUERY, &current);
    state[query.name] = {static_cast<double>(current)};
  }
  return state;
}

std::vector<std::string> differences(const GlState& before, const GlState& after) {
  std::vector<std::string> found;
  for (const auto& [name, values] : before) {
    const std::vector<double>& now = after.at(name);
    if (now != values) found.push_back(fmt::format("{}: {} became {}", name, values, now));
  }
  return found;
}

}  // namespace mres::test
