#pragma once

#include "mres/frame.h"
#include "shaders/mres/frame_params.h"

namespace mres {

/// The coefficients that the shaders need of a frame's camera and conventions. Throws std::invalid_argument
/// with a sentence if the frame cannot be rendered.
params::FrameParams frameParams(const Frame& frame);

}  // namespace mres
