#include "host/scene/builtin/furniture_tableware.h"

#include <array>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

using modelling::addLathe;
using Profile = std::vector<glm::vec2>;

constexpr int kRoundSegments = 46;

void addHandle(Mesh& mesh, std::span<const TubePoint> points) {
  addTube(mesh, points, {12, 20});
}

// A level disc of liquid that reaches just into the wall of its vessel.
void addLiquid(Mesh& mesh, float radius, float height) {
  addLathe(mesh, glm::vec3(0.0f), Profile{{radius, height}, {0.0f, height}}, 40);
}

Piece saucer() {
  Piece piece("saucer");
  addLathe(piece.part(Finish::porcelain), glm::vec3(0.0f),
           Profile{{0.0f, 0.003f},
                   {0.036f, 0.003f},
                   {0.038f, 0.0f},
                   {0.043f, 0.0f},
                   {0.045f, 0.003f},
                   {0.06f, 0.0085f},
                   {0.072f, 0.015f},
                   {0.078f, 0.0195f},
                   {0.0788f, 0.0205f},
                   {0.0786f, 0.0218f},
                   {0.0775f, 0.0222f},
                   {0.07f, 0.018f},
                   {0.058f, 0.0115f},
                   {0.045f, 0.007f},
                   {0.032f, 0.0058f},
                   {0.0285f, 0.0048f},
                   {0.0f, 0.0048f}},
           kRoundSegments);
  return piece;
}

Piece cup() {
  Piece piece("cup");
  Mesh& china = piece.part(Finish::porcelain);
  addLathe(
      china, glm::vec3(0.0f),
      Profile{{0.0f, 0.003f},    {0.02f, 0.003f},    {0.0215f, 0.0f},    {0.0265f, 0.0f},   {0.0275f, 0.004f},
              {0.0325f, 0.01f},  {0.0375f, 0.02f},   {0.0405f, 0.032f},  {0.0425f, 0.046f}, {0.0442f, 0.06f},
              {0.0457f, 0.067f}, {0.0456f, 0.0684f}, {0.0445f, 0.0686f}, {0.0436f, 0.067f}, {0.0422f, 0.06f},
              {0.0405f, 0.046f}, {0.0385f, 0.032f},  {0.0352f, 0.02f},   {0.03f, 0.011f},   {0.022f, 0.0065f},
              {0.0f, 0.0055f}},
      kRoundSegments);
  const std::array<TubePoint, 7> handle{
      TubePoint{{0.041f, 0.057f, 0}, 0.0042f}, {{0.052f, 0.0605f, 0}, 0.0038f},
      {{0.064f, 0.057f, 0}, 0.0034f},          {{0.069f, 0.046f, 0}, 0.0034f},
      {{0.064f, 0.034f, 0}, 0.0034f},          {{0.052f, 0.025f, 0}, 0.0036f},
      {{0.037f, 0.022f, 0}, 0.0044f}};
  addHandle(china, handle);
  addLiquid(piece.part(Finish::tea), 0.0428f, 0.0575f);
  return piece;
}

}  // namespace

Piece plate(float radius, Finish glaze) {
  Piece piece("plate");
  // Drawn for a dinner plate of 13.5 cm, foot to rim to well; the thickness stays when it shrinks.
  const Profile drawn{{0.0f, 0.004f},     {0.07f, 0.004f},   {0.072f, 0.0f},    {0.079f, 0.0f},
                      {0.082f, 0.004f},   {0.098f, 0.0085f}, {0.115f, 0.0145f}, {0.128f, 0.0185f},
                      {0.1343f, 0.0205f}, {0.135f, 0.0218f}, {0.1343f, 0.023f}, {0.1325f, 0.0233f},
                      {0.125f, 0.0218f},  {0.11f, 0.0175f},  {0.1f, 0.0135f},   {0.093f, 0.0095f},
                      {0.084f, 0.0082f},  {0.0f, 0.0082f}};
  Profile profile;
  for (const glm::vec2 point : drawn) profile.emplace_back(point.x * radius / 0.135f, point.y);
  addLathe(piece.part(glaze), glm::vec3(0.0f), profile, 50);
  return piece;
}

Piece cupAndSaucer() {
  Piece piece("cup and saucer");
  constexpr float kWell = 0.0048f;
  piece.add(saucer(), at(glm::vec3(0.0f)));
  piece.add(cup(), at({0.0f, kWell, 0.0f}, 35.0f));
  return piece;
}

