// The parts that makeHall() puts together; each adds its meshes and places them.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <vector>

#include "host/scene/builtin/hall_measures.h"
#include "host/scene/builtin/modelling.h"

namespace host::hall {

/// Indices of the materials.
struct Materials {
  int ashlar;      ///< the walls' courses of limestone
  int shaft;       ///< the columns' coloured marble
  int dressed;     ///< smooth limestone: columns, mouldings, tracery
  int vault;       ///< lime plaster between the ribs
  int paleMarble;  ///< balusters, statue
  int floor;       ///< chequered marble
  int redMarble;   ///< borders, plinths
  int oak;         ///< doors, benches, beams
  int bronze;
  int iron;
  int carpet;
  int carpetBorder;
  int banner;
  int wax;
  int flame;
};

struct Hall {
  modelling::SceneBuilder builder{"hall"};
  Materials material{};
};

Materials addMaterials(modelling::SceneBuilder& builder);

void addShell(Hall& hall);     ///< floor, outer walls, roofs
void addEndWalls(Hall& hall);  ///< with the great windows and the rose
void addDoors(Hall& hall);
void addArcades(Hall& hall);  ///< the walls between nave and aisles, archivolts, cornices
void addColumns(Hall& hall);
void addVaults(Hall& hall);       ///< webs and ribs over nave and aisles
void addWindows(Hall& hall);      ///< frames and tracery of the outer walls
void addBalustrades(Hall& hall);  ///< of the gallery
void addStairs(Hall& hall);       ///< with their platform and balustrade
void addFurnishing(Hall& hall);   ///< rugs, benches, urns, banners
void addStatue(Hall& hall);
void addLamps(Hall& hall);  ///< chandeliers and candelabra

/// The capital's meshes stand on y = 0 and carry the arches at kCapitalHeight.
void addCapital(Mesh& mesh);
constexpr float kCapitalHeight = 0.78f;
constexpr float kShaftTopRadius = 0.345f;

/// A straight balustrade from `from` to `to` (the floor's level) with `count` balusters of `segments`
/// sides; it may climb.
void addBalustradeRun(Mesh& mesh, glm::vec3 from, glm::vec3 to, int count, int segments);

/// A turned baluster on y = 0 with square plinth and cap.
void addBaluster(Mesh& mesh, int segments);
constexpr float kBalusterHeight = 0.76f;

/// A vase on y = 0, `height` tall.
void addUrn(Mesh& mesh, glm::vec3 base, float height);

/// An empty mesh of a material.
Mesh makeMesh(const char* name, int material);

/// A mesh modelled about a plane x = 0 with +x towards the nave, placed at -x and, turned by half, at +x.
void placeOnBothSides(Hall& hall, int mesh, float x, float z, float y = 0.0f);

/// The place of a mesh, modelled likewise, on the end wall at -z (`end` = -1) or +z (+1), its middle at `x`.
glm::mat4 onEndWall(float end, float x);

/// An upright outline (along the wall, height) as a wall that fills |x| <= thickness / 2, +x towards the
/// nave.
void addWall(Mesh& mesh, std::span<const glm::vec2> outline, float thickness = kThickness);

/// The outline of a wall between z = -halfWidth and halfWidth around an opening with a round arch that starts
/// at the bottom: counter-clockwise.
std::vector<glm::vec2> archedWall(float halfWidth, float bottom, float top, float openingHalfWidth,
                                  float springing, int segments);

/// The closed cross-section of a moulding whose face is given from bottom to top as (projection, height).
std::vector<glm::vec2> moulding(std::vector<glm::vec2> face);

/// Appends the points of an arc in degrees to a profile.
void appendArc(std::vector<glm::vec2>& profile, glm::vec2 centre, float radius, float start, float end,
               int segments);

}  // namespace host::hall
