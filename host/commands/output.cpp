#include "host/commands/output.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fmt/std.h>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace host {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void failToWrite(const fs::path& path, const std::string& reason) {
  throw std::runtime_error(
      fmt::format("Cannot write '{}': {}; choose another place with -o.", path.string(), reason));
}

fs::path temporaryBeside(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.partial", path.filename().string(), getpid());
}

/// Removes a temporary file unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void writeAll(const fs::path& file, const fs::path& destination, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) failToWrite(destination, errno != 0 ? std::strerror(errno) : "the disk may be full");
}

}  // namespace

void requireWritableFile(const fs::path& path) {
  if (path.filename().empty() || fs::is_directory(path))
    failToWrite(path, "it is a folder, a file is wanted");
  const TemporaryFile probe(temporaryBeside(path));
  writeAll(probe.path(), path, "");
}

void writeTextFile(const fs::path& path, const std::string& text) {
  const TemporaryFile temporary(temporaryBeside(path));
  writeAll(temporary.path(), path, text);
  std::error_code error;
  fs::rename(temporary.path(), path, error);
  if (error) failToWrite(path, error.message());
}

OutputDirectory::OutputDirectory(fs::path path) : path_(std::move(path)) {
  std::vector<fs::path> missing;
  for (fs::path folder = fs::absolute(path_).lexically_normal(); !fs::exists(folder);
       folder = folder.parent_path())
    missing.push_back(folder);
  std::error_code error;
  for (; !missing.empty() && !error; missing.pop_back())
    if (fs::create_directory(missing.back(), error)) made_.push_back(missing.back());
  if (error) failToWrite(path_, error.message());
  requireWritableFile(path_ / "report.json");
}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  for (; !made_.empty(); made_.pop_back())
    fs::remove(made_.back(), ignored);  // refuses folders with files in them
}

}  // namespace host
