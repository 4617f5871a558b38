// What the commands have in common on the command line.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/console/settings_table.h"
#include "host/measure/interleaved.h"
#include "host/measure/picture_settings.h"

namespace host {

struct PictureOptions {
  PictureSettings settings;
  bool json = false;
};
/// --effect, --technique, --samples, --seed, --set, --importance, --shaders and --json. `options` must
/// outlive the command.
void addPictureOptions(CLI::App& command, PictureOptions& options);

struct ViewOptions {
  std::string scene = "hall";
  std::optional<int> camera = 0;  ///< none is all
  glm::ivec2 size{1920, 1080};
};
/// SCENE and --camera.
void addSceneOptions(CLI::App& command, ViewOptions& options);
/// Those and --size.
void addViewOptions(CLI::App& command, ViewOptions& options);

struct TimingOptions {
  bool timing = true;
  RepeatPlan repeat;

  /// Nothing where no timing is wanted.
  [[nodiscard]] std::optional<RepeatPlan> plan() const {
    return timing ? std::optional(repeat) : std::nullopt;
  }
};
/// --repeat and --no-timing. `figure`, such as "the speedup", is what gets known better with each repetition.
void addTimingOptions(CLI::App& command, TimingOptions& options, const std::string& figure);

/// The settings that --set knows.
SettingsTable settingsTable(PictureSettings& settings);

/// The values of those, and what else a picture depends on, for its report.
Json valuesOf(PictureSettings& settings);

/// All techniques, and all settings with defaults and meanings, for the end of a command's help.
std::string describeChoices();

/// Throws std::runtime_error with a sentence if the scene hasn't that camera.
void requireCamera(const Scene& scene, int camera);

/// The cameras to draw, 0-based: the one that was asked for, or all of them.
std::vector<int> camerasOf(const Scene& scene, std::optional<int> camera);

}  // namespace host
