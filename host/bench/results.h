#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// What a result has to have besides errors.
struct WantedParts {
  bool times = false;
  bool truth = false;
  bool temporal = false;
};

/// What a campaign left in `file`. Throws std::runtime_error with a sentence if that is no sound report.
Json readResults(const std::filesystem::path& file);

/// What to tell when a build of `commit` goes on with results of one of the same commit: with "+" behind it
/// (see source_commit.h) the two need not be of the same changes. A sentence each.
std::vector<std::string> notesOfResuming(const std::string& commit);

/// The results.json of a campaign: on disk after every measurement, so that an interrupted campaign can go
/// on.
class BenchResults {
 public:
  /// With `resume`, starts from what `file` holds, with notesOfResuming() on stderr. Throws
  /// std::runtime_error with a sentence if that is no sound report, or one of another machine, version or
  /// commit of mres. Without, a file that is there is renamed to *.previous.json, which is told on stderr.
  BenchResults(std::filesystem::path file, const Machine& machine, bool resume);

  /// Whether the picture that `wanted` describes was measured with these settings and has those parts.
  [[nodiscard]] bool contains(const Measurement& wanted, WantedParts parts) const;

  /// Adds a result, in place of an older one of the same picture, and writes the file.
  void add(const Measurement& measurement);

  [[nodiscard]] const Json& report() const { return report_; }

 private:
  std::filesystem::path file_;
  Json report_;
};

}  // namespace host
