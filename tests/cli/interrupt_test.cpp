// Interrupts: what is done is kept, and nothing is left half written.
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/command_support.h"
#include "tests/cli/process.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// Waits for a file or folder that a running command makes.
bool appears(const fs::path& path) {
  constexpr int kMostTries = 3000;
  for (int i = 0; i < kMostTries && !fs::exists(path); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  return fs::exists(path);
}

TEST_F(Command, AnInterruptLeavesNothingHalfWritten) {
  const fs::path output = folder_.path() / "out";
  RunningMres run({"compare", "hall", "--size", "720p", "--repeat", "10000", "-o", output.string()}, {});
  ASSERT_TRUE(appears(output));
  run.interrupt();
  const ProcessResult result = run.wait();
  EXPECT_EQ(result.exitCode, 128 + SIGINT) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_FALSE(fs::exists(output));
}

TEST_F(Command, AnInterruptKeepsTheCamerasThatAreDone) {
  const fs::path output = folder_.path() / "out";
  RunningMres run(
      {"compare", "office", "--camera", "all", "--size", "720p", "--no-timing", "-o", output.string()}, {});
  ASSERT_TRUE(appears(output / "camera-1"));
  run.interrupt();
  EXPECT_EQ(run.wait().exitCode, 128 + SIGINT);
  const json results = json::parse(readFile(output / "report.json"))["results"];
  ASSERT_GE(results.size(), 1U);
  EXPECT_LT(results.size(), 8U);
  for (const json& result : results)
    EXPECT_TRUE(fs::exists(output / result["pictures"]["levels"].get<std::string>()));
  for (const std::string& file : filesBelow("out")) EXPECT_THAT(file, testing::Not(HasSubstr(".partial")));
}

TEST_F(Command, AnInterruptedBenchGoesOn) {
  const fs::path output = folder_.path() / "bench";
  const auto arguments = [&](const std::string& pairs) {
    return std::vector<std::string>{"bench", "--suite",       "smoke",    "--scenes", scene_,
                                    "-o",    output.string(), "--repeat", pairs};
  };
  RunningMres run(arguments("300"), {});
  ASSERT_TRUE(appears(output / "results.json"));
  run.interrupt();
  const ProcessResult interrupted = run.wait();
  EXPECT_EQ(interrupted.exitCode, 128 + SIGINT) << interrupted.err;
  EXPECT_THAT(interrupted.err, HasSubstr("--resume goes on"));
  EXPECT_FALSE(fs::exists(output / "report.html"));
  const json kept = json::parse(readFile(output / "results.json"))["results"];
  ASSERT_GE(kept.size(), 1U);
  ASSERT_LT(kept.size(), 4U);

  std::vector<std::string> resumed = arguments("2");
  resumed.emplace_back("--resume");
  ASSERT_EQ(runMres(resumed).exitCode, 0);
  const json results = json::parse(readFile(output / "results.json"))["results"];
  ASSERT_EQ(results.size(), 4U);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(results[i], kept[i]) << "was measured again";
}

}  // namespace
}  // namespace host::test
