#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/furniture_shapes.h"
#include "host/scene/builtin/furniture_tableware.h"

namespace host::furniture {

namespace {

// A cross-section of a flat curved thing along its length.
struct Station {
  float along;      // from the tip, as a share of the length
  float halfWidth;  // all others in metres
  float height;     // of the edge above the table
  float dish;       // how far the middle lies below the edge
  float thickness;
};

// Widths and heights follow a smooth curve; the way along runs straight from station to station, never back.
Station between(std::span<const Station> stations, float t) {
  std::vector<TubePoint> shape;
  for (const Station& s : stations) shape.push_back({{s.halfWidth, s.height, s.dish}, s.thickness});
  const TubePoint at = alongCurve(shape, t);
  const auto last = static_cast<float>(stations.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(t * last), stations.size() - 2);
  const float along = glm::mix(stations[i].along, stations[i + 1].along, t * last - static_cast<float>(i));
  return {along, std::max(at.position.x, 0.0f), at.position.y, at.position.z, std::max(at.radius, 0.0f)};
}

// The closed surface through the stations: a lens-shaped section, dished along its middle.
void addBlade(Mesh& mesh, std::span<const Station> stations, float length, glm::ivec2 segments) {
  const auto surface = [&](float u, float v) {
    const Station s = between(stations, v);
    const float angle = u * glm::two_pi<float>();
    const float across = std::cos(angle);
    const float bowl =
        1.0f - across * across;  // squared: level at the rim, so that the edge keeps its thickness
    const float above = 0.5f * s.thickness * (1.0f + std::sin(angle));
    const float y = s.height - s.dish * bowl * bowl + above;
    return glm::vec3(s.halfWidth * across, y, (s.along - 0.5f) * length);
  };
  modelling::addPatch(mesh, surface, segments);
}

// A handle that thins at the neck, widens towards its end and rises from `neckHeight` into a gentle arch.
std::array<Station, 6> handleFrom(float neck, float neckHeight, float width, float thickness) {
  return {Station{neck, 0.0026f, neckHeight, 0.0f, thickness * 1.3f},
          {0.5f, 0.003f, neckHeight + 0.001f, 0.0f, thickness},
          {0.75f, width * 0.7f, 0.006f, 0.0f, thickness},
          {0.92f, width, 0.0015f, 0.0f, thickness},
          {0.985f, width * 0.6f, 0.0f, 0.0f, thickness},
          {1.0f, 0.0f, 0.0005f, 0.0f, 0.0f}};
}

}  // namespace

Piece spoon(float length) {
  Piece piece("spoon");
  const float scale = length / 0.14f;
  const float w = 0.0155f * scale;
  const float deep = 0.0062f * scale;
  std::vector<Station> stations{{0.0f, 0.0f, deep, 0.0f, 0.0f},
                                {0.012f, w * 0.38f, deep, deep * 0.15f, 0.001f},
                                {0.06f, w * 0.8f, deep, deep * 0.62f, 0.0011f},
                                {0.14f, w, deep, deep, 0.0011f},
                                {0.22f, w * 0.86f, deep * 1.05f, deep * 0.85f, 0.0012f},
                                {0.29f, w * 0.45f, deep * 1.2f, deep * 0.3f, 0.0014f}};
  for (const Station& s : handleFrom(0.34f, deep * 1.5f, 0.0062f * scale, 0.0019f)) stations.push_back(s);
  addBlade(piece.part(Finish::silver), stations, length, {16, 36});
  return piece;
}

Piece fork(float length) {
  Piece piece("fork");
  Mesh& silver = piece.part(Finish::silver);
  std::vector<Station> stations{{0.17f, 0.0f, 0.0025f, 0.0f, 0.0f},
                                {0.18f, 0.0095f, 0.0022f, 0.0f, 0.0012f},
                                {0.24f, 0.0118f, 0.002f, 0.0015f, 0.0015f},
                                {0.3f, 0.0085f, 0.0045f, 0.001f, 0.0018f}};
  for (const Station& s : handleFrom(0.36f, 0.0085f, 0.0075f, 0.002f)) stations.push_back(s);
  addBlade(silver, stations, length, {12, 28});
  for (int tine = 0; tine < 4; ++tine) {
    const float x = (static_cast<float>(tine) - 1.5f) * 0.0062f;
    const auto z = [&](float along) { return (along - 0.5f) * length; };
    const std::array<TubePoint, 4> points{TubePoint{{x, 0.003f, z(0.21f)}, 0.0011f},
                                          {{x, 0.0018f, z(0.12f)}, 0.0012f},
                                          {{x, 0.005f, z(0.04f)}, 0.0011f},
                                          {{x, 0.009f, z(0.0f)}, 0.0004f}};
    addTube(silver, points, {6, 8});
  }
  return piece;
}

Piece knife(float length) {
  Piece piece("knife");
  const std::array<Station, 9> stations{
      Station{0.0f, 0.0f, 0.001f, 0.0f, 0.0f}, {0.015f, 0.006f, 0.001f, 0.0f, 0.0012f},
      {0.12f, 0.0105f, 0.001f, 0.0f, 0.0014f}, {0.4f, 0.0095f, 0.001f, 0.0f, 0.0018f},
      {0.52f, 0.007f, 0.001f, 0.0f, 0.0022f},  {0.56f, 0.0065f, 0.0003f, 0.0f, 0.0062f},
      {0.75f, 0.0078f, 0.0f, 0.0f, 0.0072f},   {0.96f, 0.0085f, 0.0f, 0.0f, 0.0075f},
      {1.0f, 0.0f, 0.003f, 0.0f, 0.0f}};
  addBlade(piece.part(Finish::silver), stations, length, {16, 32});
  return piece;
}

}  // namespace host::furniture
