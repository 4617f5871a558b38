#include "mres/validate.h"

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

}  // namespace mres
