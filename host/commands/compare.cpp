#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <optional>

#include "host/commands/commands.h"
#include "host/console/interruption.h"
#include "host/console/memory_need.h"
#include "host/console/notes.h"
#include "host/console/options.h"
#include "host/console/output.h"
#include "host/console/parse.h"
#include "host/console/progress.h"
#include "host/console/stopwatch.h"
#include "host/console/usage_error.h"
#include "host/measure/comparison.h"
#include "host/measure/picture_files.h"
#include "host/measure/report.h"
#include "host/measure/report_table.h"
#include "host/platform/gl_context.h"

namespace host {
namespace fs = std::filesystem;
namespace {

struct CompareOptions {
  ViewOptions view;
  PictureOptions picture;
  TimingOptions timing;
  bool truth = false;
  std::optional<CameraPath> path;
  fs::path output;
};

constexpr const char* kExamples = R"(
Examples:
  mres compare hall --size 4k -o out                    a picture and a number
  mres compare hall --camera all --no-timing -o out     pictures and errors of every camera
  mres compare hall --truth --no-timing -o out          what the reference itself is worth
  mres compare hall --frames 8 --no-timing -o out       how much the technique flickers as the camera moves
  mres compare hall --technique half-joint -o out       what half of the resolution gives instead
  mres compare room.glb --samples 16 --set radius=0.8 --json -o out

The folder gets full.png and mres.png (lit), effect_full and effect_mres (.png, and .exr with the exact values),
difference.png (8 times enhanced), edges.png (red normals, green depth, blue edges of the effect itself such as those
of shadows), levels.png (red full, green half, blue quarter, black eighth resolution) and report.json; with --camera all
the pictures lie in a folder for each camera. edges.png and levels.png are of mres's own techniques.)";

/// Where the pictures of a camera go, relative to the output.
fs::path pictureFolder(std::size_t cameras, int camera) {
  return cameras == 1 ? fs::path() : fs::path(fmt::format("camera-{}", camera));
}

class CompareRun {
 public:
  CompareRun(const CompareOptions& options, const Scene& scene, const GlContext::Info& gl,
             ProgressBar& progress)
      : options_(options),
        progress_(progress),
        cameras_(camerasOf(scene, options.view.camera)),
        settings_(options.picture.settings),
        comparison_(scene, settings_, gl.software),
        report_(makeReport(machineOf(gl.renderer, gl.version))) {}

  const Json& run() {
    progress_.clear();
    writeNotes(std::cerr, comparison_.warnings());
    for (done_ = 0; done_ < cameras_.size(); ++done_) {
      compareCamera(cameras_[done_]);
      // After each, so that what an interruption leaves is described.
      writeTextFile(options_.output / "report.json", toText(report_));
    }
    progress_.clear();
    return report_;
  }

 private:
  void compareCamera(int camera) {
    const Stopwatch stopwatch;
    Measurement measurement = comparison_.measure(
        {camera, options_.view.size, options_.timing.plan(), options_.truth, options_.path},
        [&](double share, const std::string& what) {
          show(0.9 * share, fmt::format("camera {}: {}", camera, what));
        });
    measurement.settings = valuesOf(settings_);
    const fs::path folder = pictureFolder(cameras_.size(), camera);
    const OutputDirectory directory(options_.output / folder);
    measurement.pictures = picturesBelow(
        folder, writePictures(comparison_.pictures(), directory.path(), [&](const std::string& name) {
          show(0.95, fmt::format("camera {}: writing {}", camera, name));
        }));
    measurement.seconds = stopwatch.elapsed().count();
    report_["results"].push_back(toJson(measurement));
  }

  void show(double shareOfCamera, const std::string& what) {
    throwIfInterrupted();
    progress_.update((static_cast<double>(done_) + shareOfCamera) / static_cast<double>(cameras_.size()),
                     what);
  }

  const CompareOptions& options_;
  ProgressBar& progress_;
  std::vector<int> cameras_;
  PictureSettings settings_;
  Comparison comparison_;
  Json report_;
  std::size_t done_ = 0;
};

void runCompare(const CompareOptions& options) {
  if (options.picture.settings.effect == kNoEffect)
    throw UsageError("Without an effect there is nothing to compare; give --effect ssao.");
  const PictureNeed need = needOf(options.picture.settings, options.view.size);
  requireMemory(options.truth ? bytesOfComparisonWithTruth(need) : bytesOfComparison(need), availableMemory(),
                "give a smaller --size");
  const OutputDirectory output(options.output);
  StderrProgressBar progress;
  const GlContext context;
  progress.update(0.0, "loading " + options.view.scene);
  const Scene scene = loadScene(options.view.scene);
  throwIfInterrupted();
  progress.update(0.0, "preparing " + scene.name);
  CompareRun run(options, scene, context.info(), progress);
  const Json& report = run.run();
  if (options.picture.json)
    fmt::print("{}", toText(report));
  else
    fmt::print("{}{}{}\nPictures and report.json are in {}\n", toTable(report), toTruthTable(report),
               toTemporalTable(report), fs::weakly_canonical(output.path()).string());
}

void addPathOption(CLI::App& command, std::optional<CameraPath>& path) {
  constexpr int kMostFrames = 100;
  command
      .add_option_function<std::string>(
          "--frames",
          [&path](const std::string& text) { path = {.frames = parseCount(text, "frames", 2, kMostFrames)}; },
          fmt::format(
              "also measure flicker: move the camera slowly, forward and turning, for N frames, 2 to {}, "
              "and take the change of the error from frame to frame; {} will do",
              kMostFrames, CameraPath().frames))
      ->type_name("N");
}

}  // namespace

void addCompareCommand(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "compare", "Measure speed and error of a technique against the full resolution, with pictures");
  const auto options = std::make_shared<CompareOptions>();
  addViewOptions(*command, options->view);
  addPictureOptions(*command, options->picture);
  addTimingOptions(*command, options->timing, "the speedup");
  command->add_flag(
      "--truth", options->truth,
      "also measure technique and reference against the effect with 4096 samples or more and, for ambient "
      "occlusion and shadows, against ray tracing");
  addPathOption(*command, options->path);
  command->add_option("-o,--output", options->output, "where pictures and report.json go")
      ->required()
      ->type_name("DIR");
  command->footer(kExamples + describeChoices());
  command->callback([&action, options] { action = [options] { runCompare(*options); }; });
}

}  // namespace host
