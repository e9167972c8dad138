// NIfTI-1, single file: a 348-byte binary header ("n+1"), then the voxels at vox_offset, x fastest.

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "common/anatomy/voxels.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t header_bytes = 348;

template <class T>
T field(std::span<const std::uint8_t> head, std::size_t at, bool swap) {
  std::array<std::uint8_t, sizeof(T)> raw;
  std::memcpy(raw.data(), head.data() + at, sizeof(T));
  if (swap) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

// Rotation of the quaternion (b, c, d) with the third axis turned round by qfac.
Mat3 quaternion_axes(double b, double c, double d, double qfac) {
  const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
  Mat3 r = Quat(a, b, c, d).normalized().toRotationMatrix();
  if (qfac < 0) r.col(2) *= -1;
  return r;
}

// Which file axis lies nearest to right, anterior, superior, and whether it runs the other way.
void orient(VolumeHeader& h, const Mat3& file_to_patient) {
  Mat3 a = file_to_patient.cwiseAbs();
  if (!a.allFinite() || a.colwise().norm().minCoeff() < 1e-12) return;
  for (int k = 0; k < 3; ++k) a.col(k).normalize();
  for (int n = 0; n < 3; ++n) {
    int row = 0, col = 0;
    a.maxCoeff(&row, &col);
    h.axis[static_cast<std::size_t>(row)] = col;
    h.flip[static_cast<std::size_t>(col)] = file_to_patient(row, col) < 0;
    a.row(row).setConstant(-1);
    a.col(col).setConstant(-1);
  }
}

}  // namespace

bool is_nifti(std::span<const std::uint8_t> head) {
  return head.size() >= header_bytes && std::memcmp(head.data() + 344, "n+1", 4) == 0;
}

VolumeHeader parse_nifti_header(std::span<const std::uint8_t> head, const std::string& name) {
  constexpr auto swapped_size = std::int32_t{0x5c010000};
  const auto size = field<std::int32_t>(head, 0, false);
  if (size != static_cast<std::int32_t>(header_bytes) && size != swapped_size)
    throw InputError(
        fmt::format("{}: header: sizeof_hdr {}; allowed: {} in either byte order", name, size, header_bytes));
  const bool swap = size == swapped_size;
  VolumeHeader h;
  h.big_endian = swap != (std::endian::native == std::endian::big);

  const auto rank = field<std::int16_t>(head, 40, swap);
  if (rank < 1 || rank > 7)
    throw InputError(fmt::format("{}: header: {} dimensions; allowed: 1 to 7", name, rank));
  h.dims = {1, 1, 1};
  for (int k = 0; k < rank; ++k) {
    const auto d = field<std::int16_t>(head, static_cast<std::size_t>(42 + 2 * k), swap);
    if (k < 3)
      h.dims[static_cast<std::size_t>(k)] = d;
    else if (d > 1)
      throw InputError(
          fmt::format("{}: header: dimension {} has {} steps; allowed: one 3-D volume", name, k + 1, d));
  }

  switch (const auto type = field<std::int16_t>(head, 70, swap)) {
    case 2:
      h.type = VoxelType::uint8;
      break;
    case 256:
      h.type = VoxelType::int8;
      break;
    case 4:
      h.type = VoxelType::int16;
      break;
    case 512:
      h.type = VoxelType::uint16;
      break;
    case 8:
      h.type = VoxelType::int32;
      break;
    case 768:
      h.type = VoxelType::uint32;
      break;
    case 16:
      h.type = VoxelType::float32;
      break;
    case 64:
      h.type = VoxelType::float64;
      break;
    default:
      throw InputError(fmt::format(
          "{}: header: datatype {}; allowed: 2 (uint8), 256 (int8), 4 (int16), 512 (uint16), 8 (int32), "
          "768 (uint32), 16 (float32), 64 (float64)",
          name, type));
  }

  // xyzt_units, low three bits: 1 metre, 2 millimetre (also when unsaid), 3 micrometre.
  const int unit = head[123] & 7;
  const double metres = unit == 1 ? 1 : unit == 3 ? 1e-6 : 1e-3;
  for (int k = 0; k < 3; ++k)
    h.voxel_size[k] = k < rank ? metres * std::abs(static_cast<double>(
                                              field<float>(head, static_cast<std::size_t>(80 + 4 * k), swap)))
                               : metres;

  const auto offset = static_cast<double>(field<float>(head, 108, swap));
  constexpr double max_offset = 16 * 1024 * 1024;
  if (!(offset >= 348 && offset <= max_offset))
    throw InputError(fmt::format("{}: header: voxels at byte {}; allowed: {} to {}", name, offset,
                                 header_bytes, max_offset));
  h.offset = static_cast<std::size_t>(offset);
  h.slope = static_cast<double>(field<float>(head, 112, swap));
  h.intercept = static_cast<double>(field<float>(head, 116, swap));
  if (h.slope == 0) {  // the standard's way to say "unscaled"
    h.slope = 1;
    h.intercept = 0;
  }

  const auto real = [&](std::size_t at) { return static_cast<double>(field<float>(head, at, swap)); };
  if (field<std::int16_t>(head, 254, swap) > 0) {  // sform_code: affine rows srow_x, srow_y, srow_z
    Mat3 affine;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) affine(r, c) = real(static_cast<std::size_t>(280 + 16 * r + 4 * c));
    orient(h, affine);
  } else if (field<std::int16_t>(head, 252, swap) > 0) {  // qform_code
    orient(h, quaternion_axes(real(256), real(260), real(264), real(76)));
  }
  return h;
}

}  // namespace prosector
