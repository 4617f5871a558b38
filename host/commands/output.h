// Where results go. Checked before the work begins, written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace host {

/// Throws std::runtime_error with a sentence if no file can be made at `path`.
void requireWritableFile(const std::filesystem::path& path);

/// A file beside `destination` that is removed again unless commit() renames it to that.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path destination);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Throws std::runtime_error with a sentence.
  void commit() const;

 private:
  std::filesystem::path destination_;
  std::filesystem::path path_;
};

/// Writes beside `path` and renames. Throws std::runtime_error with a sentence.
void writeTextFile(const std::filesystem::path& path, const std::string& text);

/// A folder for results, made with its parents where it is missing. Throws std::runtime_error with a sentence
/// if nothing can be written there. Folders that it made and that are still empty at the end are taken away
/// again.
class OutputDirectory {
 public:
  explicit OutputDirectory(std::filesystem::path path);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // outermost first
};

}  // namespace host
