#pragma once
// Extraction of one structure of a volume as a smooth solid.

#include <string>

#include "common/anatomy/field.h"
#include "common/anatomy/progress.h"
#include "common/anatomy/volume.h"

namespace prosector {

/// Binary mask of a structure in a medical volume: 1 inside, 0 outside, cropped to the structure with a
/// margin of zeros.
struct Mask {
  Volume volume;                   // values 0 or 1
  Vec3 origin = Vec3::Zero();      // m: the cropped volume's centre in the whole volume's frame
  std::size_t dropped_voxels = 0;  // in pieces other than the largest
  std::size_t dropped_pieces = 0;
  std::size_t filled_voxels = 0;  // in cavities, which are counted as inside

  /// Returns the total volume (m³) of the voxels inside the structure, filled cavities included.
  double inside_volume() const;
};

/// Returns the mask of the volume's voxels equal to `label`: the largest face-connected piece, with a border
/// of `margin` voxels. Throws InputError that lists the labels present if no voxel has this one. `name` is
/// used in messages.
Mask mask_of_label(const Volume& volume, int label, int margin, const std::string& name);

/// Returns the mask of the volume's voxels above `threshold`: the largest face-connected piece, with a border
/// of `margin` voxels. Throws InputError with the volume's range of values if none or all voxels are above
/// it. `name` is used in messages.
Mask mask_above(const Volume& volume, double threshold, int margin, const std::string& name);

/// Smooths the mask by a Gaussian with a standard deviation of `sigma` voxels along each axis. Returns a
/// solid whose field is level − smoothed mask, negative inside. The level is chosen to preserve the
/// structure's volume.
SolidField smooth_solid(const Mask& mask, double sigma);

/// Returns the width (voxels) of the border of zeros around the structure that smooth_solid() needs for a
/// Gaussian of `sigma` voxels.
int smoothing_margin(double sigma);

}  // namespace prosector
