#pragma once
// A medical volume: voxels on a regular grid.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector {

inline constexpr std::int64_t max_volume_voxels = std::int64_t{1} << 29;  // 512 Mi
inline constexpr std::int64_t max_volume_dim = 8192;
inline constexpr double max_voxel_size = 0.1;  // m

/// A medical volume. Voxel (i, j, k) is values[i + dims[0](j + dims[1] k)], centred at voxel_size·((i, j, k)
/// − (dims − 1)/2): the frame's origin is the volume's centre. Axes are the file's. NIfTI files with patient
/// orientation are permuted and flipped to the nearest of right, anterior, superior.
struct Volume {
  std::array<std::int64_t, 3> dims{};
  Vec3 voxel_size = Vec3::Zero();       // m
  std::vector<float> values;            // finite
  bool oriented = false;                // the axes are right, anterior, superior
  std::vector<std::string> notes = {};  // ambiguities in the file, and how they were resolved

  float at(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return values[static_cast<std::size_t>(i + dims[0] * (j + dims[1] * k))];
  }
  Vec3 position(const Vec3& index) const {
    return (index - 0.5 * (Vec3(static_cast<double>(dims[0]), static_cast<double>(dims[1]),
                                static_cast<double>(dims[2])) -
                           Vec3::Ones()))
        .cwiseProduct(voxel_size);
  }
};

/// Returns the volume's value at x (m, volume's frame), interpolated trilinearly between voxel centres.
/// Outside them, the nearest border value is used.
double sample(const Volume& volume, const Vec3& x);

}  // namespace prosector
