#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/commands/bench_results.h"
#include "host/commands/bench_suite.h"
#include "host/commands/bench_workbench.h"
#include "host/commands/progress.h"
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

/// Measures case after case; after each, results.json holds it.
class Campaign {
 public:
  Campaign(CampaignRequest request, const GlContext::Info& gl);

  const Json& run();

 private:
  [[nodiscard]] double expectedSeconds(const BenchCase& benchCase) const;
  void measure(const BenchCase& benchCase);
  Json writeCasePictures(const BenchCase& benchCase, Comparison& comparison);
  void show(double shareOfCase, const BenchCase& benchCase, const std::string& what);

  CampaignRequest request_;
  double totalSeconds_ = 0.0;  ///< expected of all cases
  BenchResults results_;
  Workbench workbench_;
  StderrProgressBar progress_;
  double doneSeconds_ = 0.0;
};

}  // namespace host
