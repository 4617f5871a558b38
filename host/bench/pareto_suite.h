#pragma once

#include <vector>

#include "host/bench/suite.h"

namespace host {

/// Every technique against the same full resolution, for time against error: the effects of the paper's
/// evaluation in three sizes. By default a view of each scene and at 1920x1080 all techniques, elsewhere
/// those that compete; thoroughly, every view by every technique in every size.
std::vector<BenchCase> paretoCases(const BenchScene& scene, bool thorough);

/// Ambient occlusion of some techniques, tiny.
std::vector<BenchCase> paretoSmokeCases(const BenchScene& scene);

}  // namespace host
