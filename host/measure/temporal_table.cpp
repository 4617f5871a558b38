// Flicker for people: one row a picture.
#include <fmt/format.h>

#include "host/measure/report.h"
#include "host/measure/result_names.h"
#include "host/measure/text_table.h"

namespace host {
namespace {

std::vector<std::string> rowOf(const Json& result, const Json& temporal) {
  const auto number = [&temporal](const char* key) {
    return fmt::format("{:.4f}", temporal[key].get<double>());
  };
  const Json& ratio = temporal["ratio"];
  return {pictureOf(result),
          temporal["frames"].dump(),
          number("reference_change_rms"),
          number("rms"),
          ratio.is_null() ? "-" : fmt::format("{:.1f}", ratio.get<double>() * 100.0),
          number("block_p99"),
          number("block_max"),
          number("max")};
}

}  // namespace

std::string toTemporalTable(const Json& report) {
  std::vector<std::vector<std::string>> rows{{"scene camera effect", "frames", "full's change", "RMS",
                                              "% of that", "99 % of blocks", "worst block", "max"}};
  for (const Json& result : report["results"]) {
    const Json temporal = result.value("temporal", Json());
    if (!temporal.is_null()) rows.push_back(rowOf(result, temporal));
  }
  if (rows.size() == 1) return {};
  return "\nFlicker, the change of the error from frame to frame along a path of the camera:\n" +
         formatTable(rows);
}

}  // namespace host
