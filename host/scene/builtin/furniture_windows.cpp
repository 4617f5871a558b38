#include "host/scene/builtin/furniture_windows.h"

#include <array>
#include <cmath>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

using modelling::addBox;

constexpr float kFrame = 0.055f;    // width of the fixed frame
constexpr float kCasement = 0.05f;  // width of a casement's frame
constexpr float kBar = 0.024f;      // width of a glazing bar
constexpr float kSlatPitch = 0.047f;
constexpr float kSlatWidth = 0.055f;

// A rectangle of four bars around `low`..`high`, between z = back and front; the upright bars run through.
void addBars(Mesh& mesh, glm::vec2 low, glm::vec2 high, float width, glm::vec2 depth, float bevel) {
  const auto bar = [&](glm::vec2 from, glm::vec2 to) {
    addBox(mesh, {from.x, from.y, depth.x}, {to.x, to.y, depth.y}, bevel);
  };
  bar(low, {low.x + width, high.y});
  bar({high.x - width, low.y}, high);
  bar({low.x + width, low.y}, {high.x - width, low.y + width});
  bar({low.x + width, high.y - width}, {high.x - width, high.y});
}

// Upright bars run through; the lying ones between them are a little thinner, so that no faces coincide.
void addGlazingBars(Mesh& mesh, glm::vec2 low, glm::vec2 high, glm::ivec2 panes, float bevel) {
  const glm::vec2 pane = (high - low) / glm::vec2(panes);
  for (int i = 1; i < panes.x; ++i) {
    const float x = low.x + pane.x * static_cast<float>(i);
    addBox(mesh, {x - kBar * 0.5f, low.y, -0.014f}, {x + kBar * 0.5f, high.y, 0.014f}, bevel);
  }
  for (int i = 0; i < panes.x; ++i) {
    const float left = low.x + pane.x * static_cast<float>(i) + (i > 0 ? kBar * 0.5f : 0.0f);
    const float right = low.x + pane.x * static_cast<float>(i + 1) - (i + 1 < panes.x ? kBar * 0.5f : 0.0f);
    for (int j = 1; j < panes.y; ++j) {
      const float y = low.y + pane.y * static_cast<float>(j);
      addBox(mesh, {left, y - kBar * 0.5f, -0.012f}, {right, y + kBar * 0.5f, 0.012f}, bevel);
    }
  }
}

void addHandle(Piece& window, float x, float y) {
  Mesh& metal = window.part(Finish::brass);
  addBox(metal, {x - 0.011f, y - 0.035f, 0.026f}, {x + 0.011f, y + 0.035f, 0.034f});
  addRod(metal, {x, y, 0.03f}, {x, y, 0.062f}, 0.006f, 6);
  addBox(metal, {x - 0.008f, y - 0.09f, 0.056f}, {x + 0.008f, y + 0.012f, 0.068f});
}

// One slat: a shallow arc across, turned about its long axis.
void addSlat(Mesh& mesh, glm::vec2 centre, float width, float degrees) {
  const float angle = glm::radians(degrees);
  const glm::vec2 across(std::cos(angle), -std::sin(angle));  // (z, y): the inner edge tips down
  const glm::vec2 above(std::sin(angle), std::cos(angle));
  const auto surface = [&](float u, float v) {
    const float s = 0.5f - v;
    const glm::vec2 zy = across * (s * kSlatWidth) + above * (0.004f * (1.0f - 4.0f * s * s));
    return glm::vec3((u - 0.5f) * width, centre.y + zy.y, centre.x + zy.x);
  };
  modelling::addPatch(mesh, surface, {1, 2});
}

}  // namespace

Piece mullionedWindow(const WindowShape& shape) {
  Piece window("window");
  Mesh& wood = window.part(Finish::trimPaint);
  const float half = shape.size.x * 0.5f;
  addBars(wood, {-half, 0.0f}, {half, shape.size.y}, kFrame, {-0.045f, 0.02f}, shape.bevel);

  const float inner = shape.size.x - 2.0f * kFrame;
  const float step = inner / static_cast<float>(shape.casements);
  constexpr float kGap = 0.003f;
  for (int i = 0; i < shape.casements; ++i) {
    const float left = -half + kFrame + step * static_cast<float>(i) + kGap;
    const glm::vec2 low(left, kFrame + kGap);
    const glm::vec2 high(left + step - 2.0f * kGap, shape.size.y - kFrame - kGap);
    addBars(wood, low, high, kCasement, {-0.03f, 0.03f}, shape.bevel);
    addGlazingBars(wood, low + kCasement, high - kCasement, shape.panes, shape.bevel);
    const bool opensLeft = i % 2 == 0;
    addHandle(window, opensLeft ? high.x - kCasement * 0.5f : low.x + kCasement * 0.5f, shape.size.y * 0.45f);
  }
  // The sill board lies on the reveal, runs under the frame's front and noses out into the room.
  addBox(wood, {-half, -0.005f, 0.02f}, {half, 0.025f, shape.reveal + 0.001f}, 0.0f);
  addBox(wood, {-half - 0.05f, -0.005f, shape.reveal + 0.001f}, {half + 0.05f, 0.025f, shape.reveal + 0.045f},
         2.0f * shape.bevel);
  return window;
}

Piece venetianBlind(const BlindShape& shape) {
  Piece blind("venetian blind");
  const float width = shape.size.x;
  const float top = shape.size.y;
  Mesh& metal = blind.part(Finish::blindSlat);
  addBox(metal, {-width * 0.5f, top - 0.035f, -0.029f}, {width * 0.5f, top, 0.029f}, 0.003f);

  const int count = static_cast<int>((top - 0.08f) / kSlatPitch);
  const int hanging = static_cast<int>(static_cast<float>(count) * shape.drop);
  constexpr float kStackPitch = 0.0035f;
  float y = top - 0.06f;
  for (int i = 0; i < count; ++i) {
    addSlat(metal, {0.0f, y}, width - 0.012f, i < hanging ? shape.slatDegrees : 0.0f);
    y -= i + 1 < hanging ? kSlatPitch : kStackPitch;
  }
  const float railTop = y - 0.006f;
  addBox(metal, {-width * 0.5f, railTop - 0.016f, -0.029f}, {width * 0.5f, railTop, 0.029f}, 0.003f);

  Mesh& cords = blind.part(Finish::fringe);
  for (const float x : {-0.36f * width, 0.0f, 0.36f * width}) {
    for (const float z : {-0.0285f, 0.0285f})
      addRod(cords, {x, railTop - 0.002f, z}, {x, top - 0.03f, z}, 0.0009f, 3);
  }
  addRod(cords, {width * 0.44f, top - 0.75f, 0.034f}, {width * 0.44f, top - 0.03f, 0.02f}, 0.004f, 5);
  return blind;
}

}  // namespace host::furniture
