// Where results go. Checked before the work begins, written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace host {

/// Throws std::runtime_error with a sentence if no file can be made at `path`.
void requireWritableFile(const std::filesystem::path& path);

/// Writes beside `path` and renames. Throws std::runtime_error with a sentence.
void writeTextFile(const std::filesystem::path& path, const std::string& text);

/// Folders that are taken away again at the end if they are still empty.
class MadeFolders {
 public:
  MadeFolders() = default;
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  MadeFolders(MadeFolders&&) = delete;
  MadeFolders& operator=(MadeFolders&&) = delete;

  /// Makes `folder`, with its parents, where it is missing.
  std::error_code make(const std::filesystem::path& folder);

 private:
  std::vector<std::filesystem::path> made_;  // outermost first
};

/// A folder for results, made with its parents where it is missing. Throws std::runtime_error with a sentence
/// if nothing can be written there. Folders that it made and that are still empty at the end are taken away
/// again.
class OutputDirectory {
 public:
  explicit OutputDirectory(std::filesystem::path path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  MadeFolders made_;
};

}  // namespace host
