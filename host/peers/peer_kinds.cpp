#include "host/peers/peer_kinds.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "host/peers/adaptive_tiles_peer.h"
#include "host/peers/checkerboard_peer.h"
#include "host/peers/coarse_peer.h"
#include "host/peers/interleaved_peer.h"
#include "mres/gl/state_guard.h"

namespace host {
namespace {

template <int level, Upsampling upsampling>
std::unique_ptr<Peer> makeCoarse(const mres::EffectDescription& effect, const PeerOptions& options) {
  return std::make_unique<CoarsePeer>(effect, options, level, upsampling);
}

template <class Kind>
std::unique_ptr<Peer> makeKind(const mres::EffectDescription& effect, const PeerOptions& options) {
  return std::make_unique<Kind>(effect, options);
}

constexpr std::array<PeerKind, 7> kKinds{{
    {"half-bilinear", "half of the resolution, upsampled bilinearly", makeCoarse<1, Upsampling::bilinear>},
    {"half-joint", "half of the resolution, upsampled by depth and normal", makeCoarse<1, Upsampling::joint>},
    {"quarter-bilinear", "a quarter of the resolution, upsampled bilinearly",
     makeCoarse<2, Upsampling::bilinear>},
    {"quarter-joint", "a quarter of the resolution, upsampled by depth and normal",
     makeCoarse<2, Upsampling::joint>},
    {"checkerboard", "every other block of 2x2 pixels, the rest filled by depth and normal",
     makeKind<CheckerboardPeer>},
    {"interleaved", "every pixel, those of one phase of the 4x4 noise side by side",
     makeKind<InterleavedPeer>},
    {"adaptive-tiles", "tiles of 16x16 pixels, each at the resolution that its content needs",
     makeKind<AdaptiveTilesPeer>},
}};

}  // namespace

std::span<const PeerKind> peerKinds() {
  return kKinds;
}

std::unique_ptr<Peer> makePeer(std::string_view name, const mres::EffectDescription& effect,
                               const PeerOptions& options) {
  const auto* kind = std::ranges::find_if(kKinds, [name](const PeerKind& each) { return each.name == name; });
  if (kind == kKinds.end())
    throw std::invalid_argument("There is no peer '" + std::string(name) + "'; peerKinds() names them.");
  const mres::gl::StateGuard guard(mres::gl::StateGuard::countViewports());
  return kind->make(effect, options);
}

}  // namespace host
