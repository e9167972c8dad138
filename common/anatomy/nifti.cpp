// NIfTI-1 format, single file: a 348-byte binary header ("n+1"), then the voxels at vox_offset, x fastest.

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

// Rotation matrix of the quaternion (a, b, c, d); the third axis is reversed if qfac is negative.
Mat3 quaternion_axes(double b, double c, double d, double qfac) {
  const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
  Mat3 r = Quat(a, b, c, d).normalized().toRotationMatrix();
  if (qfac < 0) r.col(2) *= -1;
  return r;
}

/// The file axes mapped to x, y and z, and which are reversed.
struct Axes {
  std::array<int, 3> axis = {0, 1, 2};
  std::array<bool, 3> flip{};
  bool operator==(const Axes&) const = default;
};

/// Returns the file axes nearest to right, anterior and superior, and whether each points the other way.
Axes axes_of(const Mat3& file_to_patient) {
  Axes out;
  Mat3 a = file_to_patient.cwiseAbs();
  for (int k = 0; k < 3; ++k) a.col(k).normalize();
  for (int n = 0; n < 3; ++n) {
    int row = 0, col = 0;
    a.maxCoeff(&row, &col);
    out.axis[static_cast<std::size_t>(row)] = col;
    out.flip[static_cast<std::size_t>(col)] = file_to_patient(row, col) < 0;
    a.row(row).setConstant(-1);
    a.col(col).setConstant(-1);
  }
  return out;
}

std::string in_mm(const Vec3& metres) {
  return fmt::format("{:.4g} x {:.4g} x {:.4g} mm", 1e3 * metres[0], 1e3 * metres[1], 1e3 * metres[2]);
}

/// Returns 1 − the volume of the parallelepiped of three steps over that of a right-angled box, 0 to 1.
double shear(const Mat3& steps) {
  return 1 - std::abs(steps.determinant()) / steps.colwise().norm().prod();
}

bool spans_space(const Mat3& steps) {
  return steps.allFinite() && steps.colwise().norm().minCoeff() > 1e-12 && shear(steps) < 0.999;
}

/// Uses the voxel size of the sform's columns if pixdim differs, as other programs do.
void use_sform_voxel_size(VolumeHeader& h, const Mat3& sform, double metres, const std::string& name) {
  const Vec3 steps = metres * sform.colwise().norm().transpose();
  constexpr double rounding = 1e-3;
  if (!((steps - h.voxel_size).cwiseQuotient(steps).cwiseAbs().maxCoeff() <= rounding)) {
    h.notes.push_back(
        fmt::format("warning: its voxel size is {} in pixdim and {} in the sform: the sform is used. If that "
                    "is wrong, correct the file's header",
                    in_mm(h.voxel_size), in_mm(steps)));
    h.voxel_size = steps;
  }
  const double too_large = shear(sform);
  constexpr double reported = 0.02, refused = 0.2;
  if (too_large > refused)
    throw InputError(fmt::format(
        "{}: header: the sform's axes are {:.0f} % sheared; allowed: at most {:.0f} %. Resample it to right "
        "angles",
        name, 100 * too_large, 100 * refused));
  if (too_large > reported)
    h.notes.push_back(
        fmt::format("warning: its sform is sheared, which is ignored: structures become {:.0f} % too large; "
                    "resample it to right angles",
                    100 * too_large));
}

/// The header's bytes, read as numbers in the file's byte order; `name` is the file's, for messages.
struct HeaderBytes {
  std::span<const std::uint8_t> head;
  bool swap = false;  // whether the file's byte order isn't this machine's
  const std::string& name;

  std::int16_t whole(std::size_t at) const { return field<std::int16_t>(head, at, swap); }
  double real(std::size_t at) const { return static_cast<double>(field<float>(head, at, swap)); }
};

/// Determines the file's byte order by the header's first field, its own size, which is known. Throws
/// InputError if the field is wrong in both byte orders.
HeaderBytes in_byte_order(std::span<const std::uint8_t> head, const std::string& name) {
  constexpr auto swapped_size = std::int32_t{0x5c010000};
  const auto size = field<std::int32_t>(head, 0, false);
  if (size != static_cast<std::int32_t>(header_bytes) && size != swapped_size)
    throw InputError(
        fmt::format("{}: header: sizeof_hdr {}; allowed: {} in either byte order", name, size, header_bytes));
  return {head, size == swapped_size, name};
}

/// Reads the numbers of voxels along the three axes, 1 for an axis that the file lacks. Returns the number of
/// axes of the file. Throws InputError if that is out of range, or if the file has more than one volume.
int read_dimensions(VolumeHeader& h, const HeaderBytes& in) {
  const auto rank = in.whole(40);
  if (rank < 1 || rank > 7)
    throw InputError(fmt::format("{}: header: {} dimensions; allowed: 1 to 7", in.name, rank));
  h.dims = {1, 1, 1};
  for (int k = 0; k < rank; ++k) {
    const auto d = in.whole(static_cast<std::size_t>(42 + 2 * k));
    if (k < 3)
      h.dims[static_cast<std::size_t>(k)] = d;
    else if (d > 1)
      throw InputError(
          fmt::format("{}: header: dimension {} has {} steps; allowed: one 3-D volume. Save one volume alone",
                      in.name, k + 1, d));
  }
  return rank;
}

