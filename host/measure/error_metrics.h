// How far an effect's picture is from its reference, on the effect's values before any rounding to eight
// bits: 0..1, but for SSGI's, which are exposed radiance (irradiance / pi) and may be larger.
#pragma once

#include <cstdint>

#include "host/image/image_file.h"
#include "host/measure/block_errors.h"

namespace host {

/// Of values one by one, wherever in a picture they are.
struct ValueErrors {
  double rms = 0.0;
  double max = 0.0;
  std::int64_t nonFinite =
      0;  ///< values that are NaN or infinite in either image; each counts as an error of 1
};

/// Compares images of the same size and number of channels; throws std::invalid_argument for others.
ValueErrors compareValues(const FloatImage& image, const FloatImage& reference);

/// Those of whole pictures.
struct ErrorMetrics {
  double rms = 0.0;
  double max = 0.0;
  double psnr = 0.0;           ///< decibels for a peak of 1, whatever the values; infinite for equal images
  double ssim = 1.0;           ///< structural similarity, 1 for equal images
  std::int64_t nonFinite = 0;  ///< as in ValueErrors
  BlockErrors blocks = {};
};

/// Compares images of the same size and number of channels; throws std::invalid_argument for others. SSIM is
/// that of Wang, Bovik, Sheikh and Simoncelli, "Image Quality Assessment: From Error Visibility to Structural
/// Similarity" (2004): an 11x11 Gaussian window of sigma 1.5, K1 = 0.01, K2 = 0.03, the mean over the windows
/// that lie inside of the image; images narrower than a window use the part of it that is inside.
ErrorMetrics compareImages(const FloatImage& image, const FloatImage& reference);

/// |image - reference| * enhancement, clamped to 0..1; 1 where either isn't finite.
FloatImage differenceImage(const FloatImage& image, const FloatImage& reference, float enhancement);

}  // namespace host
