// An open-plan office: a cluster of four desks before blinded windows, a manager's desk, a wall of books.
#include <array>

#include "host/scene/builtin/builtin_scenes.h"
#include "host/scene/builtin/furniture_books.h"
#include "host/scene/builtin/furniture_decor.h"
#include "host/scene/builtin/furniture_fittings.h"
#include "host/scene/builtin/furniture_lamps.h"
#include "host/scene/builtin/furniture_plants.h"
#include "host/scene/builtin/furniture_room.h"
#include "host/scene/builtin/furniture_shapes.h"
#include "host/scene/builtin/furniture_tables.h"
#include "host/scene/builtin/furniture_windows.h"
#include "host/scene/builtin/office_desks.h"

namespace host {

namespace {

using namespace furniture;

constexpr RoomSize kRoom{7.8f, 6.0f, 3.0f, 0.3f};
constexpr float kEast = 0.5f * kRoom.width;
constexpr float kSouth = 0.5f * kRoom.depth;
constexpr float kCeiling = 2.76f;  // of the suspended tiles
constexpr float kSill = 0.9f;
constexpr float kReveal = 0.17f;
constexpr glm::vec2 kWindow{1.7f, 1.5f};
constexpr std::array<float, 3> kWindowX{-2.45f, 0.0f, 2.45f};
constexpr glm::vec2 kDoor{0.95f, 2.1f};
constexpr float kDoorX = 2.7f;

void addShell(Interior& room) {
  Piece shell("shell");
  const Wall north = wallOf(kRoom, Side::north);
  const Wall south = wallOf(kRoom, Side::south);
  std::vector<Opening> windows;
  windows.reserve(std::size(kWindowX));
  for (const float x : kWindowX) windows.push_back(openingAt(north, {x, kSill, -kSouth}, kWindow));
  const std::array<Opening, 1> door{
      openingAt(south, {kDoorX, 0.0f, kSouth}, kDoor + glm::vec2(0.02f, 0.01f))};
  addWall(shell, north, windows, Finish::wallPaint);
  addWall(shell, wallOf(kRoom, Side::west), {}, Finish::wallAccent);
  addWall(shell, south, door, Finish::wallPaint);
  addWall(shell, wallOf(kRoom, Side::east), {}, Finish::wallPaint);
  addFloorAndCeiling(shell, kRoom, Finish::carpet, 0.0f);

  const std::array<glm::vec2, 4> skirting{
      glm::vec2(0.012f, -0.004f), {0.012f, 0.07f}, {0.008f, 0.076f}, {0.0f, 0.077f}};
  constexpr float kCasing = 0.5f * kDoor.x + 0.088f;
  const std::array<glm::vec3, 6> around{glm::vec3(kDoorX + kCasing, 0, kSouth),
                                        {kEast, 0, kSouth},
                                        {kEast, 0, -kSouth},
                                        {-kEast, 0, -kSouth},
                                        {-kEast, 0, kSouth},
                                        {kDoorX - kCasing, 0, kSouth}};
  addMoulding(shell.part(Finish::trimPaint), skirting, around, Ends::open);
  room.place(shell);
  room.place(tileCeiling(kRoom, 0.78f), at({0.0f, kCeiling, 0.0f}));
  room.place(closedDoor(kDoor, DoorLeaf::flush, Finish::beech), at({kDoorX, 0.0f, kSouth}, 180.0f));
}

void addWindows(Interior& room) {
  WindowShape shape;
  shape.size = kWindow;
  shape.panes = {1, 1};
  shape.bevel = 0.0f;
  shape.reveal = kReveal;
  const Interior::Handle window = room.add(mullionedWindow(shape));
  const Interior::Handle heater = room.add(radiator(1.3f, 0.55f));
  // One blind is open, one half shut, one drawn half way up.
  const std::array<BlindShape, 3> blinds{BlindShape{{kWindow.x - 0.03f, kWindow.y - 0.03f}, 8.0f, 1.0f},
                                         BlindShape{{kWindow.x - 0.03f, kWindow.y - 0.03f}, 20.0f, 0.5f},
                                         BlindShape{{kWindow.x - 0.03f, kWindow.y - 0.03f}, 48.0f, 1.0f}};
  for (std::size_t i = 0; i < kWindowX.size(); ++i) {
    const glm::vec3 foot(kWindowX[i], kSill, -kSouth);
    room.place(window, at(foot - glm::vec3(0.0f, 0.0f, kReveal)));
    room.place(venetianBlind(blinds[i]), at(foot + glm::vec3(0.0f, 0.03f, -0.055f)));
    room.place(heater, at({kWindowX[i], 0.0f, -kSouth}));
  }
}

void addShelves(Interior& room) {
  const ShelfShape shape{{0.95f, 2.05f, 0.31f}, 5};
  const Interior::Handle unit = room.add(shelfUnit(shape));
  const std::array<float, 2> places{1.9f, 0.94f};
  const float clearance = (shelfHeight(shape, 1) - shelfHeight(shape, 0)) - kShelfBoard;
  const Interior::Handle file = room.add(binder(Finish::coverBlack));
  const Interior::Handle otherFile = room.add(binder(Finish::coverBlue));
  const Interior::Handle box = room.add(storageBox(Finish::coverCream));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::mat4 place = at({kEast - 0.014f, 0.0f, places[i]}, -90.0f);
    room.place(unit, place);
    const float left = -0.5f * shape.size.x + kShelfBoard + 0.004f;
    const float length = shape.size.x - 2.0f * kShelfBoard - 0.008f;
    for (int shelf = 0; shelf < shape.shelves; ++shelf) {
      const glm::mat4 board = place * at({left, shelfHeight(shape, shelf), 0.0f});
      if (shelf == 0) {
        for (int k = 0; k < 5; ++k)
          room.place(k % 3 == 1 ? otherFile : file,
                     board * at({0.005f + 0.079f * static_cast<float>(k), 0.0f, 0.3f}));
        continue;
      }
      if (shelf + 1 == shape.shelves) {
        for (int k = 0; k < 3; ++k)
          room.place(box, board * at({0.02f + 0.29f * static_cast<float>(k), 0.0f, 0.295f}));
        continue;
      }
      const auto seed = static_cast<std::uint32_t>(100 + 10 * i + static_cast<std::size_t>(shelf));
      const bool full = (static_cast<int>(i) + shelf) % 3 != 0;
      room.place(bookRow({full ? length : 0.55f * length, 0.92f * clearance, 0.285f, seed}), board);
      if (!full) room.place(bookStack(3, seed + 1), board * at({0.79f * length, 0.0f, 0.17f}));
    }
  }
}

void addWalls(Interior& room) {
  room.place(pinBoard({1.6f, 0.9f}, 12), at({-1.3f, 1.5f, kSouth - 0.002f}, 180.0f));
  room.place(wallClock(), at({1.2f, 2.15f, kSouth}, 180.0f));
  room.place(framedPicture({0.9f, 0.65f}, Finish::beech), at({-kEast + 0.001f, 1.55f, -0.4f}, 90.0f));
  const Interior::Handle outlet = room.add(socket());
  room.place(outlet, at({-kEast, 0.3f, -1.6f}, 90.0f));
  room.place(outlet, at({1.22f, 0.35f, -kSouth}));
  const Interior::Handle lamp = room.add(linearLuminaire(1.5f, 0.32f));
  for (const float x : {-1.6f, 1.9f}) {
    for (const float z : {-1.3f, 1.0f}) room.place(lamp, at({x, kCeiling, z}, 90.0f));
  }
}

void addPlantsAndBin(Interior& room) {
  PlantShape plant;
  plant.height = 1.5f;
  plant.stems = 5;
  plant.leavesPerStem = 6;
  plant.leafLength = 0.24f;
  plant.leafWidth = 0.11f;
  plant.leafSegments = {2, 3};
  plant.stemSegments = {4, 5};
  plant.potSegments = 14;
  plant.pot = Finish::whiteLacquer;
  plant.seed = 2;
  room.place(pottedPlant(plant), at({-3.45f, 0.0f, 2.5f}));
  plant.height = 0.42f;
  plant.potRadius = 0.075f;
  plant.stems = 4;
  plant.leavesPerStem = 5;
  plant.leafLength = 0.1f;
  plant.leafWidth = 0.055f;
  plant.seed = 5;
  room.place(pottedPlant(plant), at({0.5f, kSill + 0.025f, -kSouth + 0.01f}));
  room.place(wasteBasket(), at({-0.28f, 0.0f, -2.35f}));
}

void addLight(Scene& scene) {
  Light sun;
  sun.name = "sun";
  sun.direction = glm::normalize(glm::vec3(-0.42f, -0.6f, 0.68f));
  sun.color = {1.0f, 0.94f, 0.85f};
  sun.intensity = 3.2f;
  scene.lights.push_back(sun);
  scene.sky.ground = {0.42f, 0.45f, 0.47f};  // haze over the town
  scene.ambient = glm::vec3(0.4f);
}

void addCameras(Scene& scene) {
  scene.cameras = {
      lookAt("from the door", {3.3f, 1.6f, 2.5f}, {-1.1f, 0.85f, -1.2f}, 60.0f),
      lookAt("from above", {-3.5f, 2.55f, 2.65f}, {0.4f, 0.5f, -0.9f}, 62.0f),
      lookAt("along the desks", {-1.22f, 1.0f, 1.15f}, {-1.5f, 0.88f, -3.0f}, 48.0f),
      lookAt("books", {2.7f, 1.45f, 0.75f}, {3.7f, 1.32f, 1.35f}, 50.0f),
      lookAt("chair", {0.95f, 0.75f, 0.95f}, {-0.45f, 0.5f, -0.1f}, 46.0f),
      lookAt("blinds", {-0.45f, 1.4f, -1.75f}, {0.25f, 1.45f, -3.0f}, 56.0f),
      lookAt("keyboard and mug", {-0.55f, 1.12f, 0.42f}, {-1.12f, 0.76f, 0.02f}, 45.0f),
      lookAt("manager's desk", {3.5f, 1.4f, 0.25f}, {1.75f, 0.82f, -1.75f}, 50.0f),
  };
}

}  // namespace

Scene makeOffice() {
  Interior room("office");
  addShell(room);
  addWindows(room);
  furnishDesks(room);
  addShelves(room);
  addWalls(room);
  addPlantsAndBin(room);
  addLight(room.scene());
  addCameras(room.scene());
  return room.take();
}

}  // namespace host
