#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

#include "host/commands/commands.h"
#include "host/console/options.h"
#include "host/measure/report.h"
#include "host/platform/gl_context.h"

namespace host {
namespace {

int limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

std::string shadingLanguage() {
  const GLubyte* version = glGetString(GL_SHADING_LANGUAGE_VERSION);
  return version == nullptr ? "unknown" : reinterpret_cast<const char*>(version);
}

Json describeSystem(const GlContext::Info& gl) {
  Json info = makeReport(machineOf(gl.renderer, gl.version));
  info.erase("results");
  info["gl"] = {{"vendor", gl.vendor},       {"renderer", gl.renderer}, {"version", gl.version},
                {"glsl", shadingLanguage()}, {"platform", gl.platform}, {"software", gl.software}};
  info["limits"] = {{"texture_size", limit(GL_MAX_TEXTURE_SIZE)},
                    {"uniform_block_bytes", limit(GL_MAX_UNIFORM_BLOCK_SIZE)},
                    {"fragment_texture_units", limit(GL_MAX_TEXTURE_IMAGE_UNITS)},
                    {"samples", limit(GL_MAX_SAMPLES)}};
  info["scenes"] = builtinSceneNames();
  info["effects"] = effectNames();
  info["techniques"] = techniqueNames();
  return info;
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

void print(const Json& info) {
  const Json& gl = info["gl"];
  const auto text = [](const Json& value) { return value.get<std::string>(); };
  std::vector<std::vector<std::string>> rows{
      {"mres", text(info["version"])},
      {"device", text(gl["renderer"]) + (gl["software"].get<bool>() ? " (on the CPU)" : "")},
      {"vendor", text(gl["vendor"])},
      {"OpenGL",
       fmt::format("{}, GLSL {}, through {}", text(gl["version"]), text(gl["glsl"]), text(gl["platform"]))},
      {"cores", info["machine"]["cores"].dump()}};
  for (const auto& [name, value] : info["limits"].items()) rows.push_back({"max " + name, value.dump()});
  rows.push_back({"scenes", joined(info["scenes"].get<std::vector<std::string>>())});
  rows.push_back({"effects", joined(info["effects"].get<std::vector<std::string>>())});
  rows.push_back({"techniques", joined(info["techniques"].get<std::vector<std::string>>())});
  for (const auto& row : rows) fmt::print("{:<28}{}\n", row[0], row[1]);
}

void runInfo(bool json) {
  const GlContext context;
  const Json info = describeSystem(context.info());
  if (json)
    fmt::print("{}", toText(info));
  else
    print(info);
}

}  // namespace

void addInfoCommand(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("info", "Show the OpenGL device, its limits, scenes, effects and techniques");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "print JSON");
  command->callback([&action, json] { action = [json] { runInfo(*json); }; });
}

}  // namespace host
