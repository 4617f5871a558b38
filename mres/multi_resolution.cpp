#include "mres/multi_resolution.h"

#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mres/composite/composite_pass.h"
#include "mres/composite/disjoint_pass.h"
#include "mres/debug/debug_view_pass.h"
#include "mres/gl/state_guard.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/level/coverage.h"
#include "mres/level/depth_pyramid.h"
#include "mres/level/effect_pass.h"
#include "mres/level/frame_params.h"
#include "mres/level/frame_textures.h"
#include "mres/level/pass_context.h"
#include "mres/mask/edge_pass.h"
#include "mres/mask/importance_pass.h"
#include "mres/mask/mask_pass.h"
#include "mres/mask/min_max_pass.h"
#include "mres/mask/preview_pass.h"
#include "mres/mask/zone_pass.h"
#include "mres/plan/level_plan.h"
#include "mres/validate.h"

namespace mres {

std::span<const gl::ShaderFile> embeddedShaders();

namespace {

/// The passes that all effects share; compiled together, so that a reload replaces all or none.
struct SharedPasses {
  explicit SharedPasses(const gl::ShaderLibrary& library)
      : pyramid(library),
        edges(library),
        minMax(library),
        importance(library),
        masks(library),
        zones(library),
        disjoint(library) {}

  void fill(float value) const {
    pyramid.fill(value);
    edges.fill(value);
    minMax.fill(value);
    importance.fill(value);
    masks.fill(value);
    zones.fill(value);
  }

  DepthPyramid pyramid;
  EdgePass edges;
  MinMaxPass minMax;
  ImportancePass importance;
  MaskPass masks;
  ZonePass zones;
  DisjointPass disjoint;
};

/// The passes of one effect.
struct EffectPasses {
  EffectPasses(const gl::ShaderLibrary& library, const EffectDescription& description)
      : effect(library, description), preview(library, description), composite(library, description) {}

  EffectPass effect;
  PreviewPass preview;
  CompositePass composite;
  CoverageQueries coverage;
};

/// What a reload compiles of an effect before anything is replaced.
struct EffectPrograms {
  gl::Program effect;
  PreviewPass preview;
  CompositePass composite;
};

}  // namespace

struct MultiResolution::Implementation {
  explicit Implementation(const Options& options) : measureCoverage(options.measureCoverage) {
    context.profiler = gl::Profiler(options.profiling);
    context.library.add(embeddedShaders());
    context.library.setDirectory(options.shaderDirectory);
    shared.emplace(context.library);
  }

  GLuint render(Effect& effect, const Frame& frame);
  GLuint debugView(DebugView view);
  void reloadShaders();
  EffectPasses& passesOf(Effect& effect);
  DepthFormat bindFrame(const Frame& frame, const params::FrameParams& params);
  void uploadLevels(EffectPass& effect, glm::ivec2 fullSize);
  [[nodiscard]] bool isCoarsest(std::size_t planned) const { return planned + 1 == plan.levels.size(); }
  [[nodiscard]] bool isDisjoint() const { return settings.mask.disjoint && plan.levels.size() > 1; }
  [[nodiscard]] LevelRole roleOf(std::size_t planned) const;
  ZoneInputs zoneOf(EffectPass& effect, std::size_t planned);
  const gl::Texture2D& drawGeometryEdges(const params::FrameParams& params, DepthFormat depth);
  MaskSources maskSources(const Frame& frame);
  void drawMasks(EffectPasses& passes, const Frame& frame, const params::FrameParams& params,
                 DepthFormat depth);
  void renderLevels(EffectPasses& passes);
  void renderDisjointLevels(EffectPasses& passes);
  void drawZones(EffectPass& effect);
  void startDisjointLevel(EffectPass& effect, std::size_t planned);
  void drawEffect(EffectPasses& passes, std::size_t planned);
  void fillReport(EffectPasses& passes);

