#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace host {

struct BenchScene {
  std::string source;  ///< what loadScene() takes
  std::string name;    ///< what the results call it; no two scenes share one
};

/// One picture that a suite measures.
struct BenchCase {
  BenchScene scene;
  std::string effect;
  int samples = 0;
  glm::ivec2 size{0};
  int camera = 0;           ///< scenes that have fewer go without
  bool pictures = false;    ///< whether the report shows it
  bool truth = false;       ///< whether it is measured against truth, too
  bool worstPlace = false;  ///< whether the report shows where it is farthest from its reference
};

struct SuiteRequest {
  std::string suite = {};
  std::vector<BenchScene> scenes = {};  ///< none: the built-in ones
  bool thorough = false;                ///< the paper's suite: every view with every number of samples
};

inline constexpr const char* kPaperSuite = "paper";

/// The suites that users choose from.
const std::vector<std::string>& suiteNames();

/// The cases of a suite, those of a scene and then those of an effect and its samples one after the other,
/// each once. Throws UsageError for an unknown name.
std::vector<BenchCase> suiteCases(const SuiteRequest& request);

/// "hall 0 1920x1080 ssao 64".
std::string nameOf(const BenchCase& benchCase);

}  // namespace host
