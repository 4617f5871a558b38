#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "host/measure/techniques.h"

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
  std::string technique = kMresTechnique;  ///< one of techniqueNames()
  float errorBudget = mres::MaskSettings{}.errorBudget;
  int referenceSamples = 0;  ///< 0: as many as the technique has
  int frames = 0;            ///< of a path along which flicker is measured; 0: none
  bool stages = true;        ///< whether coverage and stages are looked at
};

struct SuiteRequest {
  std::string suite = {};
  std::vector<BenchScene> scenes = {};  ///< none: the built-in ones
  bool thorough = false;  ///< of suites that can be: every view with every number of samples or technique
};

inline constexpr const char* kPaperSuite = "paper";
inline constexpr const char* kParetoSuite = "pareto";

/// The suites that users choose from.
const std::vector<std::string>& suiteNames();

/// The cases of a suite, those of a scene and then those of an effect and its samples one after the other,
/// each once. Throws UsageError for an unknown name.
std::vector<BenchCase> suiteCases(const SuiteRequest& request);

/// Of the reference.
int referenceSamplesOf(const BenchCase& benchCase);

/// "hall 0 1920x1080 ssao 64", with the technique where it is another than mres.
std::string nameOf(const BenchCase& benchCase);

}  // namespace host
