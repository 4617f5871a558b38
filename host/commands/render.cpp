#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>

#include "host/commands/commands.h"
#include "host/console/interruption.h"
#include "host/console/memory_need.h"
#include "host/console/notes.h"
#include "host/console/options.h"
#include "host/console/output.h"
#include "host/console/progress.h"
#include "host/console/stopwatch.h"
#include "host/console/usage_error.h"
#include "host/measure/effect_instance.h"
#include "host/measure/gl_timer.h"
#include "host/measure/report.h"
#include "host/platform/gl_context.h"

namespace host {
namespace {

struct RenderOptions {
  ViewOptions view;
  PictureOptions picture;
  TimingOptions timing;
  std::filesystem::path output;

  [[nodiscard]] bool hasEffect() const { return picture.settings.effect != kNoEffect; }
  [[nodiscard]] bool isTimed() const {
    return hasEffect() && timing.timing && (picture.json || timing.repeat.pairs.has_value());
  }
};

constexpr const char* kExamples = R"(
Examples:
  mres render office --camera 3 --size 1080p -o office.png
  mres render model.glb --technique full --samples 128 -o model.exr
  mres render hall --repeat 9 -o hall.png              the effect timed alone, nine times
  mres render hall --json --no-timing -o hall.png      a report without times

.png pictures are tone mapped, .exr pictures hold linear radiance. The effect is timed where --json or --repeat asks
for it.)";

void requireRenderable(const RenderOptions& options) {
  if (!imageFormatOf(options.output))
    throw UsageError(fmt::format("'{}' is no picture that mres can write; end its name with .png or .exr.",
                                 options.output.string()));
  if (!options.view.camera)
    throw UsageError(
        "One picture needs one camera; give --camera a number, or use mres compare for all of them.");
  if (!options.hasEffect() && options.timing.repeat.pairs)
    throw UsageError("Without an effect there is nothing to time; leave out --repeat.");
  requireMemory(bytesOfRender(needOf(options.picture.settings, options.view.size)), availableMemory(),
                "give a smaller --size");
  requireWritableFile(options.output);
}

/// Draws the scene's geometry and the effect; lights the one with the other.
class PictureMaker {
 public:
  PictureMaker(const RenderOptions& options, const Scene& scene, bool softwareRasterizer,
               ProgressBar& progress)
      : options_(options),
        scene_(scene),
        progress_(progress),
        renderer_(scene, profiler_, rendererSettings(options.picture.settings)),
        softwareRasterizer_(softwareRasterizer) {
    const GBufferTextures& gbuffer =
        renderer_.drawGeometry(scene.cameras.at(*options.view.camera), options.view.size);
    frame_ = frameOf(renderer_, gbuffer, options.view.size);
    inputs_ = drawInputs(renderer_, options.picture.settings);
    if (options.hasEffect()) effect_ = makeInstance(EffectInstance::Coverage::unmeasured);
  }

  [[nodiscard]] std::vector<std::string> warnings() const { return warningsOf(scene_, renderer_); }

  Measurement measure() {
    PictureSettings settings = options_.picture.settings;
    Measurement measurement = describePicture(scene_, settings, *options_.view.camera, options_.view.size);
    measurement.settings = valuesOf(settings);
    measurement.pictures["picture"] = options_.output.string();
    measurement.warnings = warnings();
    if (options_.isTimed()) measurement.times.emplace().technique = timeEffect();
    if (options_.hasEffect() && options_.picture.json) look(measurement);
    return measurement;
  }

  FloatImage picture() {
    show(kShareOfTiming, "drawing the picture");
    if (effect_ && effectTexture_ == 0) renderEffect();
    const GLuint radiance = renderer_.drawLighting(screenEffects(options_.picture.settings, effectTexture_));
    const bool isLinear = imageFormatOf(options_.output) == ImageFormat::exr;
    return readTexture(isLinear ? radiance : renderer_.drawToneMap(), frame_.size, 3);
  }

 private:
  static constexpr double kShareOfTiming = 0.9;  // of the whole work, about

