#include "host/scene/gltf/nodes.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "host/scene/gltf/properties.h"

namespace host::gltf {
namespace {

// With positions up to kMaxCoordinate (primitive.cpp), squared distances in the world stay finite.
constexpr double kMaxTransform = 1e9;

void checkSize(const std::vector<double>& values, std::size_t expected, int node, const char* what) {
  if (values.empty() || values.size() == expected) return;
  throw std::runtime_error(
      fmt::format("the {} of node {} has {} numbers instead of {}; export the file again", what, node,
                  values.size(), expected));
}

glm::dmat4 localTransform(const tinygltf::Node& node, int index) {
  checkSize(node.matrix, 16, index, "matrix");
  checkSize(node.translation, 3, index, "translation");
  checkSize(node.rotation, 4, index, "rotation");
  checkSize(node.scale, 3, index, "scale");
  if (!node.matrix.empty()) {
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[std::size_t(i)];
    return matrix;
  }
  glm::dmat4 transform(1.0);
  if (!node.rotation.empty()) {
    const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    if (glm::length(rotation) > 0.0) transform = glm::mat4_cast(glm::normalize(rotation));
  }
  for (int i = 0; i < 3 && !node.scale.empty(); ++i) transform[i] *= node.scale[std::size_t(i)];
  for (int i = 0; i < 3 && !node.translation.empty(); ++i) transform[3][i] = node.translation[std::size_t(i)];
  return transform;
}

bool isUsable(const glm::dmat4& transform) {
  for (int i = 0; i < 16; ++i) {
    if (!(std::abs(transform[i / 4][i % 4]) <= kMaxTransform)) return false;  // NaN, too
  }
  return true;
}

std::vector<int> allRoots(const tinygltf::Model& model) {
  std::vector<bool> isChild(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) {
      if (child >= 0 && std::size_t(child) < isChild.size()) isChild[std::size_t(child)] = true;
    }
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < isChild.size(); ++i) {
    if (!isChild[i]) roots.push_back(int(i));
  }
  return roots;
}

std::vector<int> rootsOf(Document& document) {
  const tinygltf::Model& model = document.model;
  if (model.scenes.empty()) return allRoots(model);
  if (model.defaultScene < -1 || model.defaultScene >= int(model.scenes.size())) {
    document.warnings.push_back(
        fmt::format("The default scene {} does not exist; the first scene is shown.", model.defaultScene));
    return model.scenes.front().nodes;
  }
  return model.scenes[std::size_t(std::max(model.defaultScene, 0))].nodes;
}

/// KHR_node_visibility hides a node together with its children.
bool isVisible(const tinygltf::Node& node) {
  const tinygltf::Value* extension = findExtension(node.extensions, "KHR_node_visibility");
  const tinygltf::Value* visible = extension == nullptr ? nullptr : findMember(*extension, "visible");
  return visible == nullptr || !visible->IsBool() || visible->Get<bool>();
}

struct Pending {
  int node;
  glm::dmat4 parentTransform;
};

/// Pushed in reverse, so that nodes come off the stack in the order of the file.
void push(std::vector<Pending>& stack, const std::vector<int>& nodes, const glm::dmat4& parentTransform) {
  std::transform(nodes.rbegin(), nodes.rend(), std::back_inserter(stack), [&](int node) {
    return Pending{node, parentTransform};
  });
}

}  // namespace

std::vector<PlacedNode> placedNodes(Document& document) {
  const std::vector<tinygltf::Node>& nodes = document.model.nodes;
  std::vector<PlacedNode> placed;
  std::vector<bool> visited(nodes.size(), false);
  std::vector<Pending> stack;  // hierarchies may be deeper than the call stack
  push(stack, rootsOf(document), glm::dmat4(1.0));
  while (!stack.empty()) {
    const auto [index, parentTransform] = stack.back();
    stack.pop_back();
    if (index < 0 || std::size_t(index) >= nodes.size()) {
      throw std::runtime_error(
          fmt::format("its hierarchy uses node {}, which does not exist; export the file again", index));
    }
    if (visited[std::size_t(index)]) {
      document.warnings.push_back(
          fmt::format("Node {} has several parents or is its own; it is placed once.", index));
      continue;
    }
    visited[std::size_t(index)] = true;
    const tinygltf::Node& node = nodes[std::size_t(index)];
    if (!isVisible(node)) continue;
    const glm::dmat4 transform = parentTransform * localTransform(node, index);
    if (!isUsable(transform)) {
      document.warnings.push_back(fmt::format("Node {} is left out: its transform is not finite.", index));
      continue;
    }
    placed.push_back({&node, glm::mat4(transform)});
    push(stack, node.children, transform);
  }
  return placed;
}

}  // namespace host::gltf
