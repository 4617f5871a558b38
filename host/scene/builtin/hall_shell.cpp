// What closes the hall: floor, outer walls with their openings, gallery floors and roofs.
#include <glm/gtc/constants.hpp>
#include <utility>

#include "host/scene/builtin/hall_openings.h"
#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addSweep;

constexpr int kArchSegments = 16;  // of the windows

void addFloor(Hall& hall) {
  Mesh floor = makeMesh("floor", hall.material.floor);
  addBox(floor, {-kOutside, kFoundation, -kHalfLength - kThickness},
         {kOutside, 0.0f, kHalfLength + kThickness});
  hall.builder.place(hall.builder.addMesh(std::move(floor)));

  Mesh border = makeMesh("floor borders", hall.material.redMarble);
  for (const float x : {-kArcade, kArcade}) {
    addBox(border, {x - 0.72f, -kSunk, -kHalfLength}, {x + 0.72f, 0.006f, kHalfLength});
  }
  hall.builder.place(hall.builder.addMesh(std::move(border)));
}

/// One bay of the outer wall around its two windows.
void addOuterBay(Mesh& mesh) {
  constexpr float kHalfBay = 0.5f * kBay;
  addBox(mesh, {-kHalfWall, kFoundation, -kHalfBay}, {kHalfWall, kAisleWindow.sill, kHalfBay});
  for (const auto& [opening, top] :
       {std::pair(kAisleWindow, kGalleryWindow.sill), std::pair(kGalleryWindow, kGalleryRoof)}) {
    addWall(mesh,
            archedWall(kHalfBay, opening.sill, top, opening.halfWidth, opening.springing, kArchSegments));
  }
}

/// Window sills and the moulded edge of the reveals.
void addWindowDressings(Mesh& mesh) {
  for (const Opening& opening : {kAisleWindow, kGalleryWindow}) {
    const float edge = opening.halfWidth + 0.12f;
    addBox(mesh, {kHalfWall - 0.5f, opening.sill - 0.1f, -edge},
           {kHalfWall + 0.1f, opening.sill + 0.025f, edge});
    std::vector<glm::vec3> path{{kHalfWall, opening.sill + kSunk, -opening.halfWidth - 0.05f}};
    const std::vector<glm::vec3> arch =
        modelling::arcPath({kHalfWall, opening.springing, 0.0f}, {0.0f, 0.0f, -opening.halfWidth - 0.05f},
                           {0.0f, opening.halfWidth + 0.05f, 0.0f}, 0.0f, glm::pi<float>(), kArchSegments);
    path.insert(path.end(), arch.begin(), arch.end());
    path.emplace_back(kHalfWall, opening.sill + kSunk, opening.halfWidth + 0.05f);
    const std::vector<glm::vec2> band{
        {0.0f, -0.03f}, {0.13f, -0.03f}, {0.13f, 0.06f}, {0.05f, 0.045f}, {0.0f, 0.02f}};
    addSweep(mesh, band, path, false, 40.0f, {1, 0, 0});
  }
}

/// The flat piers that carry the aisle vaults' ribs, centred on z = 0.
void addPier(Mesh& mesh) {
  const auto block = [&](float bottom, float top, float halfWidth, float projection, float bevel) {
    addBox(mesh, {kHalfWall - 0.04f, bottom, -halfWidth}, {kHalfWall + projection, top, halfWidth}, bevel);
  };
  block(-kSunk, 0.3f, 0.34f, 0.24f, 0.015f);
  block(0.29f, kSpringing - 0.34f, 0.27f, 0.17f, 0.0f);
  block(kSpringing - 0.36f, kSpringing - 0.28f, 0.3f, 0.2f, 0.0f);
  block(kSpringing - 0.29f, kSpringing - 0.13f, 0.285f, 0.185f, 0.0f);
  block(kSpringing - 0.14f, kSpringing + kSunk, 0.34f, 0.28f, 0.015f);
}

