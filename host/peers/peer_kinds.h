#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "host/peers/peer.h"

namespace host {

/// What a technique is called, and what it does.
struct PeerKind {
  const char* name;
  const char* meaning;  ///< for the middle of a sentence
  std::unique_ptr<Peer> (*make)(const mres::EffectDescription& effect, const PeerOptions& options);
};

std::span<const PeerKind> peerKinds();

/// Throws std::invalid_argument if there is no such peer, std::runtime_error if the driver rejects a shader.
std::unique_ptr<Peer> makePeer(std::string_view name, const mres::EffectDescription& effect,
                               const PeerOptions& options = {});

}  // namespace host
