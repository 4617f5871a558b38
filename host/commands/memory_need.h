#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace host {

/// Bytes of main memory that work on pictures of a size takes at its peak: everything read back and, on a
/// software rasteriser, every target.
std::uint64_t bytesOfRender(glm::ivec2 size);
std::uint64_t bytesOfComparison(glm::ivec2 size);
std::uint64_t bytesOfComparisonWithTruth(glm::ivec2 size);

/// Bytes of main memory that this process may have: the machine's, or less where the process or its container
/// is limited.
std::uint64_t availableMemory();

/// Throws std::runtime_error with a sentence if `needed` bytes are more than there are. To be called before
/// anything large is allocated: the system ends a process that takes too much, without a word.
void requireMemory(std::uint64_t needed, std::uint64_t available);

}  // namespace host
