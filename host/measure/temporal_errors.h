// Flicker: what a technique's picture does from frame to frame that its reference does not. An error that
// stays where it is may go unseen; one that comes and goes does not.
//
// The measure is the change of the technique's picture from one frame to the next minus that of the
// reference's, pixel by pixel: the change of the error, the temporal loss of Chaitanya et al., "Interactive
// Reconstruction of Monte Carlo Image Sequences using a Recurrent Denoising Autoencoder" (2017), with squares
// for absolute values. Nothing is reprojected, as measures without a reference have to: what moves across a
// pixel changes both pictures alike and drops out of the difference, edges and what they uncover included.
// An error that moves with the surface it is on does count, where it is not smooth: it passes over pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "host/image/image_file.h"

namespace host {

/// Of values, as of error_metrics.h, and over all pairs of frames that follow each other.
struct TemporalErrors {
  int frames = 0;
  double rms = 0.0;                ///< of the change of the error
  double max = 0.0;                ///< greatest absolute change of the error
  double blockMax = 0.0;           ///< greatest RMS of a block of 8x8 pixels in a pair of frames
  double blockPercentile99 = 0.0;  ///< RMS that 99 % of the blocks of all pairs do not exceed
  double techniqueChange = 0.0;    ///< RMS of the change of the technique's own picture
  double referenceChange = 0.0;    ///< the same of the reference: what there was to see anyway
  std::int64_t nonFinite = 0;      ///< changes from or to what is NaN or infinite; each counts as 1
};

/// Takes frame after frame, and keeps no picture but the last of each.
class TemporalErrorSum {
 public:
  /// Throws std::invalid_argument for pictures that differ from those before in size or number of channels.
  void add(FloatImage technique, FloatImage reference);

  /// Throws std::invalid_argument for less than two frames.
  [[nodiscard]] TemporalErrors result() const;

 private:
  void addChanges(const FloatImage& technique, const FloatImage& reference);

  TemporalErrors sums_;  // squares of what will be RMS
  std::vector<double> blocks_;
  FloatImage technique_;
  FloatImage reference_;
};

}  // namespace host
