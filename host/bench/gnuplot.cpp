#include "host/bench/gnuplot.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include "host/console/interruption.h"
#include "host/console/output.h"
#include "host/files/temporary_file.h"

namespace host {
namespace fs = std::filesystem;
namespace {

// Colours that colour-blind people can tell apart: Okabe and Ito, "Color Universal Design" (2008), then those
// of Tol, "Colour Schemes" (2021), that are not near them.
constexpr const char* kStyle =
    R"(set terminal svg size 820,540 font "sans-serif,13" background rgb "white" noenhanced
set border 3 linecolor rgb "#555555"
set tics nomirror
set grid linecolor rgb "#dddddd"
set key outside right top
set linetype 1 linecolor rgb "#0072b2" linewidth 2 pointtype 7
set linetype 2 linecolor rgb "#d55e00" linewidth 2 pointtype 5
set linetype 3 linecolor rgb "#009e73" linewidth 2 pointtype 9
set linetype 4 linecolor rgb "#cc79a7" linewidth 2 pointtype 11
set linetype 5 linecolor rgb "#e69f00" linewidth 2 pointtype 13
set linetype 6 linecolor rgb "#56b4e9" linewidth 2 pointtype 4
set linetype 7 linecolor rgb "#f0e442" linewidth 2 pointtype 6
set linetype 8 linecolor rgb "#555555" linewidth 2 pointtype 8
set linetype 9 linecolor rgb "#882255" linewidth 2 pointtype 10
set linetype 10 linecolor rgb "#117733" linewidth 2 pointtype 12
set linetype 11 linecolor rgb "#332288" linewidth 2 pointtype 1
set linetype 12 linecolor rgb "#999933" linewidth 2 pointtype 2
set linetype 13 linecolor rgb "#aa4499" linewidth 2 pointtype 3
set linetype 14 linecolor rgb "#88ccee" linewidth 2 pointtype 6
)";

/// Redirections of a child's streams.
class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  FileActions(FileActions&&) = delete;
  FileActions& operator=(FileActions&&) = delete;
  void open(int descriptor, const char* path, int flags) {
    posix_spawn_file_actions_addopen(&actions_, descriptor, path, flags, 0666);
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

enum class Outcome { done, failed, missing };

Outcome runGnuplot(const fs::path& script, const fs::path& output) {
  std::string program = "gnuplot";
  std::string argument = script.string();
  const std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  FileActions actions;
  actions.open(STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  actions.open(STDERR_FILENO, "/dev/null", O_WRONLY);
  pid_t child = 0;
  const int error = posix_spawnp(&child, program.c_str(), actions.get(), nullptr, arguments.data(), environ);
  if (error == ENOENT) return Outcome::missing;
  int status = 0;
  if (error != 0 || waitpid(child, &status, 0) != child) return Outcome::failed;
  throwIfInterrupted();  // Ctrl-C reaches gnuplot too, which says nothing of the script
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Outcome::done : Outcome::failed;
}

}  // namespace

std::string gnuplotQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "''" : std::string(1, letter);
  return quoted + "'";
}

bool drawSvg(const fs::path& svg, const std::string& script) {
  const fs::path scriptFile = fs::path(svg).replace_extension(".gp");
  writeTextFile(scriptFile, kStyle + script);
  const TemporaryFile temporary(svg);
  const Outcome outcome = runGnuplot(scriptFile, temporary.path());
  if (outcome == Outcome::failed)
    throw std::runtime_error(
        fmt::format("gnuplot could not draw '{}'; run it on that file to see why.", scriptFile.string()));
  if (outcome == Outcome::missing) return false;
  if (const std::error_code error = temporary.commit())
    throw std::runtime_error(fmt::format("Cannot write '{}': {}.", svg.string(), error.message()));
  return true;
}

}  // namespace host
