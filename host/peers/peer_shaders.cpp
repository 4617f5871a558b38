#include "host/peers/peer_shaders.h"

namespace host {

std::string define(const char* name, int value) {
  return std::string("#define ") + name + ' ' + std::to_string(value) + '\n';
}

std::string effectDefines(const mres::EffectDescription& effect) {
  return define("EFFECT_CHANNELS", effect.channels) + define("FILTERED", effect.filtered ? 1 : 0);
}

}  // namespace host
