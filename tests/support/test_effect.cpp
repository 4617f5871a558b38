#include "tests/support/test_effect.h"

#include <utility>

namespace mres::test {

TestEffect::TestEffect(Recipe recipe)
    : recipe_(std::move(recipe)),
      text_("vec4 shade(Surface surface) {\n" + recipe_.body + "\n}\n"),
      files_{{{"test/effect.glsl", text_}}},
      description_{.name = recipe_.name.c_str(),
                   .shader = "test/effect.glsl",
                   .shaders = files_,
                   .channels = recipe_.channels,
                   .background = recipe_.background,
                   .filtered = recipe_.filtered,
                   .readsPyramid = false} {}

LevelTable levelSubset(unsigned mask) {
  LevelTable table = kSsaoLevels;
  for (std::size_t i = 0; i < table.size(); ++i) table.at(i).used = ((mask >> i) & 1u) != 0;
  return table;
}

}  // namespace mres::test
