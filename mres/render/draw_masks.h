#pragma once

#include "mres/debug/debug_view_pass.h"
#include "mres/level/frame_params.h"
#include "mres/render/planned_frame.h"

namespace mres {

/// Finds the edges that the effect needs, joins them with the host's importance mask, and makes the masks of
/// all levels but the coarsest. Needs depth, normals, the effect and the frame's block bound.
/// Geometry's edges and folds are those of an earlier effect of the same frame, if there was one (Frame::id).
EdgeImages drawMasks(const PlannedFrame& planned, const Frame& frame, const params::FrameParams& params);

}  // namespace mres
