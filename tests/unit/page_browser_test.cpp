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

#include "host/commands/bench_page.h"
#include "host/image/image_file.h"
#include "tests/support/temporary_folder.h"

namespace host {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// What the browser is to do with the page, and to write into its title. The log's line shows that its log is
/// read.
constexpr const char* kProbe = R"(<script>
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
const shown = () => {
  const isVisible = part => part.offsetParent !== null;
  return Array.from(stage.querySelectorAll("img")).filter(isVisible).map(image => image.alt.split(": ")[1]).join("+") +
         (isVisible(view.querySelector(".split")) ? " with a line" : "");
};
found.push(shown());
for (const what of ["effect", "levels", "result"]) {
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
addEventListener("load", () => {
  found.push("broken " + Array.from(document.images).filter(image => !image.naturalWidth).length);
  document.title = found.join("; ");
  console.log("probe is done");
});
</script>
</body>)";

/// Of its standard output and error.
std::string outputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe && std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr)
    text += part.data();
  return text;
}

class PageInBrowser : public testing::Test {
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
    for (const char* subject : {"full", "mres", "effect_full", "effect_mres", "difference", "levels"}) {
      const std::string file = std::string(subject) + ".png";
      writeImage(folder_ / file, {{64, 64}, 3, std::vector<float>(std::size_t{64} * 64 * 3, 0.5f)});
      measurement.pictures[subject] = file;
    }
    return measurement;
  }

  Measurement timed(int camera, double referenceMs) {
    Measurement measurement = untimed(camera);
    measurement.times = InterleavedTimes{{{.wallMs = 10.0}}, {{.wallMs = referenceMs}}};
    return measurement;
  }

  /// The page with the probe, as the browser left it, after what the browser logged.
  std::string browse() {
    Json report = makeReport({"llvmpipe", "4.5", 2});
    for (const Measurement& measurement : {timed(0, 30.0), untimed(1), timed(2, 20.0), timed(3, 100.0)})
      report["results"].push_back(toJson(measurement));
    std::string page = makePage(report, {}, folder_);
    page.replace(page.rfind("</body>"), std::string("</body>").size(), kProbe);
    const fs::path file = folder_ / "page.html";
    std::ofstream(file) << page;
    return outputOf(
        "timeout 60 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr "
        "--user-data-dir='" +
        (folder_ / "profile").string() + "' --dump-dom 'file://" + file.string() + "'");
  }

  test::TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(PageInBrowser, ComparesSortsAndLogsNothing) {
  if (std::system("command -v chromium > /dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
  const std::string seen = browse();
  EXPECT_THAT(seen,
              HasSubstr("<title>right of the line 75%; then 50%, slider at 50; then 80%; "
                        "full resolution+multi-resolution with a line; "
                        "the effect at full resolution+the effect, multi-resolution with a line; level map; "
                        "full resolution+multi-resolution with a line; "
                        "natural width 64, less than before; ascending 2.00x 3.00x 10.00x -; "
                        "descending 10.00x 3.00x 2.00x -; broken 0</title>"));
  const std::size_t log = seen.find("CONSOLE");
  ASSERT_NE(log, std::string::npos) << "the browser's log is not seen";
  EXPECT_THAT(seen.substr(log, 200), HasSubstr("probe is done"));
  EXPECT_EQ(seen.find("CONSOLE", log + 1), std::string::npos) << seen;
}

}  // namespace
}  // namespace host
