// What the tests of commands that succeed share.
#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/process.h"
#include "tests/support/temporary_folder.h"

namespace host::test {

/// A scene, and a folder for what commands make of it.
class Command : public testing::Test {
 protected:
  /// Expects no word on stderr; returns what is on stdout.
  std::string succeed(const std::vector<std::string>& arguments);
  /// The one result of a small comparison without times.
  nlohmann::json untimedComparison(const std::vector<std::string>& options);
  [[nodiscard]] std::vector<std::string> filesBelow(const std::string& name) const;

  TemporaryFolder folder_;
  std::string scene_ = writeCornerScene(folder_);
};

}  // namespace host::test
