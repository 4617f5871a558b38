#include "mres/mask/zone_pass.h"

#include <array>
#include <string>

namespace mres {

namespace {

struct Reasons {
  bool mask = false;
  bool edge = false;
  bool shownEdge = false;
  bool difference = false;
  bool bend = false;
  int channels = 1;
};

gl::Program makeProgram(const gl::ShaderLibrary& library, const Reasons& reasons) {
  std::string defines;
  const auto define = [&](const char* name, int value) {
    defines += std::string("#define ") + name + ' ' + std::to_string(value) + '\n';
  };
  define("MASK", reasons.mask);
  define("EDGE", reasons.edge);
  define("SHOWN_EDGE", reasons.shownEdge);
  define("DIFFERENCE", reasons.difference);
  define("BEND", reasons.bend);
  define("EFFECT_CHANNELS", reasons.channels);
  return makePassProgram(library, "mres/zone.frag", defines);
}

}  // namespace

ZonePass::ZonePass(const gl::ShaderLibrary& library)
    : mask_(makeProgram(library, {.mask = true})),
      edges_(makeProgram(library, {.edge = true})),
      edgesOrBends_(makeProgram(library, {.edge = true, .bend = true})),
      edgesOrBendsOfRadiance_(makeProgram(library, {.edge = true, .bend = true, .channels = 3})),
      shownEdgesOrDifference_(makeProgram(library, {.shownEdge = true, .difference = true})),
      shownEdgesOrDifferenceOfRadiance_(
          makeProgram(library, {.shownEdge = true, .difference = true, .channels = 3})),
      edgesOrDifference_(makeProgram(library, {.edge = true, .difference = true})),
      difference_(makeProgram(library, {.difference = true})) {}

const gl::Program& ZonePass::programOf(const ZoneInputs& inputs) const {
  switch (inputs.rule) {
    case ZoneRule::mask:
      return mask_;
    case ZoneRule::edgesOrBends:
      return inputs.channels == 1 ? edgesOrBends_ : edgesOrBendsOfRadiance_;
    case ZoneRule::shownEdgesOrDifference:
      return inputs.channels == 1 ? shownEdgesOrDifference_ : shownEdgesOrDifferenceOfRadiance_;
    case ZoneRule::edgesOrDifference:
      return edgesOrDifference_;
    case ZoneRule::difference:
      return difference_;
    case ZoneRule::edges:
      break;
  }
  return edges_;
}

void ZonePass::draw(PassContext& context, const PlannedLevel& level, const ZoneInputs& inputs) {
  const gl::Scope scope(context.profiler, "mres.stencil");
  gl::RenderTarget& target = zones_.at(slot(level.index));
  const glm::ivec2 size = (level.size + ZONE_BLOCK - 1) / ZONE_BLOCK;
  if (target.size() != size) target = gl::RenderTarget(size, {GL_R8}, 0, "mres.zone");
  gl::bindTexture(kMaskUnit, inputs.mask->id(), context.linear);
  if (inputs.coarser != nullptr) gl::bindTexture(kCoarserUnit, inputs.coarser->id(), context.nearest);
  if (inputs.refine != nullptr) gl::bindTexture(kZoneUnit, inputs.refine->id(), context.linear);
  glUseProgram(programOf(inputs).id());
  target.bind();
  context.triangle.draw();
}

void ZonePass::fill(float value) const {
  for (const gl::RenderTarget& zone : zones_) zone.fill(value);
}

std::size_t ZonePass::bytes() const {
  std::size_t sum = 0;
  for (const gl::RenderTarget& zone : zones_) sum += zone.bytes();
  return sum;
}

void startZone() {
  glClearBufferiv(GL_STENCIL, 0, &kZone);
  drawOutOfZone();
}

void drawOutOfZone() {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void drawInZone() {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, kZone, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

void clearAndDrawInZone() {
  constexpr std::array<float, 4> kUndefined{};
  glClearBufferfv(GL_COLOR, 0, kUndefined.data());
  drawInZone();
}

}  // namespace mres
