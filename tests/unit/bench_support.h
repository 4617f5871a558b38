// What the tests of `mres bench` share: results that nothing was measured for, and a folder to keep them in.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "host/bench/results.h"
#include "host/measure/report.h"
#include "tests/support/temporary_folder.h"

namespace host::test {

inline const Machine kMachine{"llvmpipe", "4.5", 2};

Measurement measurementOf(int camera, glm::ivec2 size, int samples);

/// Errors of both against one truth.
std::vector<TruthErrors> truthsOf(double reference, double technique);

/// Of three views, two of which have truths.
Json reportWithTruths();

std::string contentsOf(const std::filesystem::path& file);

std::size_t countOf(const std::string& text, const std::string& part);

class Bench : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "results.json"; }
  void fillReport(BenchResults& results) {
    for (const int samples : {16, 64}) results.add(measurementOf(0, {1920, 1080}, samples));
    results.add(measurementOf(0, {3840, 2160}, 64));
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
};

}  // namespace host::test
