#include "mres/multi_resolution.h"

#include <array>
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
#include "mres/plan/frame_cost.h"
#include "mres/render/calibration.h"
#include "mres/render/draw_levels.h"
#include "mres/render/draw_masks.h"
#include "mres/validate.h"

namespace mres {
namespace {

double pixelCount(glm::ivec2 size) {
  return static_cast<double>(size.x) * size.y;
}

bool fallsBack(const Settings& by, const PlanChooser& chooser) {
  return by.technique == Technique::multiResolution && by.plan.fallBack && !chooser.choosesLevels();
}

const char* reasonOf(const Settings& by, const PlanChooser& chooser) {
  if (by.technique != Technique::multiResolution) return "the technique was asked for";
  if (!by.plan.fallBack) return "levels were asked for";
  if (!chooser.costs()) return "levels, as long as costs are not known";
  return chooser.choosesLevels() ? "levels are faster" : "the plain effect is faster";
}

/// A frame whose times come later.
struct TimedFrame {
  std::uint64_t number = 0;
  EffectPasses* passes = nullptr;  ///< null: nothing is to be learnt from it
  PerLevel<PlannedLevel> levels;
};

/// Costs::work of a frame; none while coverage is not known.
std::optional<double> workOf(EffectPasses& passes, const PerLevel<PlannedLevel>& levels) {
  double pixels = 0.0;
  for (const PlannedLevel& level : levels) {
    if (!passes.coverage.isKnown(level.index)) return std::nullopt;
    pixels += passes.coverage.of(level.index) * pixelCount(level.size);
  }
  return pixels / pixelCount(levels.front().size);
}

}  // namespace

struct MultiResolution::Implementation {
  explicit Implementation(const Options& options) : measureCoverage(options.measureCoverage) {
    context.profiler = gl::Profiler(options.profiling);
    context.library.add(embeddedShaders());
    context.library.setDirectory(options.shaderDirectory);
    shared.emplace(context.library);
  }

  GLuint render(Effect& effect, const Frame& frame, const Settings& by, bool measuringCoverage);
  std::optional<Costs> calibrate(Effect& effect, const Frame& frame);
  GLuint debugView(DebugView view);
  void reloadShaders();
  void bindEffect(Effect& effect, const Frame& frame);
  EffectPasses& passesOf(Effect& effect);
  void bindFrame(const Frame& frame, params::FrameParams& params);
  void draw(const PlannedFrame& planned, Effect& effect, const Frame& frame,
            const params::FrameParams& params);
  void learn();
  void fillReport(EffectPasses& passes, const Settings& by, const std::optional<Constant>& constant);

