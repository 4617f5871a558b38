// Values as users write them. Each function throws UsageError with a sentence that shows what is wanted.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace host {

constexpr int kMaxImageSize =
    16384;  ///< what OpenGL 3.3 drivers, llvmpipe included, allow for a texture's side

/// "1920x1080", or a usual name: 720p, 1080p, 1440p, 4k.
glm::ivec2 parseSize(const std::string& text);

/// A 0-based camera, or nothing for "all".
std::optional<int> parseCamera(const std::string& text);

/// A whole finite number, nothing after it.
std::optional<double> parseNumber(std::string_view text);

/// A whole number of `things`, from `least` to `most`.
int parseCount(const std::string& text, std::string_view things, int least, int most);

/// "radius=0.4" -> {"radius", "0.4"}.
struct Assignment {
  std::string key;
  std::string value;
};
Assignment parseAssignment(const std::string& text);

/// `word` and the candidates that a slip of the finger would turn it into, nearest first, at most three.
std::vector<std::string> closestNames(std::string_view word, const std::vector<std::string>& candidates);

/// The end of a sentence: "; did you mean radius or samples?", or the whole list where nothing is near.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace host
