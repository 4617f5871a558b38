// mres_preprocess_shaders SHADERS OUTPUT: writes every vertex and fragment shader below SHADERS, its includes
// resolved, once with all of its switches off and once with each of them on, for a validator to read.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <set>
#include <string>

#include "mres/gl/shader_library.h"

namespace fs = std::filesystem;

namespace {

/// The names that `#if` asks for.
std::set<std::string> switchesOf(const std::string& text) {
  static const std::regex kSwitch(R"(#if !?([A-Z_]+))");
  std::set<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), kSwitch), end; match != end; ++match)
    names.insert((*match)[1].str());
  return names;
}

std::string defines(const std::set<std::string>& switches, const std::string& on) {
  std::string lines;
  for (const std::string& name : switches) lines += "#define " + name + (name == on ? " 1\n" : " 0\n");
  return lines;
}

void writeVariants(const mres::gl::ShaderLibrary& library, const std::string& name, const fs::path& output) {
  const std::set<std::string> switches = switchesOf(mres::gl::preprocess(library, name).text);
  std::set<std::string> variants = switches;
  variants.insert("");
  for (const std::string& on : variants) {
    std::string file =
        name.substr(0, name.rfind('.')) + (on.empty() ? "" : "-" + on) + name.substr(name.rfind('.'));
    std::ranges::replace(file, '/', '_');
    std::ofstream(output / file) << mres::gl::preprocess(library, name, defines(switches, on)).text;
  }
}

bool isShader(const fs::path& file) {
  return file.extension() == ".vert" || file.extension() == ".frag";
}

/// Not every effect has a preview().
bool compilesWith(const std::string& name, const mres::gl::ShaderLibrary& library) {
  return name != "mres/preview.frag" ||
         mres::gl::preprocess(library, "effect").text.find("preview(") != std::string::npos;
}

/// Every effect in turn takes the place of `#include "effect"`.
void writeAll(const fs::path& shaders, const fs::path& output) {
  for (const auto& effect : fs::directory_iterator(shaders / "effects")) {
    if (effect.path().extension() != ".glsl") continue;
    mres::gl::ShaderLibrary library;
    library.setDirectory(shaders);
    library.add("effect", "#include \"effects/" + effect.path().filename().string() + "\"\n");
    const fs::path folder = output / effect.path().stem();
    fs::create_directories(folder);
    for (const auto& entry : fs::recursive_directory_iterator(shaders)) {
      const std::string name = fs::relative(entry.path(), shaders).generic_string();
      if (isShader(name) && compilesWith(name, library)) writeVariants(library, name, folder);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw std::invalid_argument("give the shaders' folder and one for the output");
    writeAll(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "mres_preprocess_shaders: " << error.what() << '\n';
    return 1;
  }
}
