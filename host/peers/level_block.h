#pragma once

#include <optional>

#include "host/peers/peer_frame.h"
#include "mres/gl/uniform_buffer.h"
#include "shaders/mres/level_params.h"

namespace host {

/// The uniform block of a level, on its own or with a coarser one that it is upsampled from.
class LevelBlock {
 public:
  void bind(const PeerFrame& frame, int level, std::optional<int> coarser = std::nullopt);

 private:
  mres::gl::UniformBuffer<mres::params::LevelParams> block_;
};

}  // namespace host
