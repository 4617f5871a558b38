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
const stage = document.querySelector(".stage");
const split = document.querySelector(".split");
split.value = 20;
split.dispatchEvent(new Event("input"));
found.push("line at " + stage.style.getPropertyValue("--split"));
const shown = () => Array.from(stage.querySelectorAll(".extra")).filter(part => part.offsetParent).length;
found.push("extras " + shown());
document.querySelector("[data-show=levels]").click();
found.push("then " + shown());
document.querySelector("[data-show='']").click();
found.push("then " + shown());
const tables = document.querySelectorAll(".sortable");
const table = tables[tables.length - 1];
const speedup = Array.from(table.tHead.rows[0].cells).find(cell => cell.textContent === "speedup");
const first = () => table.tBodies[0].rows[0].cells[speedup.cellIndex].textContent;
speedup.click();
found.push("least " + first());
speedup.click();
found.push("greatest " + first());
addEventListener("load", () => {
  found.push("broken " + Array.from(document.images).filter(image => !image.naturalWidth).length);
  document.title = found.join(", ");
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
  Json resultOf(int camera, double slowMs) {
    Measurement measurement;
    measurement.scene = "hall";
    measurement.camera = camera;
    measurement.size = {64, 64};
    measurement.effect = "ssao";
    measurement.samples = 64;
    measurement.technique = "mres";
    measurement.settings = {{"radius", 0.5}};
    measurement.times = InterleavedTimes{{{.wallMs = 10.0}}, {{.wallMs = slowMs}}};
    measurement.error = ErrorMetrics{};
    for (const char* subject : {"full", "mres", "difference", "levels"}) {
      const std::string file = std::string(subject) + ".png";
      writeImage(folder_ / file, {{64, 64}, 3, std::vector<float>(std::size_t{64} * 64 * 3, 0.5f)});
      measurement.pictures[subject] = file;
    }
    return toJson(measurement);
  }

  /// The page with the probe, as the browser left it, after what the browser logged.
  std::string browse() {
    Json report = makeReport({"llvmpipe", "4.5", 2});
    report["results"] = {resultOf(0, 30.0), resultOf(1, 20.0), resultOf(2, 100.0)};
    std::string page = makePage(report, {}, folder_);
    page.replace(page.rfind("</body>"), std::string("</body>").size(), kProbe);
    const fs::path file = folder_ / "page.html";
    std::ofstream(file) << page;
    return outputOf(
        "chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr --user-data-dir='" +
        (folder_ / "profile").string() + "' --dump-dom 'file://" + file.string() + "'");
  }

  test::TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(PageInBrowser, ComparesSortsAndLogsNothing) {
  if (std::system("command -v chromium > /dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
  const std::string seen = browse();
  EXPECT_THAT(seen, HasSubstr("<title>line at 20%, extras 0, then 1, then 0, least 2.00x, greatest 10.00x, "
                              "broken 0</title>"));
  const std::size_t log = seen.find("CONSOLE");
  ASSERT_NE(log, std::string::npos) << "the browser's log is not seen";
  EXPECT_THAT(seen.substr(log, 200), HasSubstr("probe is done"));
  EXPECT_EQ(seen.find("CONSOLE", log + 1), std::string::npos) << seen;
}

}  // namespace
}  // namespace host
