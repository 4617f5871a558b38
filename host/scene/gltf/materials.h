#pragma once

#include "host/scene/gltf/document.h"
#include "host/scene/scene.h"

namespace host::gltf {

/// Appends all of the file's materials to the scene, with the textures and images that they use, and returns,
/// for each, the set of texture coordinates (TEXCOORD_n) that its textures read.
///
/// A vertex of ours has one pair of coordinates, so the base colour's texture (or the first there is) chooses
/// the set, and a texture on another set is left out. A missing texture leaves the factors as a person would
/// set them: no glow where the emissive texture is missing, no metal where the metallic-roughness texture is.
/// Unlit materials (KHR_materials_unlit) become black surfaces that emit their base colour. Vertex colours
/// are left out.
std::vector<int> convertMaterials(Document& document, Scene& scene);

}  // namespace host::gltf
