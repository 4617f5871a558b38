#include "host/scene/gltf/document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/scene/gltf/container.h"
#include "host/scene/gltf/resource.h"

namespace host::gltf {
namespace {

using Json = nlohmann::json;

// tinygltf walks extras and extensions recursively. Deeper nesting than this is no scene but an attack on the
// stack.
constexpr int kMaxJsonDepth = 128;

// Honoured in full, or by the approximation that loader and materials document.
constexpr std::array<std::string_view, 9> kHonouredExtensions = {"KHR_mesh_quantization",
                                                                 "KHR_texture_transform",
                                                                 "KHR_lights_punctual",
                                                                 "KHR_materials_unlit",
                                                                 "KHR_node_visibility",
                                                                 "KHR_materials_emissive_strength",
                                                                 "KHR_materials_pbrSpecularGlossiness",
                                                                 "EXT_texture_webp",
                                                                 "KHR_xmp_json_ld"};

bool isHonoured(const std::string& extension) {
  return std::find(kHonouredExtensions.begin(), kHonouredExtensions.end(), extension) !=
         kHonouredExtensions.end();
}

/// A file may be shown without these even where it requires them: the surface looks plainer, or stands still.
bool isDispensable(const std::string& extension) {
  return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_animation_");
}

/// glTF lets integers be written as 1.0, tinygltf does not.
void makeIntegral(Json& value) {
  constexpr double kMaxExact = 9007199254740992.0;  // 2^53, beyond which doubles skip integers
  if (!value.is_number_float()) return;
  const double number = value.get<double>();
  if (std::abs(number) <= kMaxExact && number == std::floor(number)) value = std::int64_t(number);
}

/// Prepares all values for tinygltf. Iterative, as the point is to find out whether recursion would be safe.
void prepare(Json& root) {
  std::vector<std::pair<Json*, int>> pending = {{&root, 0}};
  while (!pending.empty()) {
    const auto [value, depth] = pending.back();
    pending.pop_back();
    if (depth > kMaxJsonDepth)
      throw std::runtime_error("its JSON is nested too deeply; export the file again");
    makeIntegral(*value);
    if (!value->is_structured()) continue;
    for (Json& child : *value) pending.emplace_back(&child, depth + 1);
  }
}

Json parseJson(std::string_view text) {
  const auto start = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");  // a byte order mark, spaces
  if (start == std::string_view::npos || text[start] != '{') {
    throw std::runtime_error("it is not a glTF file; name a .gltf or .glb file");
  }
  try {
    Json json = Json::parse(text);
    prepare(json);
    return json;
  } catch (const Json::parse_error& error) {
    throw std::runtime_error(fmt::format("its JSON is broken at byte {}; get a complete copy", error.byte));
  } catch (const Json::exception&) {
    throw std::runtime_error("its JSON has a number out of range; export the file again");
  }
}

std::string stringMember(const Json& object, const char* name) {
  const auto member = object.find(name);
  return member != object.end() && member->is_string() ? member->get<std::string>() : std::string();
}

std::optional<std::int64_t> integerMember(const Json& object, const char* name) {
  const auto member = object.find(name);
  if (member == object.end() || !member->is_number_integer()) return std::nullopt;
  return member->get<std::int64_t>();
}

/// Major and minor of a version such as "2.0"; nothing where it is none.
std::optional<std::pair<int, int>> parseVersion(const std::string& text) {
  int major = 0;
  int minor = 0;
  // NOLINTNEXTLINE(cert-err34-c): overflow would need a version above two billion, which is refused all the
  // same.
  if (std::sscanf(text.c_str(), "%d.%d", &major, &minor) != 2) return std::nullopt;
  return std::pair(major, minor);
}

void checkVersion(const Json& json) {
  const auto asset = json.find("asset");
  if (asset == json.end() || !asset->is_object()) {
    throw std::runtime_error("it has no asset object, so it is not glTF; name a .gltf or .glb file");
  }
  const std::string text = stringMember(*asset, "version");
  const auto version = parseVersion(text);
  if (!version || version->first != 2) {
    throw std::runtime_error(
        fmt::format("its version is '{}', but only glTF 2.0 is known; export as glTF 2.0", text));
  }
  const auto minimum = parseVersion(stringMember(*asset, "minVersion"));
  if (minimum && *minimum > std::pair(2, 0)) {
    throw std::runtime_error(fmt::format("it needs glTF {}.{}, but only 2.0 is known; export as glTF 2.0",
                                         minimum->first, minimum->second));
  }
}

/// The objects of a top-level array. Entries that are no objects are an error, so that indices keep their
/// meaning.
std::vector<Json> takeArray(Json& json, const char* name) {
  const auto member = json.find(name);
  if (member == json.end()) return {};
  if (!member->is_array()) {
    throw std::runtime_error(fmt::format("its '{}' are not an array; export the file again", name));
  }
  std::vector<Json> entries = std::move(member->get_ref<Json::array_t&>());
  json.erase(member);
  if (!std::all_of(entries.begin(), entries.end(), [](const Json& entry) { return entry.is_object(); })) {
    throw std::runtime_error(fmt::format("one of its '{}' is not an object; export the file again", name));
  }
  return entries;
}

Bytes readBuffer(const Json& buffer, std::size_t index, const Container& container,
                 const std::filesystem::path& folder) {
  const auto length = integerMember(buffer, "byteLength");
  if (!length || *length < 1) {
    throw std::runtime_error(fmt::format("buffer {} has no valid byteLength; export the file again", index));
  }
  Bytes bytes;
  if (const std::string uri = stringMember(buffer, "uri"); !uri.empty()) {
    try {
      bytes = readUri(uri, folder);
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("buffer {}: {}", index, error.what()));
    }
  } else if (index == 0 && container.binary) {
    bytes.assign(container.binary->begin(), container.binary->end());
  } else {
    return {};  // Extensions may leave a buffer without data; whoever reads from it is told that it is too
                // short.
  }
  if (bytes.size() < std::uint64_t(*length)) {
    throw std::runtime_error(
        fmt::format("buffer {} should have {} bytes, but only {} are there; get a complete copy", index,
                    *length, bytes.size()));
  }
  bytes.resize(std::size_t(*length));
  return bytes;
}

ImageSource imageSource(const Json& image) {
  return {stringMember(image, "name"), stringMember(image, "uri"), integerMember(image, "bufferView")};
}

/// The structure, by tinygltf. Buffers and images have been taken out: tinygltf looks for files in the
/// working folder too, expands shell variables in URIs, insists on exact file sizes, gives up at the first
/// missing image, and hands image callbacks unchecked pointers.
tinygltf::Model parseStructure(const Json& json) {
  tinygltf::TinyGLTF parser;
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const std::string text = json.dump();
  bool parsed = false;
  try {
    parsed = parser.LoadASCIIFromString(&model, &error, &warning, text.data(), unsigned(text.size()), "");
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  if (!parsed) {
    while (!error.empty() && (error.back() == '\n' || error.back() == '.')) error.pop_back();
    std::replace(error.begin(), error.end(), '\n', ' ');
    throw std::runtime_error(fmt::format("its structure is broken ({}); export the file again", error));
  }
  return model;
}

/// The strings of a top-level array.
std::vector<std::string> namesIn(const Json& json, const char* array) {
  std::vector<std::string> names;
  const auto member = json.find(array);
  if (member == json.end() || !member->is_array()) return names;
  for (const Json& entry : *member) {
    if (entry.is_string()) names.push_back(entry.get<std::string>());
  }
  return names;
}

void checkExtensions(const Json& json, std::vector<std::string>& warnings) {
  for (const std::string& extension : namesIn(json, "extensionsRequired")) {
    if (isHonoured(extension) || isDispensable(extension)) continue;
    throw std::runtime_error(
        fmt::format("it needs the extension {}, which is not supported; export without it", extension));
  }
  std::vector<std::string> leftOut = namesIn(json, "extensionsUsed");
  std::erase_if(leftOut, isHonoured);
  if (leftOut.empty()) return;
  warnings.push_back(fmt::format("These extensions are left out: {}.", fmt::join(leftOut, ", ")));
}

}  // namespace

Document readDocument(const std::filesystem::path& path) {
  const Bytes file = readFile(path);
  const Container container = openContainer(file);
  Json json = parseJson(container.json);
  checkVersion(json);

  Document document;
  document.folder = path.parent_path();
  const std::vector<Json> buffers = takeArray(json, "buffers");
  for (const Json& image : takeArray(json, "images")) document.images.push_back(imageSource(image));
  checkExtensions(json, document.warnings);
  for (const char* unused : {"animations", "skins"}) json.erase(unused);  // broken ones do no harm
  document.model = parseStructure(json);
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    document.buffers.push_back(readBuffer(buffers[i], i, container, document.folder));
  }
  return document;
}

}  // namespace host::gltf
