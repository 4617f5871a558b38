// Normals and tangents that a file lacks.
#pragma once

#include "host/scene/scene.h"

namespace host::gltf {

/// Gives each triangle vertices of its own with the triangle's normal, as glTF asks for where normals are
/// missing.
void addFlatNormals(Mesh& mesh);

/// Normalises normals; those of zero length become the mean of the adjacent triangles', weighted by area.
void repairNormals(Mesh& mesh);

/// Tangents along +u and bitangents against v (the image's up) of the transformed texture coordinates.
/// Vertices that mirrored and unmirrored triangles share are split.
void addTangents(Mesh& mesh, const glm::mat3& uvTransform);

/// Makes tangents unit length and perpendicular to the normal, whatever they were, and w +1 or -1.
void repairTangents(Mesh& mesh);

}  // namespace host::gltf
