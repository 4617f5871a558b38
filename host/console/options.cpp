#include "host/console/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <numeric>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "host/console/parse.h"
#include "host/console/usage_error.h"

namespace host {
namespace {

constexpr int kMostRepetitions = 10000;

std::vector<std::string> effectChoices() {
  std::vector<std::string> choices = effectNames();
  choices.emplace_back(kNoEffect);
  return choices;
}

std::string listOf(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : " or ") + name;
  return list;
}

std::string parseEffect(const std::string& name) {
  const std::vector<std::string> choices = effectChoices();
  if (std::ranges::find(choices, name) != choices.end()) return name;
  throw UsageError(fmt::format("There is no effect '{}'{}", name, suggestion(name, choices)));
}

std::string parseTechnique(const std::string& name) {
  if (std::ranges::find(techniqueNames(), name) != techniqueNames().end()) return name;
  throw UsageError(fmt::format("There is no technique '{}'{}", name, suggestion(name, techniqueNames())));
}

std::string parseShaderFolder(const std::string& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw UsageError(fmt::format("'{}' is no folder of shaders; give one that exists.", folder));
  return folder;
}

template <class Apply>
CLI::Option* addText(CLI::App& command, const std::string& name, const char* value, const Apply& apply,
                     const std::string& description) {
  return command.add_option_function<std::string>(name, apply, description)->type_name(value);
}

std::string describeTechniques() {
  std::string text = "\n\nTechniques of --technique:\n";
  for (const TechniqueChoice& choice : techniques())
    text += fmt::format("  {}: {}\n", choice.name, choice.meaning);
  return text;
}

}  // namespace

SettingsTable settingsTable(PictureSettings& settings) {
  SettingsTable table;
  visitEffect(settings, [&table](auto& effect) {
    table.add(effect);
    for (std::size_t level = 0; level < effect.levels.size(); ++level)
      table.add(effect.levels[level], fmt::format("level{}.", level));
  });
  table.add(settings.plan);
  table.add(settings.mask);
  table.add(settings.renderer);
  return table;
}

Json valuesOf(PictureSettings& settings) {
  Json values = settingsTable(settings).values();
  if (!settings.importance.empty()) values["importance"] = settings.importance;
  return values;
}

std::string describeChoices() {
  std::string text = describeTechniques();
  for (const std::string& effect : effectNames()) {
    PictureSettings defaults;
    defaults.effect = effect;
    text += fmt::format("\n\nSettings of --set with --effect {}, and their defaults:\n", effect) +
            settingsTable(defaults).describe();
  }
  return text;
}

void addPictureOptions(CLI::App& command, PictureOptions& options) {
  PictureSettings& settings = options.settings;
  const auto assign = [&settings](const Assignment& assignment) { settingsTable(settings).set(assignment); };
  addText(
      command, "--effect", "NAME", [&](const std::string& name) { settings.effect = parseEffect(name); },
      fmt::format("{} (default {})", listOf(effectChoices()), settings.effect));
  addText(
      command, "--technique", "NAME",
      [&](const std::string& name) { settings.technique = parseTechnique(name); },
      fmt::format("how the effect is rendered; techniques are listed below (default {})",
                  settings.technique));
  addText(
      command, "--samples", "N",
      [=](const std::string& value) {
        assign({"samples", value});
      },
      "samples a pixel of the effect");
  addText(
      command, "--seed", "N",
      [=](const std::string& value) {
        assign({"seed", value});
      },
      "chooses the effect's sample points (default 0)");
  command
      .add_option_function<std::vector<std::string>>(
          "--set",
          [=](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) assign(parseAssignment(text));
          },
          "any setting, as often as needed; they are listed below")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  addText(
      command, "--importance", "FILE", [&settings](const std::string& file) { settings.importance = file; },
      "picture over the screen, black to white: where to refine, besides or instead of at edges, see "
      "combination");
  addText(
      command, "--shaders", "DIR",
      [&settings](const std::string& folder) {
        settings.renderer.shaderDirectory = parseShaderFolder(folder);
      },
      "folder whose shaders win over the built-in ones of the same name, such as a copy of shaders/");
  command.add_flag("--json", options.json, "print the report as JSON on the standard output");
}

void addSceneOptions(CLI::App& command, ViewOptions& options) {
  command
      .add_option("SCENE", options.scene, "a built-in scene (mres info lists them), a .gltf or a .glb file")
      ->type_name("")
      ->capture_default_str();
  addText(
      command, "--camera", "N", [&](const std::string& text) { options.camera = parseCamera(text); },
      "camera, from 0 on (default 0); `all` where several make sense");
}

void addViewOptions(CLI::App& command, ViewOptions& options) {
  addSceneOptions(command, options);
  addText(
      command, "--size", "WxH", [&](const std::string& text) { options.size = parseSize(text); },
      fmt::format("pixels up to {0}x{0}, or 720p, 1080p, 1440p, 4k (default {1}x{2})", kMaxImageSize,
                  options.size.x, options.size.y));
}

void addTimingOptions(CLI::App& command, TimingOptions& options, const std::string& figure) {
  RepeatPlan& plan = options.repeat;
  CLI::Option* repeat = addText(
      command, "--repeat", "N",
      [&plan](const std::string& text) { plan.pairs = parseCount(text, "repetitions", 1, kMostRepetitions); },
      fmt::format("timed repetitions (default: {} to {}, until {} is known within {:.0f} %, or for {} s; "
                  "fewer where {} would take "
                  "longer than {} s)",
                  plan.minPairs, plan.maxPairs, figure, plan.precision * 100.0, plan.maxSeconds,
                  plan.minPairs, plan.maxSecondsOfMinPairs));
  command
      .add_flag_callback(
          "--no-timing", [&options] { options.timing = false; }, "take no times")
      ->excludes(repeat);
}

void requireCamera(const Scene& scene, int camera) {
  const auto count = static_cast<int>(scene.cameras.size());
  if (camera < count) return;
  throw std::runtime_error(fmt::format("The scene '{}' has no camera {}; give {}.", scene.name, camera,
                                       count == 1 ? "0, its only one" : fmt::format("0 to {}", count - 1)));
}

std::vector<int> camerasOf(const Scene& scene, std::optional<int> camera) {
  if (camera) {
    requireCamera(scene, *camera);
    return {*camera};
  }
  std::vector<int> all(scene.cameras.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace host
