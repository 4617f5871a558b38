#pragma once

namespace host {

/// Runs `mres` with the arguments of main(). Returns the exit code: 0 done, 1 failed, 2 wrong usage.
int runCommandLine(int argc, const char* const* argv);

}  // namespace host
