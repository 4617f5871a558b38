#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/commands/bench_results.h"
#include "host/commands/bench_suite.h"
#include "host/commands/bench_workbench.h"
#include "host/commands/progress.h"
#include "host/commands/time_left.h"
#include "host/platform/gl_context.h"

namespace host {

/// How the cases of a campaign are timed.
struct CampaignTiming {
  bool timing = true;
  std::optional<int> pairs;  ///< none: as planOf() each case

  /// Nothing where no timing is wanted.
  [[nodiscard]] std::optional<RepeatPlan> planOf(const BenchCase& benchCase) const;
};

struct CampaignRequest {
  std::vector<BenchCase> cases;
  CampaignTiming timing;
  std::filesystem::path output;
  bool resume = false;
};

/// Measures case after case; after each, results.json holds it. Scenes that cannot be loaded are told on
/// stderr and left out.
class Campaign {
 public:
  Campaign(CampaignRequest request, const GlContext::Info& gl);

  const Json& run();

  [[nodiscard]] std::size_t scenesLeftOut() const { return brokenScenes_.size(); }

 private:
  [[nodiscard]] double expectedSeconds(const BenchCase& benchCase) const;
  const Scene* load(const BenchCase& benchCase);
  /// Whether there was something to measure.
  bool measure(const BenchCase& benchCase);
  Json writeCasePictures(const BenchCase& benchCase, Comparison& comparison);
  void show(double shareOfCase, const BenchCase& benchCase, const std::string& what);

  CampaignRequest request_;
  double totalSeconds_ = 0.0;  ///< expected of all cases
  BenchResults results_;
  Workbench workbench_;
  std::set<std::string> brokenScenes_;
  StderrProgressBar progress_;
  TimeLeft timeLeft_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double doneSeconds_ = 0.0;
};

}  // namespace host
