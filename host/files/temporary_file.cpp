#include "host/files/temporary_file.h"

#include <fmt/format.h>
#include <unistd.h>
#include <utility>

namespace host {
namespace fs = std::filesystem;
namespace {

/// Beside it, since renaming is atomic only within a file system.
fs::path temporaryBeside(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.partial", path.filename().string(), getpid());
}

}  // namespace

TemporaryFile::TemporaryFile(fs::path destination)
    : destination_(std::move(destination)), path_(temporaryBeside(destination_)) {}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

std::error_code TemporaryFile::commit() const {
  std::error_code error;
  fs::rename(path_, destination_, error);
  return error;
}

}  // namespace host
