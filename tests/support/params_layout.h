#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mres::test {

/// A member of a uniform block and where C++ puts it.
struct ParamsMember {
  std::string name;
  std::size_t offset;
};

/// A uniform block as a *_params.h header describes it to C++.
struct ParamsBlock {
  std::string header;
  std::string name;
  std::size_t size;
  std::string use;  ///< an expression of one member, so that the block stays
  std::vector<ParamsMember> members;
};

#define MEMBER(Struct, name) \
  { #name, offsetof(params::Struct, name) }
#define ARRAY_MEMBER(Struct, name) \
  { #name "[0]", offsetof(params::Struct, name) }

/// Expects GLSL to put every member of the block, which `preamble` declares to it, where C++ does.
void expectSameLayout(const ParamsBlock& block, const std::string& preamble);

}  // namespace mres::test