  Settings settings;
  bool measureCoverage;
  GLuint viewports = gl::StateGuard::countViewports();
  PassContext context;
  gl::UniformBuffer<params::FrameParams> frameBlock;
  std::optional<SharedPasses> shared;
  std::map<std::string, EffectPasses, std::less<>> effects;
  std::optional<DebugViewPass> debugViewPass;
  LevelPlan plan;
  std::uint64_t frames = 0;               // rendered
  std::array<TimedFrame, 8> timedFrames;  // the last, by number: more than may be under way
  EdgeImages edges;                       // of the last frame
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

void MultiResolution::Implementation::draw(const PlannedFrame& planned, Effect& effect, const Frame& frame,
                                           const params::FrameParams& params) {
  planned.prepareLevels();
  constexpr const char* kShared = "another effect of the frame has made it";
  if (effect.description().readsPyramid && !shared->pyramid.draw(context, frame))
    plan.skipped.push_back({"depth", kShared});
  bindEffect(effect, frame);
  if (planned.hasMasks()) edges = drawMasks(planned, frame, params);
  if (edges.areShared) plan.skipped.push_back({"edges", kShared});
  drawLevels(planned);
}

GLuint MultiResolution::Implementation::render(Effect& effect, const Frame& frame, const Settings& by,
                                               bool measuringCoverage) {
  params::FrameParams params = frameParams(frame);
  validate("MaskSettings", by.mask);
  validate(effect.levels());
  const gl::StateGuard guard(viewports);
  bindFrame(frame, params);
  context.profiler.beginFrame(++frames);
  EffectPasses& passes = passesOf(effect);
  pictured = nullptr;
  const std::optional<Constant> constant = effect.constant();
  plan = constant ? planConstant(frame.size, constant->reason)
                  : planLevels(by.technique, effect.levels(), frame.size, fallsBack(by, passes.chooser));
  const bool teaches = by.technique == Technique::multiResolution && !constant && measuringCoverage;
  timedFrames.at(frames % timedFrames.size()) = {frames, teaches ? &passes : nullptr, plan.levels};
  const PlannedFrame planned{context, by, plan, *shared, passes, measuringCoverage};
  edges = {};
  if (constant)
    planned.targets(0).fillAlone(effect.description(), frame.size, constant->value);
  else
    draw(planned, effect, frame, params);
  context.profiler.endFrame();
  fillReport(passes, by, constant);
  learn();
  report.bytes += effect.bytes();
  pictured = &passes;
  return planned.targets(0).composed().color().id();
}

/// From the frame whose times are known by now, perhaps that of another effect.
void MultiResolution::Implementation::learn() {
  const std::uint64_t number = context.profiler.stagesFrame();
  TimedFrame& timed = timedFrames.at(number % timedFrames.size());
  if (context.profiler.mode() != gl::Profiler::Mode::query || timed.number != number ||
      timed.passes == nullptr)
    return;
  if (const std::optional<double> work = workOf(*timed.passes, timed.levels))
    timed.passes->chooser.observe(frameCost(context.profiler.stages()), *work,
                                  pixelCount(timed.levels.front().size));
  timed.passes = nullptr;  // once
}

std::optional<Costs> MultiResolution::Implementation::calibrate(Effect& effect, const Frame& frame) {
  const auto passes = [&]() -> EffectPasses& { return effects.find(effect.description().name)->second; };
  Settings by = settings;
  by.plan.fallBack = false;
  Frame alone = frame;
  alone.id = 0;  // or all but the first would be given what that one made
  const auto renderBy = [&](Technique technique, bool counting) {
    by.technique = technique;
    render(effect, alone, by, counting);
  };
  renderBy(Technique::multiResolution, true);
  std::optional<Costs> costs;
  if (!effect.constant())
    costs = measureCosts({.profiler = context.profiler,
                          .render = renderBy,
                          .work = [&] { return workOf(passes(), plan.levels).value_or(1.0); },
                          .pixels = pixelCount(frame.size)});
  passes().chooser.setCosts(costs);
  return costs;
}

void MultiResolution::Implementation::fillReport(EffectPasses& passes, const Settings& by,
                                                 const std::optional<Constant>& constant) {
  report.technique = plan.levels.size() > 1 ? by.technique : Technique::full;
  report.plan = constant ? PlanReport{false, constant->reason, std::nullopt}
                         : PlanReport{fallsBack(by, passes.chooser), reasonOf(by, passes.chooser),
                                      passes.chooser.costs()};
  report.levels.clear();
  for (const PlannedLevel& level : plan.levels) {
    report.levels.push_back({level.index, level.size, constant ? 0.0 : passes.coverage.of(level.index)});
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
  return implementation_->render(effect, frame, implementation_->settings, implementation_->measureCoverage);
}

std::optional<Costs> MultiResolution::calibrate(Effect& effect, const Frame& frame) {
  return implementation_->calibrate(effect, frame);
}

void MultiResolution::setCosts(Effect& effect, const std::optional<Costs>& costs) {
  const gl::StateGuard guard(implementation_->viewports);
  implementation_->passesOf(effect).chooser.setCosts(costs);
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
  for (TimedFrame& timed : implementation_->timedFrames)
    if (timed.passes == &found->second) timed.passes = nullptr;
  implementation_->effects.erase(found);
}

void MultiResolution::fillTargets(float value) {
  const gl::StateGuard guard(implementation_->viewports);
  implementation_->shared->fill(value);
  for (const auto& [name, passes] : implementation_->effects) passes.fill(value);
}

}  // namespace mres
