#include <filesystem>
#include <fmt/format.h>
#include <memory>

#include "host/commands/commands.h"
#include "host/commands/interruption.h"
#include "host/commands/options.h"
#include "host/commands/output.h"
#include "host/commands/usage_error.h"
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
};

constexpr const char* kExamples = R"(
Examples:
  mres render office --camera 3 --size 1080p -o office.png
  mres render model.glb --technique full --samples 128 -o model.exr
  mres render hall --repeat 9 --json -o hall.png       the effect timed alone, nine times

.png pictures are tone mapped, .exr pictures hold linear radiance.)";

void requireRenderable(const RenderOptions& options) {
  if (!imageFormatOf(options.output))
    throw UsageError(fmt::format("'{}' is no picture that mres can write; end its name with .png or .exr.",
                                 options.output.string()));
  if (!options.view.camera)
    throw UsageError(
        "One picture needs one camera; give --camera a number, or use mres compare for all of them.");
  requireWritableFile(options.output);
}

/// Draws the scene's geometry and the effect; lights the one with the other.
class PictureMaker {
 public:
  PictureMaker(const RenderOptions& options, const Scene& scene, bool softwareRasterizer)
      : options_(options),
        renderer_(scene, profiler_, options.picture.settings.renderer),
        timer_(softwareRasterizer) {
    const PictureSettings& settings = options.picture.settings;
    const GBufferTextures& gbuffer =
        renderer_.drawGeometry(scene.cameras.at(*options.view.camera), options.view.size);
    frame_ = frameOf(renderer_, gbuffer, options.view.size);
    if (settings.effect != kNoEffect)
      effect_ =
          std::make_unique<EffectInstance>(settings, settings.technique, EffectInstance::Coverage::measured);
  }

  void measure(Measurement& measurement) {
    if (!effect_) return;
    if (options_.timing.repeat)
      measurement.times.emplace().technique =
          timeAlone([this] { effect_->render(frame_); }, [this](const Work& work) { return timer_(work); },
                    *options_.timing.repeat);
    inspect(*effect_, frame_, measurement);
  }

  FloatImage picture() {
    const GLuint radiance = renderer_.drawLighting(effect_ ? effect_->render(frame_) : 0);
    const bool isLinear = imageFormatOf(options_.output) == ImageFormat::exr;
    return readTexture(isLinear ? radiance : renderer_.drawToneMap(), frame_.size, 3);
  }

 private:
  const RenderOptions& options_;
  mres::gl::Profiler profiler_;
  Renderer renderer_;
  GlTimer timer_;
  mres::Frame frame_;
  std::unique_ptr<EffectInstance> effect_;
};

Json makeRenderReport(const RenderOptions& options, const Scene& scene, const Machine& machine,
                      PictureMaker& maker) {
  PictureSettings settings = options.picture.settings;
  Measurement measurement = describePicture(scene, settings, *options.view.camera, options.view.size);
  measurement.settings = settingsTable(settings).values();
  measurement.pictures["picture"] = options.output.string();
  maker.measure(measurement);
  Json report = makeReport(machine);
  report["results"].push_back(toJson(measurement));
  return report;
}

void runRender(const RenderOptions& options) {
  requireRenderable(options);
  const GlContext context;
  const Scene scene = loadScene(options.view.scene);
  requireCamera(scene, *options.view.camera);
  throwIfInterrupted();

  const GlContext::Info& gl = context.info();
  PictureMaker maker(options, scene, gl.software);
  Json report;
  if (options.picture.json)
    report = makeRenderReport(options, scene, machineOf(gl.renderer, gl.version), maker);
  throwIfInterrupted();
  writeImage(options.output, maker.picture());
  fmt::print("{}", options.picture.json ? toText(report) : fmt::format("{}\n", options.output.string()));
}

}  // namespace

void addRenderCommand(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("render", "Render one picture");
  const auto options = std::make_shared<RenderOptions>();
  addViewOptions(*command, options->view);
  addPictureOptions(*command, options->picture);
  addTimingOptions(*command, options->timing);
  command->add_option("-o,--output", options->output, "the picture, .png or .exr")
      ->required()
      ->type_name("FILE");
  command->footer(kExamples + describeSettings());
  command->callback([&action, options] { action = [options] { runRender(*options); }; });
}

}  // namespace host
