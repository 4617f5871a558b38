#include "gltf_test_file.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "host/scene/gltf/gltf_loader.h"

namespace gltf_test {

GltfFile::GltfFile() {
  json["asset"]["version"] = "2.0";
}

int GltfFile::addBytes(std::span<const std::byte> bytes, int byteStride) {
  buffer_.resize((buffer_.size() + 3) / 4 * 4);
  Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (byteStride > 0) view["byteStride"] = byteStride;
  buffer_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  json["buffers"] = {{{"uri", "scene.bin"}, {"byteLength", buffer_.size()}}};
  json["bufferViews"].push_back(view);
  return int(json["bufferViews"].size()) - 1;
}

int GltfFile::addAccessor(Json accessor) {
  json["accessors"].push_back(std::move(accessor));
  return int(json["accessors"].size()) - 1;
}

Json& GltfFile::addPrimitive(Json primitive) {
  json["nodes"].push_back({{"mesh", json["meshes"].size()}});
  json["meshes"].push_back({{"primitives", {std::move(primitive)}}});
  return json["meshes"].back()["primitives"].front();
}

Json& GltfFile::addSquare() {
  const int positions = addPositions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  const int uvs = addAccessor(std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0}, kFloat, "VEC2", 2);
  const int indices = addAccessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, kUnsignedShort, "SCALAR", 1);
  return addPrimitive({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}}, {"indices", indices}});
}

host::Scene GltfFile::load(const TemporaryFolder& folder) const {
  folder.write("scene.gltf", json.dump());
  folder.write("scene.bin", buffer_);
  return host::loadGltf(folder.path() / "scene.gltf");
}

std::string GltfFile::loadError(const TemporaryFolder& folder) const {
  try {
    const host::Scene ignored = load(folder);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string GltfFile::glb() const {
  const auto padded = [](std::string text, char filler) {
    text.resize((text.size() + 3) / 4 * 4, filler);
    return text;
  };
  const auto number = [](std::size_t value) {
    const auto bytes = std::uint32_t(value);
    return std::string(reinterpret_cast<const char*>(&bytes), sizeof(bytes));
  };
  Json embedded = json;
  embedded["buffers"][0].erase("uri");
  const std::string text = padded(embedded.dump(), ' ');
  const std::string binary = padded(buffer_, '\0');
  return "glTF" + number(2) + number(12 + 8 + text.size() + 8 + binary.size()) +  //
         number(text.size()) + "JSON" + text +                                    //
         number(binary.size()) + std::string("BIN\0", 4) + binary;
}

std::filesystem::path scenesFolder() {
  if (const char* folder = std::getenv("MRES_SCENES")) return folder;
  return std::filesystem::path(__FILE__).parent_path() / "../../../shared/scenes";
}

std::vector<std::vector<std::string>> readTable(const std::string& file) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream stream(scenesFolder() / file);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
  }
  return rows;
}

}  // namespace gltf_test