/// Returns the type of the voxels. Throws InputError if it is not supported.
VoxelType voxel_type(const HeaderBytes& in) {
  switch (const auto type = in.whole(70)) {
    case 2:
      return VoxelType::uint8;
    case 256:
      return VoxelType::int8;
    case 4:
      return VoxelType::int16;
    case 512:
      return VoxelType::uint16;
    case 8:
      return VoxelType::int32;
    case 768:
      return VoxelType::uint32;
    case 1024:
      return VoxelType::int64;
    case 1280:
      return VoxelType::uint64;
    case 16:
      return VoxelType::float32;
    case 64:
      return VoxelType::float64;
    default:
      throw InputError(fmt::format(
          "{}: header: datatype {}; allowed: 2 (uint8), 256 (int8), 4 (int16), 512 (uint16), 8 (int32), 768 "
          "(uint32), 1024 (int64), 1280 (uint64), 16 (float32), 64 (float64). Save it as one of these",
          in.name, type));
  }
}

/// Returns the metres of the header's unit of length, which is millimetres if it states none.
double metres_per_unit(const HeaderBytes& in) {
  // xyzt_units, low three bits: 1 metre, 2 millimetre (also the default), 3 micrometre.
  const int unit = in.head[123] & 7;
  return unit == 1 ? 1 : unit == 3 ? 1e-6 : 1e-3;
}

/// Returns the voxel size that pixdim states, in metres; one unit along axes that the file lacks.
Vec3 pixdim_voxel_size(const HeaderBytes& in, int rank, double metres) {
  Vec3 out;
  for (int k = 0; k < 3; ++k)
    out[k] = k < rank ? metres * std::abs(in.real(static_cast<std::size_t>(80 + 4 * k))) : metres;
  return out;
}

/// Reads the byte of the file at which the voxels start. Throws InputError if it is in the header, or more
/// than 16 MiB from the start.
void read_offset(VolumeHeader& h, const HeaderBytes& in) {
  auto offset = in.real(108);
  if (offset == 0) {
    offset = header_bytes + 4;
    h.notes.push_back(fmt::format("the file's header has no voxel offset: byte {} is assumed", offset));
  }
  constexpr double max_offset = 16 * 1024 * 1024;
  if (!(offset >= 348 && offset <= max_offset))
    throw InputError(fmt::format("{}: header: the voxels start at byte {}; allowed: byte {} to {}", in.name,
                                 offset, header_bytes, max_offset));
  h.offset = static_cast<std::size_t>(offset);
}

/// Reads the linear function that maps stored numbers to values: the identity if the header has none.
void read_scaling(VolumeHeader& h, const HeaderBytes& in) {
  h.slope = in.real(112);
  h.intercept = in.real(116);
  if (!std::isfinite(h.slope)) {
    h.notes.push_back(fmt::format("its scl_slope is {}: no scaling is applied", h.slope));
    h.slope = 0;
  }
  if (h.slope == 0) {  // the standard's value for "unscaled"
    h.slope = 1;
    h.intercept = 0;
  }
}

/// Reads the orientation of the file's axes in the patient from the sform, or else from the qform; without
/// either, the axes stay as in the file. Also replaces the voxel size by that of the sform if they differ.
void read_orientation(VolumeHeader& h, const HeaderBytes& in, double metres) {
  Mat3 sform, qform = quaternion_axes(in.real(256), in.real(260), in.real(264), in.real(76));
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) sform(r, c) = in.real(static_cast<std::size_t>(280 + 16 * r + 4 * c));
  const bool has_sform = in.whole(254) > 0;
  const bool use_sform = has_sform && spans_space(sform);
  const bool use_qform = in.whole(252) > 0 && spans_space(qform);
  if (has_sform && !use_sform) h.notes.push_back("warning: its sform is singular and is not used");
  if (use_sform) use_sform_voxel_size(h, sform, metres, in.name);
  if (use_sform && use_qform && axes_of(sform) != axes_of(qform))
    h.notes.push_back(
        "warning: its sform and qform have different orientations: the sform is used; check left and right");
  if (use_sform || use_qform) {
    const Axes axes = axes_of(use_sform ? sform : qform);
    h.axis = axes.axis;
    h.flip = axes.flip;
    h.oriented = true;
  }
}

}  // namespace

bool is_nifti(std::span<const std::uint8_t> head) {
  return head.size() >= header_bytes && std::memcmp(head.data() + 344, "n+1", 4) == 0;
}

std::string unsupported_nifti(std::span<const std::uint8_t> head) {
  if (head.size() < header_bytes) return "";
  const auto starts = [&](std::size_t at, const char* magic) {
    return std::memcmp(head.data() + at, magic, 3) == 0;
  };
  if (starts(344, "ni1")) return " (the header of a .hdr/.img pair: save both as one .nii)";
  if (starts(4, "n+2") || starts(4, "ni2")) return " (NIfTI-2: save it as NIfTI-1)";
  return "";
}

VolumeHeader parse_nifti_header(std::span<const std::uint8_t> head, const std::string& name) {
  const HeaderBytes in = in_byte_order(head, name);
  const double metres = metres_per_unit(in);
  VolumeHeader h;
  h.big_endian = in.swap != (std::endian::native == std::endian::big);
  const int rank = read_dimensions(h, in);
  h.type = voxel_type(in);
  h.voxel_size = pixdim_voxel_size(in, rank, metres);
  read_offset(h, in);
  read_scaling(h, in);
  read_orientation(h, in, metres);
  return h;
}

}  // namespace prosector
