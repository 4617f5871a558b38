#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/bench/results.h"
#include "host/bench/suite.h"
#include "host/bench/time_left.h"
#include "host/bench/workbench.h"
#include "host/console/progress.h"
#include "host/console/stopwatch.h"
#include "host/platform/gl_context.h"

namespace host {

struct CampaignRequest {
  std::vector<BenchCase> cases;
  std::optional<RepeatPlan> timing;  ///< none: pictures and errors alone
  std::filesystem::path output;
  bool resume = false;
};

/// Measures case after case; after each, results.json holds it. What cannot be measured is told on stderr,
/// once for each scene and reason, and left out.
class Campaign {
 public:
  Campaign(CampaignRequest request, const GlContext::Info& gl);

  const Json& run();

  /// The scenes of which not everything could be measured.
  [[nodiscard]] std::vector<std::string> incompleteScenes() const;

 private:
  [[nodiscard]] double expectedSeconds(const BenchCase& benchCase) const;
  const Scene* load(const BenchCase& benchCase);
  void runCase(const BenchCase& benchCase);
  /// Nothing where there is nothing to measure, or it fails.
  std::optional<Measurement> measure(const BenchCase& benchCase);
  Measurement measure(const BenchCase& benchCase, const PictureSettings& settings, const Json& values);
  Json writeCasePictures(const BenchCase& benchCase, Comparison& comparison, glm::ivec2 worstPlace);
  void noteOnce(const BenchCase& benchCase, const Comparison& comparison);
  void leaveOut(const BenchCase& benchCase, const std::string& reason);
  void show(double shareOfCase, const BenchCase& benchCase, const std::string& what);

  CampaignRequest request_;
  double totalSeconds_ = 0.0;  ///< expected of all cases
  BenchResults results_;
  Workbench workbench_;
  std::set<std::string> brokenScenes_;                    ///< by source
  std::map<std::string, std::set<std::string>> leftOut_;  ///< why, by the scene's name
  std::string notedScene_;
  StderrProgressBar progress_;
  TimeLeft timeLeft_;
  Stopwatch stopwatch_;
  double doneSeconds_ = 0.0;
};

}  // namespace host
