#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace host::test {

struct ProcessResult {
  int exitCode = -1;  ///< 128 + the signal where one ended the process, as shells have it
  std::string out;
  std::string err;
};

/// Runs `mres` with `arguments`, and with `environment` ("NAME=value") on top of this process's own.
ProcessResult runMres(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& environment = {});

/// A folder of its own for a test, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return path_; }
  /// The path of a name in the folder, as an argument.
  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] bool isEmpty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

/// Writes a glTF scene of a floor, a wall and two cameras, and returns its path.
std::string writeCornerScene(const TemporaryFolder& folder);

std::string readFile(const std::filesystem::path& path);
void writeFile(const std::filesystem::path& path, const std::string& text);

}  // namespace host::test