Piece mug(Finish glaze, int segments) {
  Piece piece("mug");
  Mesh& china = piece.part(glaze);
  addLathe(china, glm::vec3(0.0f),
           Profile{{0.0f, 0.0f},
                   {0.037f, 0.0f},
                   {0.04f, 0.004f},
                   {0.041f, 0.09f},
                   {0.0395f, 0.0925f},
                   {0.038f, 0.09f},
                   {0.037f, 0.01f},
                   {0.0f, 0.008f}},
           segments);
  const std::array<TubePoint, 5> handle{TubePoint{{0.038f, 0.075f, 0}, 0.0055f},
                                        {{0.06f, 0.076f, 0}, 0.0055f},
                                        {{0.071f, 0.05f, 0}, 0.0055f},
                                        {{0.06f, 0.024f, 0}, 0.0055f},
                                        {{0.038f, 0.022f, 0}, 0.0055f}};
  addTube(china, handle, {segments / 3, segments / 2});
  addLathe(piece.part(Finish::tea), glm::vec3(0.0f), Profile{{0.0379f, 0.075f}, {0.0f, 0.075f}}, segments);
  return piece;
}

Piece teapot() {
  Piece pot("teapot");
  Mesh& china = pot.part(Finish::blueGlaze);
  addLathe(china, glm::vec3(0.0f),
           Profile{{0.0f, 0.004f},
                   {0.046f, 0.004f},
                   {0.048f, 0.0f},
                   {0.055f, 0.0f},
                   {0.056f, 0.006f},
                   {0.066f, 0.015f},
                   {0.079f, 0.034f},
                   {0.0865f, 0.056f},
                   {0.0875f, 0.076f},
                   {0.082f, 0.097f},
                   {0.069f, 0.114f},
                   {0.053f, 0.1245f},
                   {0.045f, 0.1275f},
                   {0.0435f, 0.132f},
                   {0.0415f, 0.133f},
                   {0.04f, 0.131f},
                   {0.04f, 0.125f},
                   {0.0f, 0.12f}},
           72);
  addLathe(china, {0.0f, 0.1295f, 0.0f},
           Profile{{0.0f, 0.0f},
                   {0.038f, 0.0f},
                   {0.0392f, 0.003f},
                   {0.036f, 0.007f},
                   {0.025f, 0.0125f},
                   {0.011f, 0.0155f},
                   {0.0065f, 0.018f},
                   {0.006f, 0.021f},
                   {0.0095f, 0.026f},
                   {0.0118f, 0.032f},
                   {0.0098f, 0.038f},
                   {0.005f, 0.0415f},
                   {0.0f, 0.0422f}},
           48);
  const std::array<TubePoint, 7> handle{
      TubePoint{{0.066f, 0.109f, 0}, 0.009f}, {{0.092f, 0.124f, 0}, 0.0078f}, {{0.124f, 0.12f, 0}, 0.0072f},
      {{0.14f, 0.094f, 0}, 0.0072f},          {{0.131f, 0.062f, 0}, 0.0072f}, {{0.106f, 0.042f, 0}, 0.0076f},
      {{0.075f, 0.035f, 0}, 0.009f}};
  addTube(china, handle, {16, 36});
  const std::array<TubePoint, 6> spout{
      TubePoint{{-0.07f, 0.045f, 0}, 0.024f}, {{-0.098f, 0.056f, 0}, 0.019f},
      {{-0.118f, 0.081f, 0}, 0.014f},         {{-0.131f, 0.108f, 0}, 0.011f},
      {{-0.148f, 0.126f, 0}, 0.0098f},        {{-0.1575f, 0.1305f, 0}, 0.0104f}};
  addTube(china, spout, {20, 30});
  // Tea stands just below the spout's lip.
  addRod(pot.part(Finish::tea), {-0.152f, 0.1277f, 0.0f}, {-0.1568f, 0.1302f, 0.0f}, 0.0101f, 20);
  return pot;
}

