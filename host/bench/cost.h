// How long campaigns take: what they may, and what is expected of each case for the progress bar.
#pragma once

#include "host/bench/suite.h"
#include "host/measure/interleaved.h"

namespace host {

/// How often campaigns time each picture: briefly, since they have hundreds.
RepeatPlan campaignPlan();
/// The same of the pareto suite, whose pictures each have many techniques.
RepeatPlan paretoPlan();

/// What a case takes at most by `plan` on the two cores of docs/results.md: with times that scatter so much
/// that the plan's seconds are used up.
double secondsOf(const BenchCase& benchCase, const RepeatPlan& plan);

}  // namespace host
