#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "host/measure/measurement.h"

namespace host {

/// One picture that a suite measures.
struct BenchCase {
  std::string scene;
  int camera = 0;
  glm::ivec2 size{0};
  int samples = 0;
  bool pictures = false;  ///< whether the report shows it
};

/// The suites that users choose from.
const std::vector<std::string>& suiteNames();

/// The cases of a suite, those of a scene one after the other. Throws UsageError for an unknown name.
std::vector<BenchCase> suiteCases(const std::string& suite);

/// "hall 0 1920x1080 64 samples".
std::string nameOf(const BenchCase& benchCase);

}  // namespace host
