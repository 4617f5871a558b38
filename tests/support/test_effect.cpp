#include "tests/support/test_effect.h"

#include <utility>

namespace mres::test {
namespace {

std::string functionOf(const std::string& name, const std::string& body) {
  return name + "(Surface surface) {\n" + body + "\n}\n";
}

}  // namespace

TestEffect::TestEffect(Recipe recipe)
    : recipe_(std::move(recipe)),
      text_(functionOf("vec4 shade", recipe_.body) +
            (recipe_.preview.empty() ? "" : functionOf("vec2 preview", recipe_.preview))),
      files_{{{"test/effect.glsl", text_}}},
      description_{.name = recipe_.name.c_str(),
                   .shader = "test/effect.glsl",
                   .shaders = files_,
                   .channels = recipe_.channels,
                   .background = recipe_.background,
                   .filtered = recipe_.filtered,
                   .readsPyramid = false,
                   .hasPreview = !recipe_.preview.empty()} {}

TestEffect::Recipe levelNumbers(const LevelTable& levels) {
  return {.body = "return vec4(log2(float(levelStride)) / 4.0);", .levels = levels};
}

LevelTable levelSubset(unsigned mask) {
  LevelTable table = kSsaoLevels;
  for (std::size_t i = 0; i < table.size(); ++i) table.at(i).used = ((mask >> i) & 1u) != 0;
  return table;
}

}  // namespace mres::test
