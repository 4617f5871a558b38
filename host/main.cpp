#include "host/commands/command_line.h"

int main(int argc, char** argv) {
  return host::runCommandLine(argc, argv);
}
