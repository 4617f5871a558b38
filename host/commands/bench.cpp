#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "host/bench/campaign.h"
#include "host/bench/cost.h"
#include "host/bench/page.h"
#include "host/bench/pareto_tables.h"
#include "host/bench/plots.h"
#include "host/bench/results.h"
#include "host/bench/scenes.h"
#include "host/bench/suite.h"
#include "host/bench/summary.h"
#include "host/bench/truth_summary.h"
#include "host/commands/commands.h"
#include "host/console/interruption.h"
#include "host/console/options.h"
#include "host/console/output.h"
#include "host/console/usage_error.h"
#include "host/measure/report_table.h"
#include "host/measure/result_names.h"
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
  bool reportOnly = false;
  bool json = false;
};

constexpr const char* kExamples = R"(
Examples:
  mres bench -o out                          about three minutes on two cores without a GPU
  mres bench --suite paper -o out            the evaluation of the paper, at most 110 minutes on two cores, and at 1920x1080
                                             the errors against thousands of samples and ray tracing
  mres bench --suite paper -o out --resume   goes on after an interruption
  mres bench --suite paper --scenes models -o out
                                             the same of your own scenes, up to eight cameras of each
  mres bench --suite pareto -o out           time against error of every technique, in less than an hour
  mres bench -o out --report                 measures nothing, draws what there is

The folder gets results.json (after every measurement), plots/ as SVG where gnuplot is installed, pictures/, and
report.html, which shows them all; of several techniques also pareto.md, tables for documents. An interruption leaves results.json and pictures/ of what was measured: --resume goes
on, --report makes plots and page of it. Results that are there already are kept as results.previous.json.)";

/// A folder name for every suite.
fs::path outputOf(const BenchOptions& options) {
  return options.output.value_or("bench-" + options.suite.suite);
}

fs::path resultsOf(const BenchOptions& options) {
  return outputOf(options) / "results.json";
}

std::vector<BenchCase> casesOf(const BenchOptions& options) {
  SuiteRequest request = options.suite;
  if (request.thorough && request.suite != kPaperSuite && request.suite != kParetoSuite)
    throw UsageError(fmt::format("Only the suites {0} and {1} can be thorough; give --suite {0} or {1}.",
                                 kPaperSuite, kParetoSuite));
  suiteCases(request);  // an unknown name is told before a folder is searched
  request.scenes = findScenes(options.scenes);
  return suiteCases(request);
}

/// As the suite has it, with the pairs that were asked for.
std::optional<RepeatPlan> planOf(const BenchOptions& options) {
  std::optional<RepeatPlan> plan = options.timing.plan();
  if (!plan || options.suite.suite != kParetoSuite) return plan;
  RepeatPlan shorter = paretoPlan();
  shorter.pairs = plan->pairs;
  return shorter;
}

/// Plots and page, of what was measured.
void writeReport(const Json& report, const fs::path& folder) {
  const auto plots = drawPlots(report, folder);
  if (!plots)
    fmt::print(stderr, "mres: No plots were drawn; install gnuplot (apt-get install gnuplot-nox).\n");
  writeTextFile(folder / "report.html", makePage(report, plots.value_or(std::vector<Plot>()), folder));
  if (const std::string rivals = paretoMarkdown(report); !rivals.empty())
    writeTextFile(folder / "pareto.md", rivals);
}

/// With a sentence of what it tells; nothing without truths.
std::string truthSummary(const Json& report) {
  const auto rows = truthSummaryRows(report);
  return rows.empty() ? "" : fmt::format("\n{}\n\n{}", kTruthSummaryMeaning, formatTable(rows));
}

/// Time against error, where several techniques were measured.
std::string rivalsText(const Json& report) {
  std::string text;
  for (const ParetoPlane& plane : paretoPlanes(report))
    text += fmt::format("\n{}\n\n{}\n{}", titleOf(plane), formatTable(paretoRows(plane)),
                        formatTable(paretoRatioRows(plane)));
  return text.empty() ? "" : fmt::format("\n{}\n\n{}\n{}", kParetoMeaning, kParetoRatioMeaning, text);
}

void showReport(const Json& report, const BenchOptions& options) {
  const fs::path folder = outputOf(options);
  writeReport(report, folder);
  if (options.json) {
    fmt::print("{}", toText(report));
    return;
  }
  const std::string duration = durationOf(report);
  const Json own = withoutRivals(report);
  fmt::print("{}\n{}{}{}\n{}results.json and report.html are in {}\n", toTable(report),
             formatTable(summaryRows(own)), truthSummary(own), rivalsText(report),
             duration.empty() ? "" : fmt::format("Measured in {}.\n", duration),
             fs::weakly_canonical(folder).string());
}

void measureAndShow(const BenchOptions& options) {
  std::vector<BenchCase> cases = casesOf(options);
  const OutputDirectory output(outputOf(options));
  const GlContext context;
  Campaign campaign({std::move(cases), planOf(options), output.path(), options.resume}, context.info());
  const Json& report = campaign.run();
  if (report["results"].empty()) throw std::runtime_error("Nothing could be measured.");
  showReport(report, options);
  if (const std::vector<std::string> scenes = campaign.incompleteScenes(); !scenes.empty())
    throw std::runtime_error(fmt::format("Not everything could be measured, for the reasons above, of: {}.",
                                         fmt::join(scenes, ", ")));
}

void runCampaign(const BenchOptions& options) {
  try {
    measureAndShow(options);
  } catch (const Interrupted&) {
    std::error_code ignored;  // results that cannot be looked at are none
    if (fs::exists(resultsOf(options), ignored))
      fmt::print(stderr, "mres: Stopped; --resume goes on, and --report draws what is there.\n");
    throw;
  }
}

void runBench(const BenchOptions& options) {
  if (options.reportOnly)
    showReport(readResults(resultsOf(options)), options);
  else
    runCampaign(options);
}

}  // namespace

void addBenchCommand(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("bench", "Measure a whole suite of pictures, with plots and a report");
  const auto options = std::make_shared<BenchOptions>();
  options->timing.repeat = campaignPlan();
  command
      ->add_option("--suite", options->suite.suite,
                   fmt::format("{} (default {})", fmt::join(suiteNames(), ", "), suiteNames().front()))
      ->type_name("NAME");
  command
      ->add_option("--scenes", options->scenes,
                   "instead of the built-in scenes: .gltf and .glb files, and folders of them")
      ->type_name("DIR|FILE...")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag(
      "--thorough", options->suite.thorough,
      "with --suite paper or pareto: every view with every number of samples or technique, which "
      "takes hours");
  command
      ->add_option_function<std::string>(
          "-o,--output", [options](const std::string& folder) { options->output = folder; },
          "where everything goes (default bench-NAME)")
      ->type_name("DIR");
  command->add_flag("--resume", options->resume, "keep what results.json in that folder already holds");
  CLI::Option* reportOnly =
      command->add_flag("--report", options->reportOnly,
                        "measure nothing: show what results.json in that folder already holds");
  command->add_flag("--json", options->json, "print the report as JSON on the standard output");
  addTimingOptions(*command, options->timing, "the speedup");
  for (const char* measuring : {"--scenes", "--thorough", "--resume", "--repeat", "--no-timing"})
    reportOnly->excludes(command->get_option(measuring));
  command->footer(kExamples);
  command->callback([&action, options] { action = [options] { runBench(*options); }; });
}

}  // namespace host
