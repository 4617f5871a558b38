#include "mres/level/frame_params.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <stdexcept>

#include "mres/level/depth_pyramid.h"
#include "mres/validate.h"

namespace mres {
namespace {

void validate(const Frame& frame) {
  if (frame.depth == 0 || frame.normals == 0) {
    throw std::invalid_argument("Frame::depth and Frame::normals must name textures; one of them is 0.");
  }
  if (!isTextureSize(frame.size)) {
    throw std::invalid_argument("Frame::size must be 1 to 16384 pixels in each direction.");
  }
  if (!isFinite(frame.view) || !isFinite(frame.projection)) {
    throw std::invalid_argument("Frame::view and Frame::projection must be finite matrices.");
  }
}

/// Whether a row has nothing in the two columns, but for rounding.
bool isZero(glm::vec4 row, int column, int otherColumn) {
  constexpr float kRounding = 1e-6f;
  const glm::vec4 size = glm::abs(row);
  const float largest = std::max({size.x, size.y, size.z, size.w});
  return std::max(size[column], size[otherColumn]) <= kRounding * largest;
}

/// Coefficients (a, b, c, d) of view depth = (a + b t) / (c + d t) for window depth t: the projection's third
/// and fourth row solved for -z.
glm::dvec4 lineariseCoefficients(const Frame& frame) {
  const glm::dmat4 p(frame.projection);
  const glm::dvec2 ndcFromWindow =
      frame.clipDepth == ClipDepth::minusOneToOne ? glm::dvec2(2.0, -1.0) : glm::dvec2(1.0, 0.0);
  // ndc = s t + o;  -z = (p32 - ndc p33) / (p22 - ndc p23)
  return {p[3][2] - ndcFromWindow.y * p[3][3], -ndcFromWindow.x * p[3][3],
          p[2][2] - ndcFromWindow.y * p[2][3], -ndcFromWindow.x * p[2][3]};
}

double viewDepthAt(const glm::dvec4& linearise, double windowDepth) {
  return (linearise.x + linearise.y * windowDepth) / (linearise.z + linearise.w * windowDepth);
}

void validateProjection(const Frame& frame, const glm::dvec4& linearise) {
  const glm::mat4& p = frame.projection;
  const bool orthographic = p[2][3] == 0.0f;
  const bool axisAligned = p[0][0] != 0.0f && p[1][1] != 0.0f && isZero(glm::row(p, 0), 1, 1) &&
                           isZero(glm::row(p, 1), 0, 0) && isZero(glm::row(p, 3), 0, 1);
  if (!axisAligned || (orthographic && !(p[3][3] > 0.0f))) {
    throw std::invalid_argument("Frame::projection must be a perspective or orthographic projection.");
  }
  if (!isZero(glm::row(p, 2), 0, 1)) {
    throw std::invalid_argument(
        "Frame::projection must not have an oblique near plane; give the projection without it.");
  }
  if (linearise.x * linearise.w == linearise.y * linearise.z) {
    throw std::invalid_argument("Frame::projection must map different view depths to different depths.");
  }
  const bool allBehind = std::max(viewDepthAt(linearise, 0.0), viewDepthAt(linearise, 1.0)) <= 0.0;
  if (orthographic ? allBehind : p[2][3] > 0.0f) {
    throw std::invalid_argument(
        "Frame::projection must be right-handed, with the camera looking along -Z of view space.");
  }
}

/// A reversed projection puts the far plane at window depth 0.
bool isReversed(const glm::dvec4& linearise) {
  const double atZero = viewDepthAt(linearise, 0.0);
  const double atOne = viewDepthAt(linearise, 1.0);
  const bool orthographic = linearise.w == 0.0;
  if (orthographic) return atZero > atOne;  // the near plane may lie behind the eye
  // An infinite far plane shows as infinity of either sign, or as an enormous negative number by rounding.
  const auto distance = [](double depth) { return std::isfinite(depth) && depth >= 0.0 ? depth : INFINITY; };
  return distance(atZero) > distance(atOne);
}

/// Scale and offset of filter depth, as the shaders have it. Half floats hold 2^-14..65504. In perspective
/// their relative precision is just right, and the nearest surface goes to 1/16; parallel views, in which the
/// near plane may lie behind the eye, spread evenly from 1/16 to 1024.
glm::dvec2 filterDepthMap(double near, double far, bool perspective) {
  constexpr double kNearest = 1.0 / 16.0;
  constexpr double kFarthest = 1024.0;
  if (perspective) return {kNearest / std::max(near, 1e-30), 0.0};
  const double scale = (kFarthest - kNearest) / std::max(far - near, 1e-30);
  return {scale, kNearest - near * scale};
}

/// Scale and offset of the filter's tolerance: a centimetre at two metres, and in parallel views what that is
/// for a camera of 60 degrees that sees as much, but no less than the steps of half floats are there.
glm::dvec2 filterTolerance(const Frame& frame, double range, bool perspective) {
  constexpr double kToleranceOverDepth = 0.005;
  constexpr double kHalfFloatStep = 1.0 / 2048.0;
  if (perspective) return {kToleranceOverDepth, 0.0};
  const double distance =
      1.0 / (std::abs(static_cast<double>(frame.projection[1][1])) * std::tan(glm::radians(30.0)));
  return {0.0, std::max(kToleranceOverDepth * distance, kHalfFloatStep * range)};
}

void setFilterDepth(const Frame& frame, const glm::dvec4& linearise, bool reversed,
                    params::FrameParams& params) {
  const bool perspective = frame.projection[2][3] != 0.0f;
  const double near = viewDepthAt(linearise, reversed ? 1.0 : 0.0);
  const double far = viewDepthAt(linearise, reversed ? 0.0 : 1.0);
  params.filterDepth = filterDepthMap(near, far, perspective);
  params.filterTolerance = filterTolerance(frame, far - near, perspective);
}

void setUnprojection(const Frame& frame, params::FrameParams& params) {
  const glm::dmat4 p(frame.projection);
  const glm::dvec2 scale = 2.0 / (glm::dvec2(frame.size) * glm::dvec2(p[0][0], p[1][1]));
  const glm::dvec2 inverse = 1.0 / glm::dvec2(p[0][0], p[1][1]);
  const glm::dvec2 shear(p[2][0], p[2][1]);
  const glm::dvec2 shift(p[3][0], p[3][1]);
  const double wPerDepth = -p[2][3];
  const double wConstant = p[3][3];
  // ndc w = p00 x + p20 z + p30 with w = wPerDepth depth + wConstant and z = -depth, solved for x.
  params.unprojectScaled = glm::vec4(scale * wPerDepth, inverse * (shear - wPerDepth));
  params.unprojectConstant = glm::vec4(scale * wConstant, inverse * (-shift - wConstant));
}

}  // namespace

params::FrameParams frameParams(const Frame& frame) {
  validate(frame);
  const glm::dvec4 linearise = lineariseCoefficients(frame);
  validateProjection(frame, linearise);
  params::FrameParams params{};
  const glm::vec2 halfSize = glm::vec2(frame.size) * 0.5f;
  const glm::vec4 rowW = glm::row(frame.projection, 3);
  params.viewFromNormals =
      frame.normalSpace == NormalSpace::world ? glm::mat4(glm::mat3(frame.view)) : glm::mat4(1.0f);
  params.pixelX = halfSize.x * (glm::row(frame.projection, 0) + rowW);
  params.pixelY = halfSize.y * (glm::row(frame.projection, 1) + rowW);
  params.clipW = rowW;
  setUnprojection(frame, params);

  const bool reversed = isReversed(linearise);
  params.linearise = glm::vec4(linearise);
  params.normalDecode =
      frame.normalEncoding == NormalEncoding::unsignedXyz ? glm::vec2(2.0f, -1.0f) : glm::vec2(1.0f, 0.0f);
  params.size = frame.size;
  params.backgroundDepth = reversed ? 0.0f : 1.0f;
  setFilterDepth(frame, linearise, reversed, params);
  params.pixelsPerMetre = std::abs(frame.projection[1][1]) * halfSize.y;
  params.pyramidLevels = depthPyramidLevels(frame.size);
  return params;
}

}  // namespace mres
