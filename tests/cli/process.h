#pragma once

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace host::test {

struct ProcessResult {
  int exitCode = -1;  ///< 128 + the signal where one ended the process, as shells have it
  std::string out;
  std::string err;
};

/// Runs `mres` with `arguments`, and with `environment` ("NAME=value") on top of this process's own.
ProcessResult runMres(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& environment = {});

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
