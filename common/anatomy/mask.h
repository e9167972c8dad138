#pragma once
// One structure out of a volume, as a smooth solid.

#include <string>

#include "common/anatomy/field.h"
#include "common/anatomy/progress.h"
#include "common/anatomy/volume.h"

namespace prosector {

/// A structure as voxels: 1 inside, 0 outside, cropped to the structure with a margin of zeros; the frame
/// stays the volume's.
struct Mask {
  Volume volume;                   // values 0 or 1
  Vec3 origin = Vec3::Zero();      // the cropped volume's centre in the whole one's frame, m
  std::size_t dropped_voxels = 0;  // in other pieces
  std::size_t dropped_pieces = 0;
  std::size_t filled_voxels = 0;  // of cavities, which count as inside

  /// Returns the volume of the voxels inside (m³), cavities included.
  double inside_volume() const;
};

/// Returns voxels equal to `label`: the largest piece (joined through faces), with `margin` voxels of border.
/// Throws InputError that lists the labels present when there are none such.
Mask mask_of_label(const Volume& volume, int label, int margin, const std::string& name);

/// Returns voxels above `threshold`; throws InputError with the volume's range when there are none, or only
/// those.
Mask mask_above(const Volume& volume, double threshold, int margin, const std::string& name);

/// Smooths the mask by a Gaussian of σ `sigma` voxels along each axis and returns the field level − mask:
/// negative inside. The level is the one that keeps the structure's volume.
SolidField smooth_solid(const Mask& mask, double sigma);

/// Returns the border that `smooth_solid` needs around the structure, voxels.
int smoothing_margin(double sigma);

}  // namespace prosector
