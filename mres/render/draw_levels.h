#pragma once

#include "mres/render/planned_frame.h"

namespace mres {

/// Draws the effect level by level, coarsest first, each blended over the coarser ones. Needs the masks
/// drawn, and depth, normals, the effect and the frame's block bound.
void drawLevels(const PlannedFrame& planned);

}  // namespace mres
