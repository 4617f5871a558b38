// Safe reading of numbers from tinygltf's doubles and of extension objects.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <tiny_gltf.h>
#include <vector>

namespace host::gltf {

/// A finite float: JSON numbers may be larger than a float can be.
float toFloat(double value);

/// `values` as a vector, or `fallback` where there are not exactly three (four).
glm::vec3 toVec3(const std::vector<double>& values, glm::vec3 fallback);
glm::vec4 toVec4(const std::vector<double>& values, glm::vec4 fallback);

/// The extension's object, or nullptr.
const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions, const std::string& name);

/// A member of an object, or nullptr. `object` may be of any type.
const tinygltf::Value* findMember(const tinygltf::Value& object, const std::string& name);

double numberMember(const tinygltf::Value& object, const std::string& name, double fallback);
int integerMember(const tinygltf::Value& object, const std::string& name, int fallback);

/// The numbers of an array; empty where it is none.
std::vector<double> numbersMember(const tinygltf::Value& object, const std::string& name);

}  // namespace host::gltf
