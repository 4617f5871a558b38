#pragma once

#include <stdexcept>

namespace host {

/// The command line asks for something that cannot be, whatever the machine and the scene: exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace host
