// The page of `mres bench` as a browser shows it: headless Chromium, where it is installed.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

#include "host/bench/page.h"
#include "host/image/image_file.h"
#include "host/measure/picture_names.h"
#include "tests/unit/bench_support.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// What the browser is to do with the page once all pictures are loaded, and to write into its title.
/// Pictures are told apart by their blue, too: only those that are loaded have some. The log's line shows
/// that its log is read.
constexpr const char* kProbe = R"(<script>
addEventListener("load", () => {
const found = [];
const view = document.querySelector(".view");
const stage = view.querySelector(".stage");
const point = (type, share) => {
  const box = stage.getBoundingClientRect();
  stage.dispatchEvent(new PointerEvent(type, { clientX: box.left + share * box.width, buttons: 1 }));
};
const clip = () => getComputedStyle(stage.querySelector(".mres")).clipPath.match(/[\d.]+%/)[0];
point("pointerdown", 0.25);
found.push("right of the line " + clip());
point("pointermove", 0.5);
found.push("then " + clip() + ", slider at " + view.querySelector(".split").value);
view.querySelector(".split").value = 20;
view.querySelector(".split").dispatchEvent(new Event("input"));
found.push("then " + clip());
const isVisible = part => part.offsetParent !== null;
const blueOf = image => {
  const pixels = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  pixels.drawImage(image, 0, 0);
  return (pixels.getImageData(32, 32, 1, 1).data[2] / 255).toFixed(1);
};
const legend = view.querySelector(".legend");
const shown = () => {
  const pictures = Array.from(stage.querySelectorAll("img")).filter(isVisible);
  return pictures.map(image => image.alt.split(": ")[1] + " " + blueOf(image)).join("+") +
         (isVisible(view.querySelector(".split")) ? " with a line" : "") +
         (isVisible(legend) ? ", " + legend.textContent.replace(/\s+/g, " ") : "");
};
found.push(shown());
for (const what of ["effect", "levels", "difference", "result"]) {
  view.querySelector("[data-show=" + what + "]").click();
  found.push(shown());
}
const width = () => stage.querySelector("img").getBoundingClientRect().width;
const wide = width();
view.querySelector(".natural-size").click();
found.push("natural width " + width() + (wide > width() ? ", less than before" : ""));
const tables = document.querySelectorAll(".sortable");
const table = tables[tables.length - 1];
const heading = Array.from(table.tHead.rows[0].cells).find(cell => cell.textContent === "speedup");
const speedups = () => Array.from(table.tBodies[0].rows).map(row => row.cells[heading.cellIndex].textContent).join(" ");
for (const direction of ["ascending", "descending"]) {
  heading.querySelector("button").click();
  found.push(heading.getAttribute("aria-sort") + " " + speedups());
}
found.push("places " + Array.from(document.querySelectorAll(".place img")).filter(isVisible).length);
found.push("broken " + Array.from(document.images).filter(image => !image.naturalWidth).length);
found.push("different pictures " + new Set(Array.from(stage.querySelectorAll("img"), image => image.src)).size);
for (const plot of document.querySelectorAll(".plots img"))
  found.push(plot.alt + " " + plot.naturalWidth + "x" + plot.naturalHeight + (isVisible(plot) ? ", shown" : ""));
const titlesOf = table => Array.from(table.tHead.rows[0].cells, cell => cell.textContent);
const truths = Array.from(tables).find(table => titlesOf(table).includes("truth"));
found.push("truths" + (isVisible(truths) ? ", shown" : ""));
for (const row of truths.tBodies[0].rows) found.push(Array.from(row.cells, cell => cell.textContent).join(" | "));
document.title = found.join("; ");
console.log("probe is done");
});
</script>
</body>)";

/// Has what gnuplot's plots have: a size, a namespace, references within it and no script.
constexpr const char* kPlot = R"svg(<?xml version="1.0" encoding="utf-8" standalone="no"?>
<svg width="820" height="540" viewBox="0 0 820 540" xmlns="http://www.w3.org/2000/svg"
     xmlns:xlink="http://www.w3.org/1999/xlink">
