#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

#include "host/measure/picture_settings.h"

namespace host {

/// What the memory for a picture depends on.
struct PictureNeed {
  glm::ivec2 size{0};
  unsigned channels = 1;  ///< of the effect
  int shadowMapSize = 0;  ///< texels a side
};

PictureNeed needOf(const PictureSettings& settings, glm::ivec2 size);

/// Bytes of main memory that work on a picture takes at its peak: everything read back and, on a software
/// rasteriser, every target.
std::uint64_t bytesOfRender(const PictureNeed& need);
std::uint64_t bytesOfComparison(const PictureNeed& need);
std::uint64_t bytesOfComparisonWithTruth(const PictureNeed& need);

/// Bytes of main memory that this process may have: the machine's, or less where the process or its container
/// is limited.
std::uint64_t availableMemory();

/// Throws std::runtime_error with a sentence, which ends with `advice`, if `needed` bytes are more than there
/// are. To be called before anything large is allocated: the system ends a process that takes too much,
/// without a word.
void requireMemory(std::uint64_t needed, std::uint64_t available, const std::string& advice);

}  // namespace host