/// Oak panelling below the aisle windows, one bay.
void addWainscot(Mesh& mesh) {
  constexpr float kHalfRun = 2.2f;
  constexpr float kTop = 1.26f;
  addBox(mesh, {kHalfWall - 0.03f, -kSunk, -kHalfRun}, {kHalfWall + 0.03f, kTop, kHalfRun});
  addBox(mesh, {kHalfWall, -kSunk, -kHalfRun - 0.01f}, {kHalfWall + 0.055f, 0.16f, kHalfRun + 0.01f});
  addBox(mesh, {kHalfWall - 0.03f, kTop - 0.01f, -kHalfRun - 0.01f},
         {kHalfWall + 0.09f, kTop + 0.06f, kHalfRun + 0.01f}, 0.02f);
  constexpr int kPanels = 4;
  for (int i = 0; i < kPanels; ++i) {
    const float z = kHalfRun * (2.0f * (static_cast<float>(i) + 0.5f) / kPanels - 1.0f);
    addBox(mesh, {kHalfWall + 0.02f, 0.28f, z - 0.44f}, {kHalfWall + 0.055f, 1.14f, z + 0.44f}, 0.025f);
  }
}

void addOuterWalls(Hall& hall) {
  Mesh wall = makeMesh("outer wall", hall.material.ashlar);
  addOuterBay(wall);
  Mesh dressings = makeMesh("window dressings", hall.material.dressed);
  addWindowDressings(dressings);
  Mesh wainscot = makeMesh("wainscot", hall.material.oak);
  addWainscot(wainscot);
  Mesh pier = makeMesh("aisle pier", hall.material.dressed);
  addPier(pier);
  constexpr float kMiddle = kOuterFace + kHalfWall;
  const int wallIndex = hall.builder.addMesh(std::move(wall));
  const int dressingsIndex = hall.builder.addMesh(std::move(dressings));
  const int wainscotIndex = hall.builder.addMesh(std::move(wainscot));
  const int pierIndex = hall.builder.addMesh(std::move(pier));
  for (const float z : kBayCentres) {
    for (const int part : {wallIndex, dressingsIndex, wainscotIndex})
      placeOnBothSides(hall, part, kMiddle, z);
  }
  for (const float z : kColumnLines) placeOnBothSides(hall, pierIndex, kMiddle, z);
}

/// The galleries' floors, and the timber ceilings over them, both on the side of -x.
void addGalleries(Hall& hall) {
  Mesh stone = makeMesh("gallery floor and roof", hall.material.dressed);
  addBox(stone, {-kOuterFace - 0.1f, kSpringing + kAisleVaultRise + 0.05f, -kHalfLength - 0.1f},
         {-kAisleFace + 0.1f, kGallery - 0.002f, kHalfLength + 0.1f});
  Mesh timber = makeMesh("gallery ceiling", hall.material.oak);
  addBox(timber, {-kOutside, kGalleryCeiling, -kHalfLength - kThickness},
         {-kAisleFace + 0.1f, kGalleryRoof + 0.1f, kHalfLength + kThickness});
  constexpr int kBeams = 29;
  for (int i = 0; i < kBeams; ++i) {
    const float z = kHalfLength * (2.0f * static_cast<float>(i) / (kBeams - 1) - 1.0f);
    addBox(timber, {-kOuterFace - 0.05f, kGalleryCeiling - 0.26f, z - 0.09f},
           {-kAisleFace + 0.05f, kGalleryCeiling + 0.01f, z + 0.09f});
  }
  placeOnBothSides(hall, hall.builder.addMesh(std::move(stone)), 0.0f, 0.0f);
  placeOnBothSides(hall, hall.builder.addMesh(std::move(timber)), 0.0f, 0.0f);
}

void addRoof(Hall& hall) {
  Mesh roof = makeMesh("nave roof", hall.material.dressed);
  addBox(roof, {-kAisleFace, kRoof - 0.01f, -kHalfLength - kThickness},
         {kAisleFace, kRoof + 0.4f, kHalfLength + kThickness});
  hall.builder.place(hall.builder.addMesh(std::move(roof)));
}

}  // namespace

void addShell(Hall& hall) {
  addFloor(hall);
  addOuterWalls(hall);
  addGalleries(hall);
  addRoof(hall);
}

}  // namespace host::hall
