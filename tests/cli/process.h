#pragma once

#include <filesystem>
#include <string>
#include <sys/types.h>
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

/// `mres` while it runs.
class RunningMres {
 public:
  RunningMres(const std::vector<std::string>& arguments, const std::vector<std::string>& environment);
  ~RunningMres();
  RunningMres(const RunningMres&) = delete;
  RunningMres& operator=(const RunningMres&) = delete;
  RunningMres(RunningMres&&) = delete;
  RunningMres& operator=(RunningMres&&) = delete;

  void interrupt() const;
  ProcessResult wait();

 private:
  TemporaryFolder folder_;  // of its output
  pid_t child_ = 0;
};

/// Writes a glTF scene of a floor, a wall and two cameras, and returns its path.
std::string writeCornerScene(const TemporaryFolder& folder);

std::string readFile(const std::filesystem::path& path);
/// Makes the file's folder as well.
void writeFile(const std::filesystem::path& path, const std::string& text);

}  // namespace host::test
