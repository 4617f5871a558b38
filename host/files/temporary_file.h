#pragma once

#include <filesystem>
#include <system_error>

namespace host {

/// A file beside `destination` that is removed again unless commit() renames it to that.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path destination);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The error if the file cannot take its destination's place.
  [[nodiscard]] std::error_code commit() const;

 private:
  std::filesystem::path destination_;
  std::filesystem::path path_;
};

}  // namespace host
