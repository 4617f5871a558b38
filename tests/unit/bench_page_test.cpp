// The page that shows the results of `mres bench`.
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "host/bench/page.h"
#include "host/bench/plots.h"
#include "host/bench/results.h"
#include "host/bench/summary.h"
#include "host/image/image_file.h"
#include "host/measure/picture_names.h"
#include "host/measure/report.h"
#include "tests/unit/bench_support.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// A tiny picture under each name that a page shows.
Json picturesIn(const fs::path& folder) {
  Json pictures{{kDifferenceEnhancementName, 8.0}};
  for (const char* subject : kViewPictures) {
    const std::string file = std::string(subject) + ".png";
    writeImage(folder / file, {{8, 4}, 3, std::vector<float>(8 * 4 * 3, 0.5f)});
    pictures[subject] = file;
  }
  return pictures;
}

TEST_F(Bench, ThePageHoldsAllThatItShows) {
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = picturesIn(folder_);
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  results.add(measurementOf(1, {64, 64}, 16));
  std::ofstream(folder_ / "stages.svg") << "<svg/>";
  const std::string page = makePage(results.report(), {Plot{"stages.svg", "Where the time goes"}}, folder_);
  EXPECT_THAT(page, AllOf(HasSubstr("hall &lt;1&gt;"), HasSubstr("2.00x"), HasSubstr("llvmpipe"),
                          HasSubstr(results.report()["version"].get<std::string>()),
                          HasSubstr(results.report()["commit"].get<std::string>()),
                          HasSubstr(results.report()["date"].get<std::string>()),
                          HasSubstr("difference, 8 times enhanced"), HasSubstr("alt=\"Where the time goes\""),
                          testing::Not(HasSubstr("hall <1>")), testing::Not(HasSubstr("{{"))));
  EXPECT_EQ(countOf(page, "src=\"data:image/jpeg;base64,"), 5U);
  EXPECT_EQ(countOf(page, "src=\"data:image/png;base64,"), 1U);
  EXPECT_EQ(countOf(page, "src=\"data:image/svg+xml;base64,"), 1U);
  EXPECT_EQ(countOf(page, "src="), 7U) << "something is not in the page";
  EXPECT_EQ(countOf(page, "http:") + countOf(page, "https:") + countOf(page, "url("), 0U);
}

TEST_F(Bench, ThePageDoesWithoutPicturesThatAreGone) {
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = picturesIn(folder_);
  fs::remove(folder_ / "mres.png");
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  EXPECT_EQ(countOf(makePage(results.report(), {}, folder_), "src="), 0U);
}

TEST_F(Bench, ThePageShowsWorstPlacesTheWorstFirst) {
  BenchResults results(file(), kMachine, false);
  for (const int camera : {0, 1, 2}) {
    Measurement measurement = measurementOf(camera, {64, 64}, 16);
    measurement.error->blocks.max = 0.1 + 0.1 * (camera % 2);
    if (camera < 2)
      for (const char* subject : kWorstPlacePictures)
        measurement.pictures[subject] = picturesIn(folder_)[kMresPicture];
    results.add(measurement);
  }
  const std::string page = makePage(results.report(), {}, folder_);
  EXPECT_THAT(page, testing::ContainsRegex("hall &lt;1&gt; 1.*block 0.200.*hall &lt;1&gt; 0.*block 0.100"));
  EXPECT_EQ(countOf(page, "src=\"data:image/jpeg;base64,"), 8U);
  fs::remove(folder_ / "mres.png");
  EXPECT_THAT(makePage(results.report(), {}, folder_), testing::Not(HasSubstr("Worst places")));
}

/// As XML, but for its script: that is no markup.
TEST_F(Bench, ThePageIsWellFormed) {
  if (std::system("command -v python3 > /dev/null") != 0) GTEST_SKIP() << "python3 is not installed";
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = picturesIn(folder_);
  measurement.truths = truthsOf(0.02, 0.03);
  measurement.warnings = {"Texture <7> & others are left out."};
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  std::string page = makePage(results.report(), {}, folder_);
  const std::size_t script = page.find("<script>");
  page.erase(script, page.find("</body>") - script);
  std::ofstream(folder_ / "page.xml") << page;
  EXPECT_EQ(std::system(("python3 -c 'import sys, xml.dom.minidom as dom; dom.parse(sys.argv[1])' '" +
                         (folder_ / "page.xml").string() + "'")
                            .c_str()),
            0);
}

TEST_F(Bench, ThePageNamesThePictureWithTheGreatestError) {
  Json report = makeReport(kMachine);
  for (const int camera : {0, 1}) report["results"].push_back(toJson(measurementOf(camera, {64, 64}, 16)));
  report["results"][1]["error"]["rms"] = 0.0251;
  EXPECT_THAT(makePage(report, {}, folder_),
              HasSubstr("The greatest RMS is 0.0251, of hall &lt;1&gt; 1, ssao, 16 samples, 64x64."));
  report["results"][1]["error"] = nullptr;
  EXPECT_THAT(makePage(report, {}, folder_),
              HasSubstr("The greatest RMS is 0.0100, of hall &lt;1&gt; 0, ssao, 16 samples, 64x64."));
  report["results"][0]["error"] = nullptr;
  EXPECT_THAT(makePage(report, {}, folder_), testing::Not(HasSubstr("The greatest RMS")));
}

TEST_F(Bench, ThePageTellsHowWellSpeedupsAreKnown) {
  Json report = makeReport(kMachine);
  report["results"].push_back(toJson(measurementOf(0, {64, 64}, 16)));
  EXPECT_THAT(makePage(report, {}, folder_),
              AllOf(HasSubstr("<p>" + speedupCertainty(report) + "</p>"), HasSubstr(">±%<")));
  Measurement untimed = measurementOf(0, {64, 64}, 16);
  untimed.times.reset();
  report["results"] = Json::array({toJson(untimed)});
  EXPECT_THAT(makePage(report, {}, folder_), testing::Not(HasSubstr("The speedup is known")));
}

TEST_F(Bench, ThePageTellsWhatScenesLackOnce) {
  Json report = makeReport(kMachine);
  EXPECT_THAT(makePage(report, {}, folder_), testing::Not(HasSubstr("What the scenes lack")));
  for (const int camera : {0, 1}) {
    Measurement measurement = measurementOf(camera, {64, 64}, 16);
    measurement.warnings = {"A light is left out."};
    report["results"].push_back(toJson(measurement));
  }
  const std::string page = makePage(report, {}, folder_);
  EXPECT_THAT(page, HasSubstr("What the scenes lack"));
  EXPECT_EQ(countOf(page, "A light is left out."), 1U);
}

TEST_F(Bench, ThePageTellsHowLongItTook) {
  Json report = makeReport(kMachine);
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.seconds = 300.0;
  report["results"].push_back(toJson(measurement));
  EXPECT_THAT(makePage(report, {}, folder_), HasSubstr("measured in 5 minutes"));
}

TEST_F(Bench, ThePageTellsTruthsWhereThereAreSome) {
  EXPECT_THAT(makePage(reportWithTruths(), {}, folder_),
              AllOf(HasSubstr("Against the truth"), HasSubstr("+50.0 %"), HasSubstr("loses nothing")));
  BenchResults results(file(), kMachine, false);
  fillReport(results);
  EXPECT_THAT(makePage(results.report(), {}, folder_), testing::Not(HasSubstr("Against the truth")));
}

}  // namespace
}  // namespace host::test