<title>Gnuplot</title>
<rect x="0" y="0" width="820" height="540" fill="#ffffff"/>
<defs><circle id="gpPt5" stroke-width="0.2" stroke="currentColor" cx="0" cy="0" r="1"/></defs>
<path stroke="black" fill="none" d="M80,480 L780,480 M80,480 L80,40"/>
<use xlink:href="#gpPt5" transform="translate(400,200) scale(4)" color="#0072b2"/>
<text x="400" y="520" font-family="sans-serif" font-size="13">megapixels</text>
</svg>
)svg";

/// Shades from left to right and from top to bottom: no two of different `blue` are alike.
FloatImage gradient(float blue) {
  constexpr int kSide = 64;
  FloatImage image{{kSide, kSide}, 3, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      image.pixels.insert(image.pixels.end(), {static_cast<float>(x) / static_cast<float>(kSide),
                                               static_cast<float>(y) / static_cast<float>(kSide), blue});
  return image;
}

/// Of its standard output and error.
std::string outputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe && std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr)
    text += part.data();
  return text;
}

class PageInBrowser : public Bench {
 protected:
  Measurement untimed(int camera) {
    Measurement measurement;
    measurement.scene = "hall";
    measurement.camera = camera;
    measurement.size = {64, 64};
    measurement.effect = "ssao";
    measurement.samples = 64;
    measurement.technique = "mres";
    measurement.settings = {{"radius", 0.5}};
    measurement.error = ErrorMetrics{};
    float blue = 0.0f;
    for (const char* subject : kViewPictures) {
      blue += 0.1f;
      const std::string file = std::string(subject) + ".png";
      writeImage(folder_ / file, gradient(blue));
      measurement.pictures[subject] = file;
    }
    for (const char* subject : kWorstPlacePictures) measurement.pictures[subject] = "mres.png";
    return measurement;
  }

  Measurement timed(int camera, double referenceMs) {
    Measurement measurement = untimed(camera);
    measurement.times = InterleavedTimes{{{.wallMs = 10.0}}, {{.wallMs = referenceMs}}};
    return measurement;
  }

  std::vector<Plot> plots() {
    fs::create_directory(folder_ / "plots");
    std::ofstream(folder_ / "plots/speedup.svg") << kPlot;
    return {Plot{"plots/speedup.svg", "Speedup"}};
  }

  /// The page with the probe, as the browser left it, after what the browser logged.
  std::string browse() {
    Measurement withTruth = timed(0, 30.0);
    withTruth.truths = truthsOf(0.02, 0.03);
    Json report = makeReport(kMachine);
    for (const Measurement& measurement : {withTruth, untimed(1), timed(2, 20.0), timed(3, 100.0)})
      report["results"].push_back(toJson(measurement));
    std::string page = makePage(report, plots(), folder_);
    page.replace(page.rfind("</body>"), std::string("</body>").size(), kProbe);
    const fs::path file = folder_ / "page.html";
    std::ofstream(file) << page;
    return outputOf(
        "timeout 60 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr "
        "--user-data-dir='" +
        (folder_ / "profile").string() + "' --dump-dom 'file://" + file.string() + "'");
  }
};

TEST_F(PageInBrowser, ShowsAllComparesSortsAndLogsNothing) {
  if (std::system("command -v chromium > /dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
  const std::string seen = browse();
  EXPECT_THAT(seen,
              HasSubstr("<title>right of the line 75%; then 50%, slider at 50; then 80%; "
                        "full resolution 0.1+multi-resolution 0.2 with a line; "
                        "the effect at full resolution 0.3+the effect, multi-resolution 0.4 with a line; "
                        "level map 0.6, Red pixels were rendered at full resolution, green at half, blue at "
                        "a quarter, black at an eighth.; difference 0.5; "
                        "full resolution 0.1+multi-resolution 0.2 with a line; "
                        "natural width 64, less than before; ascending 2.00x 3.00x 10.00x -; "
                        "descending 10.00x 3.00x 2.00x -; places 16; broken 0; different pictures 6; Speedup "
                        "820x540, shown; "
                        "truths, shown; ssao | 64 | 64x64 | converged, 4096 samples | 1 | 0.0200 | 0.0300 | "
                        "+50.0 %</title>"));
  const std::size_t log = seen.find("CONSOLE");
  ASSERT_NE(log, std::string::npos) << "the browser's log is not seen";
  EXPECT_THAT(seen.substr(log, 200), HasSubstr("probe is done"));
  EXPECT_EQ(seen.find("CONSOLE", log + 1), std::string::npos) << seen;
}

}  // namespace
}  // namespace host::test
