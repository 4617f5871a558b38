#include "host/scene/builtin/furniture_lamps.h"

#include <array>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

using Profile = std::vector<glm::vec2>;

void addBulb(Mesh& mesh, glm::vec3 neck, int segments) {
  modelling::addLathe(mesh, neck,
                      Profile{{0.0f, -0.1f},
                              {0.012f, -0.098f},
                              {0.024f, -0.088f},
                              {0.03f, -0.072f},
                              {0.029f, -0.056f},
                              {0.021f, -0.035f},
                              {0.014f, -0.018f},
                              {0.013f, 0.0f},
                              {0.0f, 0.0f}},
                      segments);
}

// A cone of cloth, open above and below, with rims; between the heights `low` and `high`.
void addShade(Piece& lamp, glm::vec2 bottom, glm::vec2 top, int segments) {
  modelling::addLathe(lamp.part(Finish::lampShade), glm::vec3(0.0f),
                      Profile{bottom, glm::mix(bottom, top, 0.5f), top}, segments);
  for (const glm::vec2 rim : {bottom, top}) {
    const auto circle = modelling::arcPath(
        {0, rim.y, 0}, {rim.x, 0, 0}, {0, 0, -rim.x}, 0.0f,
        6.2831853f * static_cast<float>(segments - 1) / static_cast<float>(segments), segments - 1);
    modelling::addSweep(lamp.part(Finish::fringe), modelling::circleOutline(0.004f, 6), circle, true);
  }
}

}  // namespace

Piece deskLamp() {
  Piece lamp("desk lamp");
  Mesh& steel = lamp.part(Finish::darkSteel);
  modelling::addLathe(steel, glm::vec3(0.0f),
                      Profile{{0.0f, 0.0f},
                              {0.085f, 0.0f},
                              {0.087f, 0.004f},
                              {0.083f, 0.015f},
                              {0.02f, 0.021f},
                              {0.012f, 0.03f},
                              {0.0f, 0.03f}},
                      11);
  const glm::vec3 foot(0.0f, 0.026f, 0.0f);
  const glm::vec3 elbow(0.0f, 0.33f, -0.12f);
  const glm::vec3 head(0.0f, 0.5f, 0.13f);
  addRod(steel, foot, elbow, 0.006f, 5);
  addRod(steel, elbow, head, 0.006f, 5);
  addRod(lamp.part(Finish::chrome), elbow - glm::vec3(0.016f, 0, 0), elbow + glm::vec3(0.016f, 0, 0), 0.012f,
         8);
  addRod(lamp.part(Finish::chrome), head - glm::vec3(0.016f, 0, 0), head + glm::vec3(0.016f, 0, 0), 0.01f, 8);

  // The head hangs from the second joint; its inside is white and lit.
  const glm::mat4 aim = at(head) * turned(-28.0f, {1, 0, 0});
  std::size_t first = steel.vertices.size();
  modelling::addLathe(steel, glm::vec3(0.0f),
                      Profile{{0.066f, -0.105f},
                              {0.068f, -0.105f},
                              {0.062f, -0.06f},
                              {0.04f, -0.018f},
                              {0.022f, -0.004f},
                              {0.02f, 0.02f},
                              {0.0f, 0.024f}},
                      11);
  modelling::transformFrom(steel, first, aim);
  Mesh& glow = lamp.part(Finish::lampGlow);
  first = glow.vertices.size();
  modelling::addLathe(glow, glm::vec3(0.0f),
                      Profile{{0.0f, -0.012f}, {0.038f, -0.02f}, {0.06f, -0.06f}, {0.066f, -0.105f}}, 12);
  modelling::addEllipsoid(glow, {0.0f, -0.06f, 0.0f}, {0.027f, 0.034f, 0.027f}, {6, 5});
  modelling::transformFrom(glow, first, aim);
  return lamp;
}

