#include "host/scene/builtin/breakfast_table.h"

#include "host/scene/builtin/furniture_tables.h"
#include "host/scene/builtin/furniture_tableware.h"

namespace host {

namespace {

using namespace furniture;

// What every guest gets, kept once and placed at each seat.
struct Setting {
  Interior::Handle plate, cup, teaspoon, fork, knife, napkin;
};

// A place setting about the middle of a plate; the guest sits at +Z.
void placeSetting(Interior& room, const Setting& setting, const glm::mat4& seat, float cupYaw) {
  constexpr float kSaucerRim = 0.0224f;
  room.place(setting.plate, seat);
  room.place(setting.napkin, seat * at({-0.235f, 0.0f, 0.0f}, 4.0f));
  room.place(setting.fork, seat * at({-0.235f, 0.0128f, 0.0f}, 1.0f));
  room.place(setting.knife, seat * at({0.168f, 0.0f, 0.0f}, -1.5f));
  const glm::mat4 cupPlace = seat * at({0.235f, 0.0f, -0.14f}, cupYaw);
  room.place(setting.cup, cupPlace);
  // The teaspoon lies across the saucer, on its rim and well.
  room.place(setting.teaspoon,
             cupPlace * at({-0.012f, kSaucerRim - 0.004f, 0.057f}, 82.0f) * turned(-3.5f, {1, 0, 0}));
}

void placeMiddle(Interior& room, const glm::mat4& top) {
  constexpr float kCloth = 0.002f;
  room.place(fruitBowl(), top * at({-0.02f, kCloth, -0.02f}));
  room.place(breadBasket(), top * at({-0.42f, kCloth, 0.0f}, 20.0f));
  room.place(teapot(), top * at({0.32f, kCloth, -0.07f}, 205.0f));
  room.place(milkJug(), top * at({0.3f, kCloth, 0.13f}, 60.0f));
  room.place(sugarBowl(), top * at({0.48f, kCloth, 0.06f}, 20.0f));
  room.place(candlestick(0.3f), top * at({0.66f, kCloth, -0.03f}));
  room.place(loafOnBoard(), top * at({-0.06f, 0.0f, -0.32f}, 6.0f));
  room.place(spoon(0.2f), top * at({0.55f, kCloth, 0.16f}, 64.0f));
}

}  // namespace

void layBreakfast(Interior& room, glm::vec3 foot, glm::vec2 size) {
  const glm::mat4 top = at(foot + glm::vec3(0.0f, kTableHeight + 0.0002f, 0.0f));
  room.place(tableRunner(size, 0.42f), at(foot));
  placeMiddle(room, top);
  const Setting setting{room.add(plate(0.135f, Finish::porcelain)),
                        room.add(cupAndSaucer()),
                        room.add(spoon(0.14f)),
                        room.add(fork(0.19f)),
                        room.add(knife(0.215f)),
                        room.add(foldedNapkin())};
  const float side = 0.5f * size.y - 0.165f;
  const float end = 0.5f * size.x - 0.165f;
  constexpr float kCloth = 0.002f;
  placeSetting(room, setting, top * at({-0.48f, 0.0f, side}), 20.0f);
  placeSetting(room, setting, top * at({0.5f, 0.0f, side}), -35.0f);
  placeSetting(room, setting, top * at({-end, kCloth, 0.0f}, -90.0f), 60.0f);
  placeSetting(room, setting, top * at({end, kCloth, 0.0f}, 90.0f), 10.0f);
  placeSetting(room, setting, top * at({0.52f, 0.0f, -side}, 180.0f), 45.0f);
}

}  // namespace host
