#include "tests/cli/process.h"

#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <spawn.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace host::test {
namespace fs = std::filesystem;
namespace {

// Two quads, eight positions and twelve 16-bit indices: a floor of 4 m x 4 m and a wall 3 m high at its back.
constexpr const char* kCornerScene =
    R"({
  "asset": {"version": "2.0"},
  "scene": 0,
  "scenes": [{"nodes": [0, 1, 2]}],
  "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 1.2, 4]}, {"camera": 0, "translation": [1, 1, 3]}],
  "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.1, "zfar": 50}}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [-2, 0, -2], "max": [2, 3, 2]},
    {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
  "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 24}],
  "buffers": [{"byteLength": 120, "uri": "data:application/octet-stream;base64,)"
    "AAAAwAAAAAAAAADAAAAAQAAAAAAAAADAAAAAQAAAAAAAAABAAAAAwAAAAAAAAABAAAAAwAAA"
    "AAAAAADAAAAAQAAAAAAAAADAAAAAQAAAQEAAAADAAAAAwAAAQEAAAADAAAACAAEAAAADAAIA"
    "BAAFAAYABAAGAAcA\"}]}";

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environmentWith(const std::vector<std::string>& additions) {
  std::vector<std::string> environment(additions);
  for (char** entry = environ; *entry != nullptr; ++entry) environment.emplace_back(*entry);
  return environment;
}

int exitCodeOf(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

RunningMres::RunningMres(const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment) {
  const std::string out = folder_ / "out";
  const std::string err = folder_ / "err";
  std::vector<std::string> command{MRES_EXECUTABLE};
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environmentWith(environment);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  const int error = posix_spawn(&child_, MRES_EXECUTABLE, &actions, nullptr, pointersTo(command).data(),
                                pointersTo(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot start " MRES_EXECUTABLE);
}

RunningMres::~RunningMres() {
  if (child_ == 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

void RunningMres::interrupt() const {
  kill(child_, SIGINT);
}

ProcessResult RunningMres::wait() {
  int status = 0;
  waitpid(std::exchange(child_, 0), &status, 0);
  return {exitCodeOf(status), readFile(folder_ / "out"), readFile(folder_ / "err")};
}

ProcessResult runMres(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& environment) {
  return RunningMres(arguments, environment).wait();
}

std::string writeCornerScene(const TemporaryFolder& folder) {
  std::string path = folder / "corner.gltf";
  writeFile(path, kCornerScene);
  return path;
}

std::string readFile(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void writeFile(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace host::test
