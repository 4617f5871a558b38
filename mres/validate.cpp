#include "mres/validate.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace mres {

void refuseSetting(const char* owner, const char* name, const SettingInfo& info) {
  std::ostringstream sentence;
  sentence << owner << "::" << name << " must be " << info.min << " to " << info.max;
  if (*info.unit != '\0') sentence << ' ' << info.unit;
  sentence << '.';
  throw std::invalid_argument(sentence.str());
}

bool isTextureSize(glm::ivec2 size) {
  constexpr int kMaxSize = 16384;
  return std::min(size.x, size.y) >= 1 && std::max(size.x, size.y) <= kMaxSize;
}

bool isFinite(const glm::mat4& matrix) {
  const float* values = &matrix[0][0];
  return std::all_of(values, values + 16, [](float value) { return std::isfinite(value); });
}

}  // namespace mres
