#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>

#include "host/commands/bench_page.h"
#include "host/commands/bench_plots.h"
#include "host/commands/bench_results.h"
#include "host/commands/bench_suite.h"
#include "host/commands/commands.h"
#include "host/commands/interruption.h"
#include "host/commands/memory_need.h"
#include "host/commands/options.h"
#include "host/commands/output.h"
#include "host/commands/progress.h"
#include "host/measure/comparison.h"
#include "host/measure/picture_files.h"
#include "host/platform/gl_context.h"

namespace host {
namespace fs = std::filesystem;
namespace {

struct BenchOptions {
  std::string suite = suiteNames().front();
  TimingOptions timing;
  std::optional<fs::path> output;
  bool resume = false;
  bool json = false;
};

constexpr const char* kExamples = R"(
Examples:
  mres bench --suite quick -o out            about three minutes on two cores without a GPU
  mres bench --suite quick -o out --resume   goes on after an interruption

The folder gets results.json (after every measurement), plots/ as SVG where gnuplot is installed, pictures/, and
report.html, which shows them all.)";

// A campaign is many cases: each gets less time than a comparison of its own.
constexpr int kMinPairs = 3;
constexpr double kMaxSecondsPerCase = 6.0;

PictureSettings settingsOf(const BenchCase& benchCase) {
  PictureSettings settings;
  settings.ssao.samples = benchCase.samples;
  return settings;
}

/// Scenes are kept from one case to the next, since the cases of a scene follow each other.
class SceneCache {
 public:
  const Scene& get(const std::string& name) {
    if (name_ != name) {
      scene_ = loadScene(name);
      name_ = name;
    }
    return scene_;
  }

 private:
  std::string name_;
  Scene scene_;
};

class Campaign {
 public:
  Campaign(const BenchOptions& options, const fs::path& output, const GlContext::Info& gl)
      : options_(options),
        output_(output),
        gl_(gl),
        cases_(suiteCases(options.suite)),
        results_(output / "results.json", machineOf(gl.renderer, gl.version), options.resume) {}

  const Json& run() {
    for (done_ = 0; done_ < cases_.size(); ++done_) measureOnce(cases_[done_]);
    progress_.clear();
    return results_.report();
  }

 private:
  void measureOnce(const BenchCase& benchCase) {
    show(0.0, benchCase, "loading");
    const Scene& scene = scenes_.get(benchCase.scene);
    PictureSettings settings = settingsOf(benchCase);
    Measurement wanted = describePicture(scene, settings, benchCase.camera, benchCase.size);
    wanted.settings = settingsTable(settings).values();
    if (results_.contains(wanted, options_.timing.timing)) return;

    requireMemory(bytesOfComparison(benchCase.size), physicalMemory());
    Comparison comparison(scene, settings, gl_.software);
    Measurement measurement = comparison.measure(
        {benchCase.camera, benchCase.size, options_.timing.plan()},
        [&](double share, const std::string& what) { show(0.95 * share, benchCase, what); });
    measurement.settings = wanted.settings;
    if (benchCase.pictures) measurement.pictures = writeCasePictures(benchCase, comparison);
    results_.add(measurement);
  }

  Json writeCasePictures(const BenchCase& benchCase, Comparison& comparison) {
    show(0.95, benchCase, "writing pictures");
    const fs::path folder = fs::path("pictures") / fmt::format("{}-{}", benchCase.scene, benchCase.camera);
    const OutputDirectory directory(output_ / folder);
    return picturesBelow(folder, writePictures(comparison.pictures(), directory.path()));
  }

  void show(double shareOfCase, const BenchCase& benchCase, const std::string& what) {
    throwIfInterrupted();
    progress_.update((static_cast<double>(done_) + shareOfCase) / static_cast<double>(cases_.size()),
                     fmt::format("{}: {}", nameOf(benchCase), what));
  }

  const BenchOptions& options_;
  fs::path output_;
  const GlContext::Info& gl_;
  std::vector<BenchCase> cases_;
  BenchResults results_;
  SceneCache scenes_;
  StderrProgressBar progress_;
  std::size_t done_ = 0;
};

void runBench(const BenchOptions& options) {
  suiteCases(options.suite);  // an unknown name is found before a folder is made
  const OutputDirectory output(options.output.value_or("bench-" + options.suite));
  const GlContext context;
  Campaign campaign(options, output.path(), context.info());
  const Json& report = campaign.run();

  const auto plots = drawPlots(report, output.path());
  if (!plots)
    fmt::print(stderr, "mres: No plots were drawn; install gnuplot (apt-get install gnuplot-nox).\n");
  writeTextFile(output.path() / "report.html", makePage(report, plots.value_or(std::vector<fs::path>())));
  if (options.json)
    fmt::print("{}", toText(report));
  else
    fmt::print("{}\nresults.json and report.html are in {}\n", toTable(report),
               fs::weakly_canonical(output.path()).string());
}

}  // namespace

void addBenchCommand(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("bench", "Measure a whole suite of pictures, with plots and a report");
  const auto options = std::make_shared<BenchOptions>();
  options->timing.repeat.minPairs = kMinPairs;
  options->timing.repeat.maxSeconds = kMaxSecondsPerCase;
  command->add_option("--suite", options->suite, fmt::format("{} (the default)", suiteNames().front()))
      ->type_name("NAME");
  command
      ->add_option_function<std::string>(
          "-o,--output", [options](const std::string& folder) { options->output = folder; },
          "where everything goes (default bench-NAME)")
      ->type_name("DIR");
  command->add_flag("--resume", options->resume, "keep what results.json in that folder already holds");
  command->add_flag("--json", options->json, "print the report as JSON on the standard output");
  addTimingOptions(*command, options->timing, "the speedup");
  command->footer(kExamples);
  command->callback([&action, options] { action = [options] { runBench(*options); }; });
}

}  // namespace host