  [[nodiscard]] std::unique_ptr<EffectInstance> makeInstance(EffectInstance::Coverage coverage) const {
    const PictureSettings& settings = options_.picture.settings;
    auto instance = std::make_unique<EffectInstance>(settings, settings.technique, coverage);
    instance->setInputs(inputs_);
    return instance;
  }

  void renderEffect() { effectTexture_ = effect_->render(frame_); }

  std::vector<RunTime> timeEffect() {
    costs_ = effect_->calibrate(frame_);
    const GlTimer timer(softwareRasterizer_);
    return timeAlone(
        [this] { renderEffect(); }, [&timer](const Work& work) { return timer(work); },
        options_.timing.repeat,
        [this](int run, int expected) {
          show(kShareOfTiming * run / expected,
               run == 0 ? "warming up" : fmt::format("timed run {} of at most {}", run, expected));
        });
  }

  /// By an instance of its own, since measuring coverage would slow down what is timed.
  void look(Measurement& measurement) {
    show(kShareOfTiming, "looking at each stage");
    const auto inspected = makeInstance(EffectInstance::Coverage::measured);
    inspected->setCosts(costs_);
    inspect(*inspected, frame_, options_.isTimed() ? stageClockOf(softwareRasterizer_) : StageClock::off,
            measurement);
  }

  void show(double share, const std::string& what) {
    throwIfInterrupted();
    progress_.update(share, what);
  }

  const RenderOptions& options_;
  const Scene& scene_;
  ProgressBar& progress_;
  mres::gl::Profiler profiler_;
  Renderer renderer_;
  bool softwareRasterizer_;
  mres::Frame frame_;
  EffectInputs inputs_;
  std::unique_ptr<EffectInstance> effect_;
  std::optional<mres::Costs> costs_;
  GLuint effectTexture_ = 0;  // of the last renderEffect(); none lights without it
};

/// "ssao by mres: 12.3 ms, the median of 7 runs from 12.1 to 12.9 ms (glFinish+steady_clock)".
std::string timesLine(const Json& result) {
  const Json& time = result["time_ms"];
  return fmt::format("{} by {}: {:.1f} ms, the median of {} runs from {:.1f} to {:.1f} ms ({})\n",
                     result["effect"].get<std::string>(), result["technique"].get<std::string>(),
                     time["median"].get<double>(), time["runs"].get<int>(), time["min"].get<double>(),
                     time["max"].get<double>(), result["clock"].get<std::string>());
}

std::string textOf(const RenderOptions& options, const GlContext::Info& gl, const Measurement& measurement) {
  const Json result = toJson(measurement);
  if (!options.picture.json)
    return options.output.string() + "\n" + (options.isTimed() ? timesLine(result) : "");
  Json report = makeReport(machineOf(gl.renderer, gl.version));
  report["results"].push_back(result);
  return toText(report);
}

void runRender(const RenderOptions& options) {
  const Stopwatch stopwatch;
  requireRenderable(options);
  StderrProgressBar progress;
  const GlContext context;
  progress.update(0.0, "loading " + options.view.scene);
  const Scene scene = loadScene(options.view.scene);
  requireCamera(scene, *options.view.camera);
  throwIfInterrupted();

  progress.update(0.0, "preparing " + scene.name);
  PictureMaker maker(options, scene, context.info().software, progress);
  progress.clear();
  writeNotes(std::cerr, maker.warnings());
  Measurement measurement = maker.measure();
  const FloatImage picture = maker.picture();
  throwIfInterrupted();
  writeImage(options.output, picture);
  measurement.seconds = stopwatch.elapsed().count();
  progress.clear();
  fmt::print("{}", textOf(options, context.info(), measurement));
}

}  // namespace

void addRenderCommand(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("render", "Render one picture");
  const auto options = std::make_shared<RenderOptions>();
  addViewOptions(*command, options->view);
  addPictureOptions(*command, options->picture);
  addTimingOptions(*command, options->timing, "the median");
  command->add_option("-o,--output", options->output, "the picture, .png or .exr")
      ->required()
      ->type_name("FILE");
  command->footer(kExamples + describeChoices());
  command->callback([&action, options] { action = [options] { runRender(*options); }; });
}

}  // namespace host
