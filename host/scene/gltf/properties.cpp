#include "host/scene/gltf/properties.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace host::gltf {

float toFloat(double value) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return std::isnan(value) ? 0.0f : float(std::clamp(value, -kMax, kMax));
}

glm::vec3 toVec3(const std::vector<double>& values, glm::vec3 fallback) {
  if (values.size() != 3) return fallback;
  return {toFloat(values[0]), toFloat(values[1]), toFloat(values[2])};
}

glm::vec4 toVec4(const std::vector<double>& values, glm::vec4 fallback) {
  if (values.size() != 4) return fallback;
  return {toFloat(values[0]), toFloat(values[1]), toFloat(values[2]), toFloat(values[3])};
}

const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions, const std::string& name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

const tinygltf::Value* findMember(const tinygltf::Value& object, const std::string& name) {
  return object.IsObject() && object.Has(name) ? &object.Get(name) : nullptr;
}

double numberMember(const tinygltf::Value& object, const std::string& name, double fallback) {
  const tinygltf::Value* member = findMember(object, name);
  return member != nullptr && member->IsNumber() ? member->GetNumberAsDouble() : fallback;
}

int integerMember(const tinygltf::Value& object, const std::string& name, int fallback) {
  const tinygltf::Value* member = findMember(object, name);
  return member != nullptr && member->IsInt() ? member->GetNumberAsInt() : fallback;
}

std::vector<double> numbersMember(const tinygltf::Value& object, const std::string& name) {
  const tinygltf::Value* member = findMember(object, name);
  if (member == nullptr || !member->IsArray()) return {};
  std::vector<double> numbers;
  for (const tinygltf::Value& entry : member->Get<tinygltf::Value::Array>()) {
    if (!entry.IsNumber()) return {};
    numbers.push_back(entry.GetNumberAsDouble());
  }
  return numbers;
}

}  // namespace host::gltf
