#include "mres/gl/shader_library.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace mres::gl {
namespace {

/// The x of `#include "x"`, or nothing. `#include <x>` is the compiler's own business.
std::string_view includedName(std::string_view line) {
  constexpr std::string_view kDirective = "#include";
  const std::size_t start = line.find_first_not_of(" \t");
  if (start == std::string_view::npos || !line.substr(start).starts_with(kDirective)) return {};
  line.remove_prefix(start + kDirective.size());
  const std::size_t open = line.find_first_not_of(" \t");
  if (open == std::string_view::npos || line[open] != '"') return {};
  const std::size_t close = line.find('"', open + 1);
  return close == std::string_view::npos ? std::string_view{} : line.substr(open + 1, close - open - 1);
}

class Preprocessor {
 public:
  Preprocessor(const ShaderLibrary& library, std::string_view defines)
      : library_(library), defines_(defines) {}

  PreprocessedShader run(const std::string& name) {
    append(name);
    return std::move(result_);
  }

 private:
  void append(const std::string& name) {
    const auto fileIndex = static_cast<int>(result_.fileNames.size());
    result_.fileNames.push_back(name);
    std::istringstream text(library_.read(name));
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
      if (const std::string_view included = includedName(line); !included.empty()) {
        appendOnce(std::string(included));
        continueAt(number + 1, fileIndex);
      } else {
        result_.text += line + '\n';
        if (line.starts_with("#version")) {  // nothing but comments may stand before it
          result_.text += defines_;
          continueAt(number + 1, fileIndex);
        }
      }
    }
  }

  void appendOnce(const std::string& name) {
    if (std::ranges::find(result_.fileNames, name) != result_.fileNames.end()) return;
    continueAt(1, static_cast<int>(result_.fileNames.size()));
    append(name);
  }

  void continueAt(int line, int fileIndex) {
    result_.text += "#line " + std::to_string(line) + ' ' + std::to_string(fileIndex) + '\n';
  }

  const ShaderLibrary& library_;
  std::string_view defines_;
  PreprocessedShader result_;
};

}  // namespace

void ShaderLibrary::add(std::span<const ShaderFile> files) {
  for (const ShaderFile& file : files) add(std::string(file.name), std::string(file.text));
}

void ShaderLibrary::add(std::string name, std::string text) {
  files_.insert_or_assign(std::move(name), std::move(text));
}

std::string ShaderLibrary::read(const std::string& name) const {
  if (!directory_.empty()) {
    if (std::ifstream file(directory_ / name, std::ios::binary); file) {
      return {std::istreambuf_iterator<char>(file), {}};
    }
  }
  if (const auto found = files_.find(name); found != files_.end()) return found->second;
  throw std::runtime_error("Shader file '" + name + "' was not found among the embedded ones" +
                           (directory_.empty() ? "" : " or in " + directory_.string()) +
                           "; check the name in #include or add the file to the shader library.");
}

PreprocessedShader preprocess(const ShaderLibrary& library, const std::string& name,
                              std::string_view defines) {
  return Preprocessor(library, defines).run(name);
}

}  // namespace mres::gl
