// The node hierarchy, flattened.
#pragma once

#include <glm/glm.hpp>

#include "host/scene/gltf/document.h"

namespace host::gltf {

struct PlacedNode {
  const tinygltf::Node* node = nullptr;  ///< in the document's model
  glm::mat4 transform{1.0f};             ///< to the world; finite
};

/// The visible nodes of the default scene; of the first where none is the default; of all roots in a file
/// without scenes. Each node is visited once: further parents and cycles are cut, with a warning. Throws
/// std::runtime_error where a node refers to one that does not exist or has a malformed transform.
std::vector<PlacedNode> placedNodes(Document& document);

}  // namespace host::gltf
