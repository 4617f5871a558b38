#pragma once

#include "host/image/image_file.h"

namespace host {

/// The part of an image, up to `side` pixels wide and high, that has `centre` as near to its middle as the
/// image's borders let it.
FloatImage cropAround(const FloatImage& image, glm::ivec2 centre, int side);

}  // namespace host
