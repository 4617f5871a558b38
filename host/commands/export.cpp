#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>

#include "host/commands/commands.h"
#include "host/console/interruption.h"
#include "host/console/notes.h"
#include "host/console/options.h"
#include "host/console/output.h"
#include "host/console/usage_error.h"
#include "host/scene/gltf/gltf_writer.h"

namespace host {
namespace {

struct ExportOptions {
  ViewOptions view;
  std::filesystem::path output;
};

constexpr const char* kExamples = R"(
Examples:
  mres export hall --camera 3 -o hall.glb     for other renderers: the hall and one of its cameras
  mres export room.gltf --camera all -o room.glb

The file holds what mres sees: triangles, normals, base colours, holes of alpha masks, and the cameras, also those that
mres found itself or read from NAME.cameras.json. Lights and other textures are left out.)";

bool isGlb(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return extension == ".glb";
}

void runExport(const ExportOptions& options) {
  if (!isGlb(options.output))
    throw UsageError(fmt::format("'{}' is no file that mres can export to; end its name with .glb.",
                                 options.output.string()));
  requireWritableFile(options.output);
  const Scene scene = loadScene(options.view.scene);
  const std::vector<int> cameras = camerasOf(scene, options.view.camera);
  throwIfInterrupted();
  writeNotes(std::cerr, scene.warnings);
  writeTextFile(options.output, toGlb(scene, cameras));
  fmt::print("{}\n", options.output.string());
}

}  // namespace

void addExportCommand(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("export", "Write a scene and its cameras as glTF, for other renderers");
  const auto options = std::make_shared<ExportOptions>();
  addSceneOptions(*command, options->view);
  command->add_option("-o,--output", options->output, "the file, .glb")->required()->type_name("FILE");
  command->footer(kExamples);
  command->callback([&action, options] { action = [options] { runExport(*options); }; });
}

}  // namespace host
