#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mres::gl {

/// One embedded shader file.
struct ShaderFile {
  std::string_view name;  ///< path below shaders/, e.g. "mres/edges.frag"
  std::string_view text;
};

/// Finds the text of shader files by name: in a directory on disk where one is set (for hot reload), else
/// among the embedded ones.
class ShaderLibrary {
 public:
  void add(std::span<const ShaderFile> files);
  void add(std::string name, std::string text);

  /// Files found below this directory win over embedded ones. Empty: none.
  void setDirectory(std::filesystem::path directory) { directory_ = std::move(directory); }

  /// Throws std::runtime_error that names the file and the places searched.
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::map<std::string, std::string, std::less<>> files_;
  std::filesystem::path directory_;
};

/// The text of `name` with each `#include "x"` replaced by the file x, once per file; `#include <x>` is left
/// alone. #line directives keep the numbers right: string number i is the i-th entry of `fileNames`.
struct PreprocessedShader {
  std::string text;
  std::vector<std::string> fileNames;
};
PreprocessedShader preprocess(const ShaderLibrary& library, const std::string& name,
                              std::string_view defines = {});

}  // namespace mres::gl
