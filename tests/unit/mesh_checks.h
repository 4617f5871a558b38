// What every generated mesh must satisfy; each returns a sentence about the first fault, empty when there is
// none.
#pragma once

#include <string>

#include "host/scene/scene.h"

namespace host::test {

/// Indices in range and in triples, normals and tangents unit length and orthogonal, handedness +1 or -1, no
/// triangle without area, winding on the side of the normals.
std::string faultOf(const Mesh& mesh);

/// Every edge is shared by two triangles that run along it in opposite directions.
std::string leakOf(const Mesh& mesh);

/// Enclosed volume, positive when the faces look outwards.
double volumeOf(const Mesh& mesh);

double areaOf(const Mesh& mesh);

/// Largest deviation of the tangent frames from the directions in which u grows and v shrinks: 1 - cosine.
double worstTangentError(const Mesh& mesh);

/// Area in uv over area in space: 1 where uv are metres.
double uvAreaRatio(const Mesh& mesh);

}  // namespace host::test
