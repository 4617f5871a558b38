#include "host/commands/output.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
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

void writeAll(const fs::path& file, const fs::path& destination, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) failToWrite(destination, errno != 0 ? std::strerror(errno) : "the disk may be full");
}

}  // namespace

TemporaryFile::TemporaryFile(fs::path destination)
    : destination_(std::move(destination)), path_(temporaryBeside(destination_)) {}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void TemporaryFile::commit() const {
  std::error_code error;
  fs::rename(path_, destination_, error);
  if (error) failToWrite(destination_, error.message());
}

void requireWritableFile(const fs::path& path) {
  if (path.filename().empty() || fs::is_directory(path))
    failToWrite(path, "it is a folder, a file is wanted");
  const TemporaryFile probe(path);
  writeAll(probe.path(), path, "");
}

void writeTextFile(const fs::path& path, const std::string& text) {
  const TemporaryFile temporary(path);
  writeAll(temporary.path(), path, text);
  temporary.commit();
}

OutputDirectory::OutputDirectory(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) failToWrite(path_, "its name is empty");
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
