#include "tests/unit/bench_support.h"

#include <fstream>
#include <iterator>

namespace host::test {

Measurement measurementOf(int camera, glm::ivec2 size, int samples) {
  Measurement measurement;
  measurement.scene = "hall <1>";
  measurement.cameraName = "nave";
  measurement.camera = camera;
  measurement.size = size;
  measurement.effect = "ssao";
  measurement.samples = samples;
  measurement.technique = "mres";
  measurement.reference = "full";
  measurement.settings = {{"samples", samples}};
  measurement.times =
      InterleavedTimes{{{.wallMs = 10.0}, {.wallMs = 11.0}}, {{.wallMs = 20.0}, {.wallMs = 22.0}}};
  measurement.error = ErrorMetrics{.rms = 0.01, .max = 0.3, .psnr = 40.0, .ssim = 0.99, .nonFinite = 0};
  measurement.coverage = {0.1, 1.0};
  measurement.stages = {{"edges", 3.0}, {"level0", 7.0}};
  return measurement;
}

std::vector<TruthErrors> truthsOf(double reference, double technique) {
  return {
      {"converged", "samples", 4096, 100, {.rms = technique, .max = 0.6}, {.rms = reference, .max = 0.5}}};
}

Json reportWithTruths() {
  Json report = makeReport(kMachine);
  for (const int camera : {0, 1, 2}) {
    Measurement measurement = measurementOf(camera, {64, 64}, 16);
    if (camera < 2) measurement.truths = truthsOf(0.01 + 0.02 * camera, 0.02 + 0.02 * camera);
    report["results"].push_back(toJson(measurement));
  }
  return report;
}

std::string contentsOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace host::test
