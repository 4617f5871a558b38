#include "host/console/output.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "host/files/temporary_file.h"

namespace host {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void failToWrite(const fs::path& path, const std::string& reason) {
  throw std::runtime_error(
      fmt::format("Cannot write '{}': {}; choose another place with -o.", path.string(), reason));
}

void writeAll(const fs::path& file, const fs::path& destination, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) failToWrite(destination, errno != 0 ? std::strerror(errno) : "the disk may be full");
}

}  // namespace

void requireWritableFile(const fs::path& path) {
  std::error_code ignored;  // whatever it is, writing fails as well
  if (path.filename().empty() || fs::is_directory(path, ignored))
    failToWrite(path, "it is a folder, a file is wanted");
  const TemporaryFile probe(path);
  writeAll(probe.path(), path, "");
}

void writeTextFile(const fs::path& path, const std::string& text) {
  const TemporaryFile temporary(path);
  writeAll(temporary.path(), path, text);
  if (const std::error_code error = temporary.commit()) failToWrite(path, error.message());
}

MadeFolders::~MadeFolders() {
  std::error_code ignored;
  for (; !made_.empty(); made_.pop_back())
    fs::remove(made_.back(), ignored);  // refuses folders with files in them
}

std::error_code MadeFolders::make(const fs::path& folder) {
  std::error_code error;
  fs::path place;
  for (const fs::path& part : fs::absolute(folder, error).lexically_normal()) {
    if (error) break;
    place /= part;
    if (fs::create_directory(place, error)) made_.push_back(place);
  }
  return error;
}

OutputDirectory::OutputDirectory(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) failToWrite(path_, "its name is empty");
  if (const std::error_code error = made_.make(path_)) failToWrite(path_, error.message());
  requireWritableFile(path_ / "report.json");
}

}  // namespace host
