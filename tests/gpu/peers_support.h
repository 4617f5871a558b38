// What the tests of the peers share.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "host/peers/peer_kinds.h"
#include "tests/gpu/multi_resolution_support.h"
#include "tests/support/pictures.h"

namespace mres::test {

/// full() is what peers are measured against.
class PeersTest : public MultiResolutionTest {
 protected:
  static Picture picture(host::Peer& peer, Effect& effect, const Frame& frame) {
    return readPixels(peer.render(effect, frame), frame.size, effect.description().channels);
  }

  /// By a peer of that name made for it.
  static Picture picture(std::string_view name, Effect& effect, const Frame& frame) {
    return picture(*host::makePeer(name, effect.description()), effect, frame);
  }
};

}  // namespace mres::test