  Settings settings;
  bool measureCoverage;
  GLuint viewports = gl::StateGuard::countViewports();
  PassContext context;
  gl::UniformBuffer<params::FrameParams> frameBlock;
  std::optional<SharedPasses> shared;
  std::map<std::string, EffectPasses, std::less<>> effects;
  std::optional<DebugViewPass> debugViewPass;
  LevelPlan plan;
  EdgeImages edges;         // of the last frame
  bool hasPicture = false;  // everything that the plan names was rendered
  Report report;
};

EffectPasses& MultiResolution::Implementation::passesOf(Effect& effect) {
  const EffectDescription& description = effect.description();
  auto found = effects.find(std::string_view(description.name));
  if (found == effects.end()) {
    found = effects.try_emplace(description.name, context.library, description).first;
  }
  found->second.effect.expectSame(effect);
  found->second.effect.setUp(effect);
  found->second.preview.setUp(effect);
  return found->second;
}

DepthFormat MultiResolution::Implementation::bindFrame(const Frame& frame,
                                                       const params::FrameParams& params) {
  const DepthFormat depth = bindFrameTextures(context, frame);
  frameBlock.upload(params);
  frameBlock.bind(kFrameBlock);
  return depth;
}

LevelRole MultiResolution::Implementation::roleOf(std::size_t planned) const {
  if (isDisjoint()) return LevelRole::zoned;
  if (isCoarsest(planned)) return LevelRole::coarsest;
  return planned == 0 ? LevelRole::zoned : LevelRole::intermediate;
}

void MultiResolution::Implementation::uploadLevels(EffectPass& effect, glm::ivec2 fullSize) {
  for (std::size_t i = 0; i < plan.levels.size(); ++i) {
    const PlannedLevel& level = plan.levels[i];
    const LevelNeighbours neighbours{level, isCoarsest(i) ? nullptr : &plan.levels[i + 1],
                                     i == 0 ? nullptr : &plan.levels[i - 1]};
    LevelTargets& targets = effect.targets(level.index);
    targets.ensure(effect.effect(), level.size, roleOf(i));
    targets.params().upload(levelParams(neighbours, fullSize, settings.mask.refineThreshold));
  }
}

ZoneInputs MultiResolution::Implementation::zoneOf(EffectPass& effect, std::size_t planned) {
  const LevelTargets& coarser = effect.targets(plan.levels[planned + 1].index);
  const bool progressive = settings.mask.refineThreshold > 0.0f && coarser.role() == LevelRole::intermediate;
  return {.mask = &shared->masks.mask(plan.levels[planned].index),
          .coarser = &coarser.composed().color(0),
          .refine = progressive ? &coarser.composed().color(1) : nullptr};
}

GLuint MultiResolution::Implementation::render(Effect& effect, const Frame& frame) {
  const params::FrameParams params = frameParams(frame);
  validate("MaskSettings", settings.mask);
  validate(effect.levels());
  const gl::StateGuard guard(viewports);
  const DepthFormat depth = bindFrame(frame, params);
  context.profiler.beginFrame();
  EffectPasses& passes = passesOf(effect);
  hasPicture = false;
  plan = planLevels(settings.technique, effect.levels(), frame.size);
  uploadLevels(passes.effect, frame.size);
  if (effect.description().readsPyramid) shared->pyramid.draw(context, frame.size);
  effect.bind();
  edges = {};
  if (plan.levels.size() > 1) drawMasks(passes, frame, params, depth);
  if (isDisjoint()) {
    renderDisjointLevels(passes);
  } else {
    renderLevels(passes);
  }
  context.profiler.endFrame();
  fillReport(passes);
  hasPicture = true;
  return passes.effect.targets(plan.levels.front().index).composed().color().id();
}

const gl::Texture2D& MultiResolution::Implementation::drawGeometryEdges(const params::FrameParams& params,
                                                                        DepthFormat depth) {
  if (settings.mask.minMaxMips) {
    shared->minMax.draw(context, settings.mask, params, depth, plan);
    return shared->minMax.edges(0);
  }
  shared->edges.draw(context, settings.mask, params, depth);
  return shared->edges.edges();
}

MaskSources MultiResolution::Implementation::maskSources(const Frame& frame) {
  MaskSources sources{.edges = edges.effect != nullptr ? edges.effect : edges.geometry};
  const auto combined = [&](int level, const gl::Texture2D& image) {
    if (frame.importance == 0) return &image;
    return &shared->importance.draw(context, settings.mask.combination, level, image, frame);
  };
  sources.edges = combined(0, *sources.edges);
  if (!settings.mask.minMaxMips || edges.geometry == nullptr) return sources;
  for (std::size_t i = 1; i + 1 < plan.levels.size(); ++i) {
    const int level = plan.levels[i].index;
    sources.joined.at(static_cast<std::size_t>(level)) = combined(level, shared->minMax.edges(level));
  }
  return sources;
}

void MultiResolution::Implementation::drawMasks(EffectPasses& passes, const Frame& frame,
                                                const params::FrameParams& params, DepthFormat depth) {
  const bool wantsGeometry = !passes.preview || settings.mask.geometryAlways;
  if (wantsGeometry) edges.geometry = &drawGeometryEdges(params, depth);
  if (passes.preview) {
    passes.preview.draw(context, settings.mask, params.size, edges.geometry);
    edges.effect = &passes.preview.edges();
  }
  shared->masks.draw(context, maskSources(frame), plan);
}

void MultiResolution::Implementation::renderLevels(EffectPasses& passes) {
  for (std::size_t i = plan.levels.size(); i-- > 0;) {
    LevelTargets& targets = passes.effect.targets(plan.levels[i].index);
    targets.params().bind(kLevelBlock);
    if (isCoarsest(i)) {
      drawEffect(passes, i);
      passes.composite.drawAlone(context, targets);
    } else {
      const ZoneInputs inputs = zoneOf(passes.effect, i);
      shared->zones.draw(context, plan.levels[i], inputs);
      passes.composite.drawOutsideZone(context, targets, inputs, shared->zones.zone(plan.levels[i].index));
      drawEffect(passes, i);
      passes.composite.drawZone(context, targets, inputs);
    }
  }
}

void MultiResolution::Implementation::drawZones(EffectPass& effect) {
  for (std::size_t i = 0; !isCoarsest(i); ++i) {
    effect.targets(plan.levels[i].index).params().bind(kLevelBlock);
    shared->zones.draw(context, plan.levels[i], zoneOf(effect, i));
  }
}

void MultiResolution::Implementation::startDisjointLevel(EffectPass& effect, std::size_t planned) {
  const LevelTargets& targets = effect.targets(plan.levels[planned].index);
  if (isCoarsest(planned)) {
    shared->disjoint.startCoarsest(targets);
  } else {
    const int coarser = plan.levels[planned + 1].index;
    shared->disjoint.drawOutsideZone(context, targets, shared->zones.zone(plan.levels[planned].index),
                                     effect.targets(coarser).composed().color(), coarser);
  }
  if (planned == 0) return;
  const int finer = plan.levels[planned - 1].index;
  shared->disjoint.takeFiner(context, targets, shared->zones.zone(finer), finer);
}

// All zones first: a level leaves out what the finer ones render.
void MultiResolution::Implementation::renderDisjointLevels(EffectPasses& passes) {
  drawZones(passes.effect);
  for (std::size_t i = plan.levels.size(); i-- > 0;) {
    LevelTargets& targets = passes.effect.targets(plan.levels[i].index);
    targets.params().bind(kLevelBlock);
    startDisjointLevel(passes.effect, i);
    drawEffect(passes, i);
    passes.composite.drawAlone(context, targets);
  }
}

void MultiResolution::Implementation::drawEffect(EffectPasses& passes, std::size_t planned) {
  const PlannedLevel& level = plan.levels[planned];
  if (passes.effect.effect().readsPyramid) {
    gl::bindTexture(kSourceUnit, shared->pyramid.texture().id(), context.nearestMip);
  }
  if (measureCoverage) passes.coverage.begin(level);
  passes.effect.draw(context, level.index, roleOf(planned) != LevelRole::coarsest);
  if (measureCoverage) passes.coverage.end();
}

void MultiResolution::Implementation::fillReport(EffectPasses& passes) {
  report.technique = plan.levels.size() > 1 ? Technique::multiResolution : Technique::full;
  report.levels.clear();
  for (const PlannedLevel& level : plan.levels) {
    report.levels.push_back({level.index, level.size, passes.coverage.of(level.index)});
  }
  report.skipped.assign(plan.skipped.begin(), plan.skipped.end());
  report.stages = context.profiler.stages();
  report.bytes = passes.effect.bytes() + passes.preview.bytes() + shared->pyramid.bytes() +
                 shared->edges.bytes() + shared->minMax.bytes() + shared->importance.bytes() +
                 shared->masks.bytes() + shared->zones.bytes();
}

GLuint MultiResolution::Implementation::debugView(DebugView view) {
  if (!hasPicture) throw std::logic_error("A debug view shows the last render(); call render() first.");
  const gl::StateGuard guard(viewports);
  if (!debugViewPass) debugViewPass.emplace(context.library);
  const glm::ivec2 size = plan.levels.front().size;
  const bool levels = view == DebugView::levels;
  if (levels) return debugViewPass->drawLevels(context, shared->zones, plan).id();
  return debugViewPass->drawEdges(context, edges, size).id();
}

void MultiResolution::Implementation::reloadShaders() {
  // Everything is compiled before anything is replaced.
  SharedPasses newShared(context.library);
  DebugViewPass newDebugView(context.library);
  std::vector<EffectPrograms> newEffects;
  for (const auto& [name, passes] : effects) {
    const EffectDescription& description = passes.effect.effect();
    newEffects.push_back({passes.effect.compile(context.library), PreviewPass(context.library, description),
                          CompositePass(context.library, description)});
  }

  shared.emplace(std::move(newShared));
  debugViewPass.emplace(std::move(newDebugView));
  auto replacement = newEffects.begin();
  for (auto& [name, passes] : effects) {
    passes.effect.setProgram(std::move(replacement->effect));
    passes.preview = std::move(replacement->preview);
    passes.composite = std::move(replacement->composite);
    ++replacement;
  }
  hasPicture = false;  // there are no masks to show
}

MultiResolution::MultiResolution(const Options& options) {
  const gl::StateGuard guard(gl::StateGuard::countViewports());
  implementation_ = std::make_unique<Implementation>(options);
}
MultiResolution::~MultiResolution() = default;
MultiResolution::MultiResolution(MultiResolution&&) noexcept = default;
MultiResolution& MultiResolution::operator=(MultiResolution&&) noexcept = default;

Settings& MultiResolution::settings() {
  return implementation_->settings;
}

GLuint MultiResolution::render(Effect& effect, const Frame& frame) {
  return implementation_->render(effect, frame);
}

const Report& MultiResolution::report() const {
  return implementation_->report;
}

GLuint MultiResolution::debugView(DebugView view) {
  return implementation_->debugView(view);
}

void MultiResolution::setProfiling(gl::Profiler::Mode mode) {
  implementation_->context.profiler.setMode(mode);
}

void MultiResolution::reloadShaders() {
  const gl::StateGuard guard(implementation_->viewports);
  implementation_->reloadShaders();
}

void MultiResolution::forget(std::string_view effectName) {
  const auto found = implementation_->effects.find(effectName);
  if (found != implementation_->effects.end()) implementation_->effects.erase(found);
}

void MultiResolution::fillTargets(float value) {
  const gl::StateGuard guard(implementation_->viewports);
  implementation_->shared->fill(value);
  for (const auto& [name, passes] : implementation_->effects) passes.effect.fillTargets(value);
}

}  // namespace mres
