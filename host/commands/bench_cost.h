// How long measurements take. Only the plan depends on it, never a result.
#pragma once

#include "host/commands/bench_suite.h"
#include "host/measure/interleaved.h"

namespace host {

/// How often to time a case: three pairs or more, fewer where they would take longer than a campaign can
/// give.
RepeatPlan planOf(const BenchCase& benchCase);

/// What a case takes at most by `plan` on the two cores of docs/results.md: with times that scatter so much
/// that the plan's seconds are used up.
double secondsOf(const BenchCase& benchCase, const RepeatPlan& plan);

}  // namespace host
