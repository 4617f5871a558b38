// The subcommands. Each function adds one to the command line and leaves in `action` what it does, to be run
// after all arguments are known to be right.
#pragma once

#include <CLI/App.hpp>
#include <functional>

namespace host {

using Action = std::function<void()>;

void addInfoCommand(CLI::App& app, Action& action);
void addRenderCommand(CLI::App& app, Action& action);
void addCompareCommand(CLI::App& app, Action& action);
void addExportCommand(CLI::App& app, Action& action);
void addBenchCommand(CLI::App& app, Action& action);

}  // namespace host
