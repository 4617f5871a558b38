#include "host/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/commands/commands.h"
#include "host/console/interruption.h"
#include "host/console/notes.h"
#include "host/console/parse.h"
#include "host/console/usage_error.h"

namespace host {
namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

constexpr const char* kFullOutput = "Cannot write to the standard output; is its disk full?";
constexpr const char* kFooter = R"(
Examples:
  mres compare hall --size 1080p -o out     speedup and error of multi-resolution SSAO, with pictures
  mres render office --camera 3 -o a.png    one picture
  mres bench --suite quick -o out           a small campaign with plots
  mres info                                 the OpenGL device, scenes, effects

SCENE is a built-in name (mres info lists them) or a .gltf or .glb file.
Exit codes: 0 done, 1 failed, 2 wrong usage. `mres COMMAND --help` tells more.)";

int fail(int code, const std::string& message) {
  fmt::print(stderr, "mres: {}\n", asSentence(message));
  return code;
}

/// The subcommand that the user was typing, for the hint.
std::string helpHint(const CLI::App& app) {
  const auto subcommands = app.get_subcommands();
  return fmt::format("`mres {}--help` shows how",
                     subcommands.empty() ? "" : subcommands.front()->get_name() + " ");
}

/// Whatever else is wrong: what a command does not take, or a command that there is not.
std::string wrongUsage(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> words = app.remaining();
  const bool isCommand = app.get_subcommands().empty() && !words.empty() && !words.front().starts_with('-');
  if (!isCommand) return fmt::format("{}; {}.", error.what(), helpHint(app));
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  return fmt::format("There is no command '{}'{}", words.front(), suggestion(words.front(), commands));
}

void flushOutput() {
  if (std::fflush(stdout) != 0) throw std::runtime_error(kFullOutput);
}

}  // namespace

int runCommandLine(int argc, const char* const* argv) {
  CLI::App app("Renders expensive screen-space effects at the resolution that each part of the screen needs.",
               "mres");
  app.footer(kFooter);
  app.set_version_flag("--version", "mres " MRES_VERSION);
  app.require_subcommand(0, 1);
  // Scripts add options to those of another: the last one counts, as in most programs.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  Action action = [&app] { fmt::print("{}", app.help()); };
  addInfoCommand(app, action);
  addRenderCommand(app, action);
  addCompareCommand(app, action);
  addBenchCommand(app, action);
  addExportCommand(app, action);

  try {
    app.parse(argc, argv);
    deferInterrupts();
    action();
    flushOutput();
    return kDone;
  } catch (const CLI::Success& request) {
    app.exit(request);
    return std::cout.flush() ? kDone : fail(kFailed, kFullOutput);
  } catch (const CLI::ParseError& error) {
    return fail(kWrongUsage, wrongUsage(app, error));
  } catch (const UsageError& error) {
    return fail(kWrongUsage, error.what());
  } catch (const Interrupted&) {
    endByInterrupt();
  } catch (const std::bad_alloc&) {
    return fail(kFailed, "There is not enough memory for this.");
  } catch (const std::exception& error) {
    return fail(kFailed, error.what());
  }
}

}  // namespace host
