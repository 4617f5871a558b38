#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host/commands/bench_campaign.h"
#include "host/commands/bench_cost.h"
#include "host/commands/bench_page.h"
#include "host/commands/bench_plots.h"
#include "host/commands/bench_scenes.h"
#include "host/commands/bench_suite.h"
#include "host/commands/bench_summary.h"
#include "host/commands/bench_truth_summary.h"
#include "host/commands/commands.h"
#include "host/commands/options.h"
#include "host/commands/output.h"
#include "host/commands/usage_error.h"
#include "host/measure/text_table.h"

namespace host {
namespace fs = std::filesystem;
namespace {

struct BenchOptions {
  SuiteRequest suite{suiteNames().front()};
  std::vector<fs::path> scenes;
  TimingOptions timing;
  std::optional<fs::path> output;
  bool resume = false;
  bool json = false;

  [[nodiscard]] CampaignTiming campaignTiming() const { return {timing.timing, timing.repeat.pairs}; }
};

constexpr const char* kExamples = R"(
Examples:
  mres bench -o out                          about three minutes on two cores without a GPU
  mres bench --suite paper -o out            the evaluation of the paper, at most 100 minutes on two cores, and at 1920x1080
                                             the errors against thousands of samples and ray tracing
  mres bench --suite paper -o out --resume   goes on after an interruption
  mres bench --scenes models -o out          the same of your own scenes, up to eight cameras of each

The folder gets results.json (after every measurement), plots/ as SVG where gnuplot is installed, pictures/, and
report.html, which shows them all.)";

/// A folder name for every suite.
fs::path outputOf(const BenchOptions& options) {
  return options.output.value_or("bench-" + options.suite.suite);
}

std::vector<BenchCase> casesOf(const BenchOptions& options) {
  SuiteRequest request = options.suite;
  if (request.thorough && request.suite != kPaperSuite)
    throw UsageError(fmt::format("Only the suite {0} can be thorough; give --suite {0}.", kPaperSuite));
  suiteCases(request);  // an unknown name is told before a folder is searched
  request.scenes = findScenes(options.scenes);
  return suiteCases(request);
}

/// Plots and page, of what was measured.
void writeReport(const Json& report, const fs::path& folder) {
  const auto plots = drawPlots(report, folder);
  if (!plots)
    fmt::print(stderr, "mres: No plots were drawn; install gnuplot (apt-get install gnuplot-nox).\n");
  writeTextFile(folder / "report.html", makePage(report, plots.value_or(std::vector<fs::path>()), folder));
}

/// With a sentence of what it tells; nothing without truths.
std::string truthSummary(const Json& report) {
  const auto rows = truthSummaryRows(report);
  return rows.empty() ? "" : fmt::format("\n{}\n\n{}", kTruthSummaryMeaning, formatTable(rows));
}

void runBench(const BenchOptions& options) {
  std::vector<BenchCase> cases = casesOf(options);
  const OutputDirectory output(outputOf(options));
  const GlContext context;
  Campaign campaign({std::move(cases), options.campaignTiming(), output.path(), options.resume},
                    context.info());
  const Json& report = campaign.run();
  writeReport(report, output.path());
  if (options.json)
    fmt::print("{}", toText(report));
  else
    fmt::print("{}\n{}{}\nresults.json and report.html are in {}\n", toTable(report),
               formatTable(summaryRows(report)), truthSummary(report),
               fs::weakly_canonical(output.path()).string());
  if (const std::size_t count = campaign.scenesLeftOut(); count > 0)
    throw std::runtime_error(fmt::format("{} of the scenes could not be loaded.", count));
}

}  // namespace

void addBenchCommand(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("bench", "Measure a whole suite of pictures, with plots and a report");
  const auto options = std::make_shared<BenchOptions>();
  options->timing.repeat = planOf({});  // of the fastest pictures
  command
      ->add_option("--suite", options->suite.suite,
                   fmt::format("{} (default {})", fmt::join(suiteNames(), " or "), suiteNames().front()))
      ->type_name("NAME");
  command
      ->add_option("--scenes", options->scenes,
                   "instead of the built-in scenes: .gltf and .glb files, and folders of them")
      ->type_name("DIR|FILE...")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--thorough", options->suite.thorough,
                    "with --suite paper: every view with every number of samples, which takes hours");
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
