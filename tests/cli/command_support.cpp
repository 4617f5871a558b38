#include "tests/cli/command_support.h"

#include <algorithm>
#include <filesystem>

namespace host::test {
namespace fs = std::filesystem;
using nlohmann::json;

std::string Command::succeed(const std::vector<std::string>& arguments) {
  const ProcessResult result = runMres(arguments);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

json Command::untimedComparison(const std::vector<std::string>& options) {
  std::vector<std::string> arguments{"compare", scene_,        "--size", "64x36", "--samples",
                                     "8",       "--no-timing", "--json", "-o",    folder_ / "out"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return json::parse(succeed(arguments))["results"].at(0);
}

std::vector<std::string> Command::filesBelow(const std::string& name) const {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / name))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder_.path() / name).string());
  std::ranges::sort(files);
  return files;
}

}  // namespace host::test