Piece milkJug() {
  Piece jug("milk jug");
  Mesh& china = jug.part(Finish::porcelain);
  const std::size_t first = china.vertices.size();
  addLathe(china, glm::vec3(0.0f),
           Profile{{0.0f, 0.003f},   {0.026f, 0.003f},  {0.028f, 0.0f},   {0.032f, 0.0f},    {0.034f, 0.005f},
                   {0.042f, 0.02f},  {0.046f, 0.036f},  {0.044f, 0.052f}, {0.036f, 0.072f},  {0.033f, 0.085f},
                   {0.035f, 0.098f}, {0.0385f, 0.107f}, {0.038f, 0.109f}, {0.0365f, 0.108f}, {0.033f, 0.098f},
                   {0.031f, 0.085f}, {0.034f, 0.072f},  {0.042f, 0.052f}, {0.043f, 0.036f},  {0.036f, 0.015f},
                   {0.0f, 0.008f}},
           48);
  // Pull the rim out into a lip on the side away from the handle.
  for (std::size_t i = first; i < china.vertices.size(); ++i) {
    glm::vec3& p = china.vertices[i].position;
    const float rise = glm::smoothstep(0.078f, 0.108f, p.y);
    const float forward = glm::smoothstep(0.018f, 0.037f, -p.x);
    p.x -= 0.02f * rise * forward;
    p.y += 0.006f * rise * forward;
    p.z *= 1.0f - 0.5f * rise * forward;
  }
  const std::array<TubePoint, 5> handle{TubePoint{{0.033f, 0.094f, 0}, 0.0048f},
                                        {{0.052f, 0.097f, 0}, 0.004f},
                                        {{0.067f, 0.075f, 0}, 0.004f},
                                        {{0.061f, 0.047f, 0}, 0.004f},
                                        {{0.043f, 0.035f, 0}, 0.005f}};
  addHandle(china, handle);
  return jug;
}

Piece sugarBowl() {
  Piece bowl("sugar bowl");
  Mesh& china = bowl.part(Finish::porcelain);
  addLathe(china, glm::vec3(0.0f),
           Profile{{0.0f, 0.003f},
                   {0.028f, 0.003f},
                   {0.03f, 0.0f},
                   {0.034f, 0.0f},
                   {0.036f, 0.005f},
                   {0.046f, 0.018f},
                   {0.051f, 0.034f},
                   {0.05f, 0.05f},
                   {0.046f, 0.06f},
                   {0.046f, 0.063f},
                   {0.038f, 0.071f},
                   {0.022f, 0.078f},
                   {0.009f, 0.081f},
                   {0.006f, 0.084f},
                   {0.0085f, 0.09f},
                   {0.0085f, 0.096f},
                   {0.004f, 0.1f},
                   {0.0f, 0.1005f}},
           48);
  for (const float side : {-1.0f, 1.0f}) {
    const std::array<TubePoint, 5> ear{TubePoint{{side * 0.047f, 0.052f, 0}, 0.004f},
                                       {{side * 0.062f, 0.055f, 0}, 0.0034f},
                                       {{side * 0.069f, 0.044f, 0}, 0.0034f},
                                       {{side * 0.062f, 0.033f, 0}, 0.0034f},
                                       {{side * 0.049f, 0.031f, 0}, 0.004f}};
    addTube(china, ear, {10, 16});
  }
  return bowl;
}

Piece candlestick(float height) {
  Piece piece("candlestick");
  const float stem = height * 0.55f;
  addLathe(piece.part(Finish::brass), glm::vec3(0.0f),
           Profile{{0.0f, 0.0f},
                   {0.055f, 0.0f},
                   {0.055f, 0.004f},
                   {0.045f, 0.01f},
                   {0.02f, 0.018f},
                   {0.011f, 0.03f},
                   {0.009f, 0.3f * stem},
                   {0.017f, 0.36f * stem},
                   {0.019f, 0.42f * stem},
                   {0.011f, 0.5f * stem},
                   {0.009f, 0.8f * stem},
                   {0.014f, 0.9f * stem},
                   {0.024f, 0.96f * stem},
                   {0.025f, stem},
                   {0.013f, stem},
                   {0.0f, stem - 0.01f}},
           32);
  addLathe(
      piece.part(Finish::linen), {0.0f, stem - 0.02f, 0.0f},
      Profile{{0.0115f, 0.0f}, {0.0105f, 0.42f * height}, {0.008f, 0.45f * height}, {0.0f, 0.448f * height}},
      20);
  return piece;
}

}  // namespace host::furniture
