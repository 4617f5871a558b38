#include "host/scene/builtin/office_desks.h"

#include <array>

#include "host/scene/builtin/furniture_books.h"
#include "host/scene/builtin/furniture_desk_things.h"
#include "host/scene/builtin/furniture_lamps.h"
#include "host/scene/builtin/furniture_seats.h"
#include "host/scene/builtin/furniture_tables.h"
#include "host/scene/builtin/furniture_tableware.h"

namespace host {

namespace {

using namespace furniture;

constexpr glm::vec2 kDesk{1.6f, 0.78f};

// What every desk has.
struct Equipment {
  Interior::Handle monitor, keyboard, mouse, chair;
};

struct Workplace {
  glm::vec3 place;
  float yaw;
  float pedestalSide;
  glm::vec2 chair;  ///< on the floor, relative to the desk
  float chairYaw;
};

glm::mat4 topOf(const Workplace& workplace) {
  return at(workplace.place + glm::vec3(0.0f, kDeskHeight + 0.0002f, 0.0f), workplace.yaw);
}

void placeDesk(Interior& room, const Equipment& equipment, const Workplace& workplace) {
  const glm::mat4 floor = at(workplace.place, workplace.yaw);
  room.place(desk(kDesk, workplace.pedestalSide), floor);
  room.place(equipment.chair, floor * at({workplace.chair.x, 0.0f, workplace.chair.y}, workplace.chairYaw));
}

void placeComputer(Interior& room, const Equipment& equipment, const Workplace& workplace) {
  const glm::mat4 top = topOf(workplace);
  room.place(equipment.monitor, top * at({-0.05f, 0.0f, -0.2f}, 4.0f * workplace.pedestalSide));
  room.place(equipment.keyboard, top * at({-0.05f, 0.0f, 0.17f}, 2.0f));
  room.place(equipment.mouse, top * at({0.19f, 0.0f, 0.19f}, -6.0f));
  room.place(
      cable({-0.05f, kDeskHeight - 0.02f, -0.375f}, {0.52f * workplace.pedestalSide, 0.02f, -0.37f}, 0.12f),
      at(workplace.place, workplace.yaw));
}

void addClutter(Interior& room, const std::array<Workplace, 5>& places) {
  const std::array<glm::mat4, 5> top{topOf(places[0]), topOf(places[1]), topOf(places[2]), topOf(places[3]),
                                     topOf(places[4])};
  const Interior::Handle trays = room.add(letterTrays());
  const Interior::Handle pens = room.add(penCup());
  const Interior::Handle phone = room.add(telephone());
  const Interior::Handle lamp = room.add(deskLamp());
  const Interior::Handle whiteMug = room.add(mug(Finish::porcelain, 15));

  room.place(trays, top[0] * at({-0.6f, 0.0f, -0.16f}));
  room.place(whiteMug, top[0] * at({0.36f, 0.0f, 0.08f}, 40.0f));
  room.place(paperStack(4, 5), top[0] * at({0.58f, 0.0f, 0.02f}, -6.0f));
  room.place(pens, top[0] * at({0.45f, 0.0f, -0.22f}));

  room.place(lamp, top[1] * at({-0.58f, 0.0f, -0.22f}, 30.0f));
  room.place(paperStack(6, 6), top[1] * at({-0.5f, 0.0f, 0.18f}, 12.0f));
  room.place(phone, top[1] * at({0.56f, 0.0f, -0.12f}, -14.0f));

  room.place(bookStack(3, 7), top[2] * at({0.55f, 0.0f, -0.12f}, 10.0f));

  room.place(mug(Finish::blueGlaze, 15), top[3] * at({0.37f, 0.0f, 0.02f}, -40.0f));
  room.place(paperStack(3, 8), top[3] * at({-0.52f, 0.0f, 0.05f}, 4.0f));

  room.place(lamp, top[4] * at({0.6f, 0.0f, -0.2f}, -35.0f));
  const Interior::Handle notebook = room.add(laptop());
  room.place(notebook, top[1] * at({-0.05f, 0.0f, 0.05f}, -8.0f));
  room.place(notebook, top[4] * at({-0.05f, 0.0f, 0.03f}, 5.0f));
  room.place(whiteMug, top[4] * at({0.36f, 0.0f, 0.12f}, 10.0f));
  room.place(paperStack(5, 9), top[4] * at({0.56f, 0.0f, 0.14f}, -10.0f));
}

}  // namespace

void furnishDesks(Interior& room) {
  // Four desks back to back in pairs, and one for the manager, whose back is to the books.
  const std::array<Workplace, 5> places{
      Workplace{{-2.0f, 0.0f, -1.45f}, -90.0f, 1.0f, {-0.02f, 0.62f}, 174.0f},
      {{-2.0f, 0.0f, 0.17f}, -90.0f, -1.0f, {-0.1f, 0.72f}, 205.0f},
      {{-1.2f, 0.0f, -1.45f}, 90.0f, -1.0f, {0.0f, 0.6f}, 183.0f},
      {{-1.2f, 0.0f, 0.17f}, 90.0f, 1.0f, {-0.05f, 0.68f}, 150.0f},
      {{2.05f, 0.0f, -1.35f}, 90.0f, 1.0f, {0.02f, 0.66f}, 168.0f}};
  const Equipment equipment{room.add(monitor()), room.add(keyboard()), room.add(mouse()),
                            room.add(officeChair())};
  for (const Workplace& place : places) placeDesk(room, equipment, place);
  for (const int i : {0, 2, 3}) placeComputer(room, equipment, places[i]);
  addClutter(room, places);
}

}  // namespace host