Piece linearLuminaire(float length, float drop) {
  Piece lamp("luminaire");
  const float half = length * 0.5f;
  Mesh& body = lamp.part(Finish::paintedSteel);
  modelling::addBox(body, {-half, -drop, -0.05f}, {half, -drop + 0.055f, 0.05f});
  modelling::addBox(lamp.part(Finish::lampGlow), {-half + 0.02f, -drop - 0.004f, -0.04f},
                    {half - 0.02f, -drop + 0.001f, 0.04f});
  for (const float x : {-half + 0.2f, half - 0.2f}) {
    addRod(lamp.part(Finish::chrome), {x, -drop + 0.05f, 0.0f}, {x, 0.0f, 0.0f}, 0.0016f, 3);
    addRod(body, {x, -0.022f, 0.0f}, {x, 0.002f, 0.0f}, 0.028f, 7);
  }
  return lamp;
}

Piece pendantLamp(float drop) {
  Piece lamp("pendant lamp");
  Mesh& brass = lamp.part(Finish::brass);
  modelling::addLathe(
      brass, {0.0f, -0.04f, 0.0f},
      Profile{
          {0.0f, 0.0f}, {0.008f, 0.002f}, {0.02f, 0.012f}, {0.055f, 0.03f}, {0.06f, 0.042f}, {0.0f, 0.042f}},
      32);
  const float bottom = -drop;
  const float top = bottom + 0.24f;
  addRod(lamp.part(Finish::darkSteel), {0, top + 0.01f, 0}, {0, -0.03f, 0}, 0.0035f, 8);
  addShade(lamp, {0.27f, bottom}, {0.13f, top}, 64);
  modelling::addLathe(
      brass, {0.0f, top - 0.06f, 0.0f},
      Profile{
          {0.0f, 0.0f}, {0.017f, 0.0f}, {0.019f, 0.05f}, {0.012f, 0.066f}, {0.004f, 0.075f}, {0.0f, 0.075f}},
      24);
  for (int spoke = 0; spoke < 3; ++spoke) {
    const float angle = 2.0943951f * static_cast<float>(spoke);
    addRod(brass, {0, top - 0.004f, 0}, {0.13f * std::cos(angle), top - 0.002f, 0.13f * std::sin(angle)},
           0.002f, 6);
  }
  addBulb(lamp.part(Finish::bulb), {0.0f, top - 0.06f, 0.0f}, 24);
  return lamp;
}

Piece tableLamp() {
  Piece lamp("table lamp");
  modelling::addLathe(lamp.part(Finish::blueGlaze), glm::vec3(0.0f),
                      Profile{{0.0f, 0.0f},
                              {0.062f, 0.0f},
                              {0.064f, 0.008f},
                              {0.05f, 0.02f},
                              {0.058f, 0.045f},
                              {0.086f, 0.09f},
                              {0.093f, 0.13f},
                              {0.083f, 0.175f},
                              {0.052f, 0.215f},
                              {0.025f, 0.238f},
                              {0.021f, 0.26f},
                              {0.026f, 0.266f},
                              {0.0f, 0.268f}},
                      48);
  addRod(lamp.part(Finish::brass), {0, 0.262f, 0}, {0, 0.34f, 0}, 0.008f, 12);
  Mesh& bulb = lamp.part(Finish::bulb);
  const std::size_t first = bulb.vertices.size();
  addBulb(bulb, glm::vec3(0.0f), 24);
  modelling::transformFrom(bulb, first, at({0.0f, 0.335f, 0.0f}) * turned(180.0f, {1, 0, 0}));
  addShade(lamp, {0.17f, 0.3f}, {0.11f, 0.52f}, 56);
  for (int spoke = 0; spoke < 3; ++spoke) {
    const float angle = 2.0943951f * static_cast<float>(spoke);
    addRod(lamp.part(Finish::brass), {0, 0.334f, 0},
           {0.16f * std::cos(angle), 0.318f, 0.16f * std::sin(angle)}, 0.0018f, 6);
  }
  return lamp;
}

}  // namespace host::furniture
