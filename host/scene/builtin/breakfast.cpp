// A breakfast room on a clear morning: a laid table between tall curtained windows and a sideboard.
#include <array>

#include "host/scene/builtin/breakfast_table.h"
#include "host/scene/builtin/builtin_scenes.h"
#include "host/scene/builtin/furniture_books.h"
#include "host/scene/builtin/furniture_decor.h"
#include "host/scene/builtin/furniture_fittings.h"
#include "host/scene/builtin/furniture_lamps.h"
#include "host/scene/builtin/furniture_plants.h"
#include "host/scene/builtin/furniture_room.h"
#include "host/scene/builtin/furniture_seats.h"
#include "host/scene/builtin/furniture_shapes.h"
#include "host/scene/builtin/furniture_tables.h"
#include "host/scene/builtin/furniture_tableware.h"
#include "host/scene/builtin/furniture_windows.h"

namespace host {

namespace {

using namespace furniture;

constexpr RoomSize kRoom{6.4f, 5.0f, 2.95f, 0.3f};
constexpr float kEast = 0.5f * kRoom.width;
constexpr float kSouth = 0.5f * kRoom.depth;
constexpr float kSill = 0.55f;
constexpr float kReveal = 0.16f;
constexpr float kRailHeight = 0.92f;  // of the chair rail
constexpr glm::vec2 kNorthWindow{1.6f, 1.95f};
constexpr glm::vec2 kWestWindow{1.9f, 1.95f};
constexpr float kNorthWindowX = 1.45f;
constexpr float kWestWindowZ = -0.15f;
constexpr glm::vec2 kDoor{0.9f, 2.05f};
constexpr float kDoorZ = 1.55f;
constexpr glm::vec3 kTable{0.0f, 0.011f, 0.05f};  // on the rug
constexpr glm::vec2 kTableSize{2.1f, 1.02f};

void addShell(Interior& room) {
  Piece shell("shell");
  const Wall north = wallOf(kRoom, Side::north);
  const Wall west = wallOf(kRoom, Side::west);
  const Wall east = wallOf(kRoom, Side::east);
  const std::array<Opening, 2> northHoles{openingAt(north, {kNorthWindowX, kSill, -kSouth}, kNorthWindow),
                                          openingAt(north, {-kNorthWindowX, kSill, -kSouth}, kNorthWindow)};
  const std::array<Opening, 1> westHole{openingAt(west, {-kEast, kSill, kWestWindowZ}, kWestWindow)};
  const std::array<Opening, 1> doorHole{
      openingAt(east, {kEast, 0.0f, kDoorZ}, kDoor + glm::vec2(0.02f, 0.01f))};
  addWall(shell, north, northHoles, Finish::wallAccent);
  addWall(shell, west, westHole, Finish::wallAccent);
  addWall(shell, wallOf(kRoom, Side::south), {}, Finish::wallAccent);
  addWall(shell, east, doorHole, Finish::wallAccent);
  addFloorAndCeiling(shell, kRoom, Finish::parquetDark, -0.004f);

  addMoulding(shell.part(Finish::trimPaint), corniceProfile(), roomCorners(kRoom, kRoom.height),
              Ends::joined);
  // The skirting runs around the room from one side of the door to the other.
  constexpr float kCasing = 0.5f * kDoor.x + 0.088f;
  const std::array<glm::vec3, 6> around{glm::vec3(kEast, 0, kDoorZ - kCasing),
                                        {kEast, 0, -kSouth},
                                        {-kEast, 0, -kSouth},
                                        {-kEast, 0, kSouth},
                                        {kEast, 0, kSouth},
                                        {kEast, 0, kDoorZ + kCasing}};
  addMoulding(shell.part(Finish::trimPaint), skirtingProfile(), around, Ends::open);
  room.place(shell);
  room.place(herringboneParquet(kRoom, {0.42f, 0.07f}));
  room.place(closedDoor(kDoor, DoorLeaf::panelled, Finish::trimPaint), at({kEast, 0.0f, kDoorZ}, -90.0f));
}

// A stretch of wainscot with its chair rail, from `from` to `to` on the floor; the room is to the left of
// that way.
void addWainscot(Interior& room, glm::vec3 from, glm::vec3 to, float height, int panels) {
  const glm::vec3 way = to - from;
  const float yaw = glm::degrees(std::atan2(-way.z, way.x)) + 180.0f;
  room.place(wainscot(glm::length(way), height, panels), at(0.5f * (from + to), yaw));
  if (height < kRailHeight) return;
  Piece rail("chair rail");
  const glm::vec3 up(0.0f, height, 0.0f);
  addMoulding(rail.part(Finish::trimPaint), chairRailProfile(), std::array<glm::vec3, 2>{from + up, to + up},
              Ends::open);
  room.place(rail);
}

void addPanelling(Interior& room) {
  const auto north = [](float x) { return glm::vec3(x, 0.0f, -kSouth); };
  const auto west = [](float z) { return glm::vec3(-kEast, 0.0f, z); };
  const auto south = [](float x) { return glm::vec3(x, 0.0f, kSouth); };
  const auto east = [](float z) { return glm::vec3(kEast, 0.0f, z); };
  constexpr float kBelowSill = kSill - 0.008f;
  constexpr float kHalf = 0.5f * kNorthWindow.x;
  const float near = kNorthWindowX - kHalf;
  const float far = kNorthWindowX + kHalf;
  addWainscot(room, north(kEast), north(far), kRailHeight, 1);
  addWainscot(room, north(far), north(near), kBelowSill, 2);
  addWainscot(room, north(near), north(-near), kRailHeight, 2);
  addWainscot(room, north(-near), north(-far), kBelowSill, 2);
  addWainscot(room, north(-far), north(-kEast), kRailHeight, 1);
  const float begin = kWestWindowZ - 0.5f * kWestWindow.x;
  const float end = kWestWindowZ + 0.5f * kWestWindow.x;
  addWainscot(room, west(-kSouth), west(begin), kRailHeight, 2);
  addWainscot(room, west(begin), west(end), kBelowSill, 2);
  addWainscot(room, west(end), west(kSouth), kRailHeight, 2);
  addWainscot(room, south(-kEast), south(kEast), kRailHeight, 8);
  constexpr float kCasing = 0.5f * kDoor.x + 0.085f;
  addWainscot(room, east(kSouth), east(kDoorZ + kCasing), kRailHeight, 1);
  addWainscot(room, east(kDoorZ - kCasing), east(-kSouth), kRailHeight, 4);
}

// A window with its curtains and rail; `middle` is the middle of its lower edge on the wall.
void addWindow(Interior& room, glm::vec3 middle, float yaw, glm::vec2 size, std::uint32_t seed) {
  constexpr float kStandOff = 0.125f;
  constexpr float kRail = 2.66f;
  constexpr float kHem = 0.015f;
  const glm::mat4 place = at(middle, yaw);
  WindowShape shape;
  shape.size = size;
  shape.panes = {2, 4};
  shape.reveal = kReveal;
  room.place(mullionedWindow(shape), place * at({0.0f, 0.0f, -kReveal}));
  const float half = 0.5f * size.x;
  room.place(curtainRail(size.x + 0.8f, kStandOff), place * at({0.0f, kRail - middle.y, kStandOff}));
  for (const float side : {-1.0f, 1.0f}) {
    CurtainShape cloth;
    cloth.width = 0.56f;
    cloth.height = kRail - kRailAboveCurtain - kHem;
    cloth.seed = seed + (side > 0.0f ? 1 : 0);
    room.place(curtain(cloth), place * at({side * (half + 0.06f), kHem - middle.y, kStandOff}));
  }
}

void addWindows(Interior& room) {
  addWindow(room, {-kNorthWindowX, kSill, -kSouth}, 0.0f, kNorthWindow, 10);
  addWindow(room, {kNorthWindowX, kSill, -kSouth}, 0.0f, kNorthWindow, 20);
  addWindow(room, {-kEast, kSill, kWestWindowZ}, 90.0f, kWestWindow, 30);
}

void addSeats(Interior& room) {
  const Interior::Handle chair = room.add(slatBackChair());
  const float side = kTable.z + 0.5f * kTableSize.y;
  room.place(chair, at({-0.48f, kTable.y, side + 0.2f}, 183.0f));
  room.place(chair, at({0.55f, kTable.y, side + 0.3f}, 171.0f));
  room.place(chair, at({-1.34f, kTable.y, kTable.z + 0.03f}, 88.0f));
  room.place(chair, at({1.4f, kTable.y, kTable.z - 0.04f}, -97.0f));
  room.place(bench(1.5f), at({0.0f, kTable.y, kTable.z - 0.5f * kTableSize.y - 0.16f}));
}

void addSideboard(Interior& room) {
  const glm::mat4 place = at({-0.7f, 0.0f, kSouth - 0.03f}, 180.0f);
  constexpr float kTop = kSideboardHeight;
  room.place(sideboard(1.9f, 0.46f), place);
  room.place(tableLamp(), place * at({-0.7f, kTop, 0.22f}));
  room.place(vaseWithFlowers(13, 3), place * at({0.1f, kTop, 0.2f}));
  const Interior::Handle candlestickHandle = room.add(candlestick(0.34f));
  room.place(candlestickHandle, place * at({0.36f, kTop, 0.26f}));
  room.place(room.add(candlestick(0.27f)), place * at({0.46f, kTop, 0.18f}));
  room.place(bookStack(4, 8), place * at({-0.3f, kTop, 0.21f}, 8.0f));
  const Interior::Handle spare = room.add(plate(0.135f, Finish::sageGlaze));
  for (int i = 0; i < 5; ++i)
    room.place(spare, place * at({0.72f, kTop + 0.0085f * static_cast<float>(i), 0.22f},
                                 40.0f * static_cast<float>(i)));
}

void addPictures(Interior& room) {
  const float z = kSouth - 0.001f;
  room.place(framedPicture({0.8f, 0.6f}, Finish::walnut), at({-0.7f, 1.75f, z}, 180.0f));
  const Interior::Handle small = room.add(framedPicture({0.36f, 0.46f}, Finish::brass));
  room.place(small, at({0.1f, 1.72f, z}, 180.0f));
  room.place(small, at({-1.5f, 1.72f, z}, 180.0f));
  room.place(framedPicture({0.9f, 0.62f}, Finish::oak), at({kEast - 0.001f, 1.7f, -0.6f}, -90.0f));
}

void addPlants(Interior& room) {
  PlantShape tall;
  tall.height = 1.75f;
  tall.stems = 8;
  tall.leavesPerStem = 17;
  tall.leafLength = 0.23f;
  tall.leafWidth = 0.1f;
  tall.leafSegments = {4, 9};
  tall.seed = 4;
  room.place(pottedPlant(tall), at({2.72f, 0.0f, -2.0f}));
  tall.height = 1.3f;
  tall.stems = 7;
  tall.seed = 9;
  tall.pot = Finish::blueGlaze;
  tall.leaves = Finish::paleLeaf;
  room.place(pottedPlant(tall), at({-2.72f, 0.0f, 2.0f}));

  PlantShape herb;
  herb.height = 0.34f;
  herb.potRadius = 0.062f;
  herb.stems = 11;
  herb.leavesPerStem = 14;
  herb.leafLength = 0.05f;
  herb.leafWidth = 0.03f;
  herb.leafSegments = {2, 5};
  herb.stemSegments = {5, 6};
  const float sillZ = -kSouth - 0.06f;
  const float sillY = kSill + 0.025f;
  const std::array<float, 4> places{-1.95f, -1.02f, 1.0f, 1.72f};
  for (std::size_t i = 0; i < places.size(); ++i) {
    herb.seed = 40 + static_cast<std::uint32_t>(i);
    herb.leaves = i % 2 == 0 ? Finish::leaf : Finish::paleLeaf;
    room.place(pottedPlant(herb), at({places[i], sillY, sillZ}));
  }
}

void addLight(Scene& scene) {
  // A low morning sun, 27 degrees high: through the windows to -Z it just reaches the table.
  Light sun;
  sun.name = "sun";
  sun.direction = glm::normalize(glm::vec3(0.36f, -0.43f, 0.75f));
  sun.color = {1.0f, 0.9f, 0.76f};
  sun.intensity = 3.4f;
  scene.lights.push_back(sun);
  scene.sky.ground = {0.2f, 0.27f, 0.13f};  // lawn
  scene.sky.zenith = {0.3f, 0.5f, 0.88f};
  scene.sky.horizon = {0.8f, 0.87f, 0.93f};
  scene.ambient = glm::vec3(0.4f);
}

void addCameras(Scene& scene) {
  scene.cameras = {
      lookAt("from the door", {2.75f, 1.55f, 2.0f}, {-0.75f, 0.85f, -0.75f}, 58.0f),
      lookAt("from above", {-2.85f, 2.55f, 2.2f}, {0.35f, 0.55f, -0.3f}, 62.0f),
      lookAt("cup and spoon", {0.98f, 1.0f, 0.62f}, {0.5f, 0.79f, 0.28f}, 42.0f),
      lookAt("along the table", {-1.12f, 0.93f, 0.36f}, {0.7f, 0.8f, -0.12f}, 46.0f),
      lookAt("teapot before the window", {0.42f, 0.93f, 0.6f}, {-0.75f, 1.08f, -2.5f}, 44.0f),
      lookAt("curtain", {1.15f, 1.3f, -0.95f}, {2.3f, 1.2f, -2.5f}, 52.0f),
      lookAt("chairs", {1.75f, 0.75f, 1.95f}, {-0.1f, 0.6f, 0.1f}, 48.0f),
      lookAt("sideboard", {0.45f, 1.35f, 0.95f}, {-0.72f, 1.12f, 2.5f}, 52.0f),
  };
}

}  // namespace

Scene makeBreakfast() {
  Interior room("breakfast");
  addShell(room);
  addPanelling(room);
  addWindows(room);
  room.place(rug({3.3f, 2.3f}, 6), at({0.0f, 0.0f, kTable.z}));
  room.place(diningTable(kTableSize), at(kTable));
  layBreakfast(room, kTable, kTableSize);
  addSeats(room);
  addSideboard(room);
  addPictures(room);
  addPlants(room);
  room.place(pendantLamp(1.32f), at({kTable.x, kRoom.height, kTable.z}));
  addLight(room.scene());
  addCameras(room.scene());
  return room.take();
}

}  // namespace host
