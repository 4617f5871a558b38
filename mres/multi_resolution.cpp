#include "mres/multi_resolution.h"

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mres/debug/debug_view_pass.h"
#include "mres/embedded_shaders.h"
#include "mres/gl/state_guard.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/level/frame_params.h"
#include "mres/level/frame_textures.h"
#include "mres/render/draw_levels.h"
#include "mres/render/draw_masks.h"
#include "mres/validate.h"

namespace mres {

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
  void bindEffect(Effect& effect, const Frame& frame);
  EffectPasses& passesOf(Effect& effect);
  void bindFrame(const Frame& frame, params::FrameParams& params);
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
  EdgeImages edges;  // of the last frame
  const EffectPasses* pictured =
      nullptr;  // of the last frame, if everything that the plan names was rendered
  Report report;
};

EffectPasses& MultiResolution::Implementation::passesOf(Effect& effect) {
  const EffectDescription& description = effect.description();
  auto found = effects.find(std::string_view(description.name));
  if (found == effects.end()) {
    found = effects.try_emplace(description.name, context.library, description).first;
  }
  found->second.setUp(effect);
  return found->second;
}

void MultiResolution::Implementation::bindFrame(const Frame& frame, params::FrameParams& params) {
  params.depthRounding = depthRounding(bindFrameTextures(context, frame));
  frameBlock.upload(params);
  frameBlock.bind(kFrameBlock);
}

void MultiResolution::Implementation::bindEffect(Effect& effect, const Frame& frame) {
  const gl::Scope scope(context.profiler, "mres.inputs");
  effect.bind(frame);
}

GLuint MultiResolution::Implementation::render(Effect& effect, const Frame& frame) {
  params::FrameParams params = frameParams(frame);
  validate("MaskSettings", settings.mask);
  validate(effect.levels());
  const gl::StateGuard guard(viewports);
  bindFrame(frame, params);
  context.profiler.beginFrame();
  EffectPasses& passes = passesOf(effect);
  pictured = nullptr;
  plan = planLevels(settings.technique, effect.levels(), frame.size);
  const PlannedFrame planned{context, settings, plan, *shared, passes, measureCoverage};
  planned.prepareLevels();
  if (effect.description().readsPyramid) shared->pyramid.draw(context, frame.size);
  bindEffect(effect, frame);
  edges = planned.hasMasks() ? drawMasks(planned, frame, params) : EdgeImages{};
  drawLevels(planned);
  context.profiler.endFrame();
  fillReport(passes);
  report.bytes += effect.bytes();
  pictured = &passes;
  return planned.targets(0).composed().color().id();
}

void MultiResolution::Implementation::fillReport(EffectPasses& passes) {
  report.technique = plan.levels.size() > 1 ? settings.technique : Technique::full;
  report.levels.clear();
  for (const PlannedLevel& level : plan.levels) {
    report.levels.push_back({level.index, level.size, passes.coverage.of(level.index)});
  }
  report.skipped.assign(plan.skipped.begin(), plan.skipped.end());
  report.stages = context.profiler.stages();
  report.bytes = passes.bytes() + shared->bytes();
}

GLuint MultiResolution::Implementation::debugView(DebugView view) {
  if (pictured == nullptr)
    throw std::logic_error("A debug view shows the last render(); call render() first.");
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
  for (const auto& [name, passes] : effects) newEffects.push_back(passes.compile(context.library));

  shared.emplace(std::move(newShared));
  debugViewPass.emplace(std::move(newDebugView));
  auto replacement = newEffects.begin();
  for (auto& [name, passes] : effects) passes.replace(std::move(*replacement++));
  pictured = nullptr;  // there are no masks to show
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
  if (found == implementation_->effects.end()) return;
  if (implementation_->pictured == &found->second) implementation_->pictured = nullptr;
  implementation_->effects.erase(found);
}

void MultiResolution::fillTargets(float value) {
  const gl::StateGuard guard(implementation_->viewports);
  implementation_->shared->fill(value);
  for (const auto& [name, passes] : implementation_->effects) passes.fill(value);
}

}  // namespace mres
