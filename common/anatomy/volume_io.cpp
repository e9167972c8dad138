#include "common/anatomy/volume_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "common/anatomy/bytes.h"
#include "common/anatomy/voxels.h"
#include "common/error.h"

namespace prosector {
namespace {

template <class T>
double decode(const std::uint8_t* p, bool swap) {
  std::array<std::uint8_t, sizeof(T)> raw;
  std::memcpy(raw.data(), p, sizeof(T));
  if (swap) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

using Decoder = double (*)(const std::uint8_t*, bool);

Decoder decoder(VoxelType type) {
  switch (type) {
    case VoxelType::uint8:
      return decode<std::uint8_t>;
    case VoxelType::int8:
      return decode<std::int8_t>;
    case VoxelType::int16:
      return decode<std::int16_t>;
    case VoxelType::uint16:
      return decode<std::uint16_t>;
    case VoxelType::int32:
      return decode<std::int32_t>;
    case VoxelType::uint32:
      return decode<std::uint32_t>;
    case VoxelType::int64:
      return decode<std::int64_t>;
    case VoxelType::uint64:
      return decode<std::uint64_t>;
    case VoxelType::float32:
      return decode<float>;
    case VoxelType::float64:
      return decode<double>;
  }
  return nullptr;
}

}  // namespace

std::size_t voxel_bytes(VoxelType type) {
  switch (type) {
    case VoxelType::uint8:
    case VoxelType::int8:
      return 1;
    case VoxelType::int16:
    case VoxelType::uint16:
      return 2;
    case VoxelType::int32:
    case VoxelType::uint32:
    case VoxelType::float32:
      return 4;
    case VoxelType::int64:
    case VoxelType::uint64:
    case VoxelType::float64:
      return 8;
  }
  return 0;
}

std::size_t check_header(const VolumeHeader& h, const std::string& name) {
  std::int64_t voxels = 1;
  for (const std::int64_t d : h.dims) {
    if (d < 1 || d > max_volume_dim)
      throw InputError(fmt::format("{}: the volume has {} x {} x {} voxels; allowed: 1 to {} along each axis",
                                   name, h.dims[0], h.dims[1], h.dims[2], max_volume_dim));
    voxels *= d;
  }
  if (voxels > max_volume_voxels)
    throw InputError(fmt::format("{}: the volume has {} x {} x {} voxels; allowed: at most {} in all", name,
                                 h.dims[0], h.dims[1], h.dims[2], max_volume_voxels));
  for (int k = 0; k < 3; ++k)
    if (!(h.voxel_size[k] > 0 && h.voxel_size[k] <= max_voxel_size))
      throw InputError(
          fmt::format("{}: the voxel size is {} mm along axis {}; allowed: above 0, at most {} mm", name,
                      1000 * h.voxel_size[k], k, 1000 * max_voxel_size));
  if (!std::isfinite(h.slope) || !std::isfinite(h.intercept))
    throw InputError(
        fmt::format("{}: the scaling of voxel values is {} and their offset {}; allowed: finite numbers",
                    name, h.slope, h.intercept));
  return static_cast<std::size_t>(voxels) * voxel_bytes(h.type);
}

Volume read_voxels(const VolumeHeader& h, std::span<const std::uint8_t> bytes, const std::string& name) {
  const std::size_t size = check_header(h, name);
  if (bytes.size() < h.offset || bytes.size() - h.offset < size)
    throw InputError(
        fmt::format("{}: truncated: the file has {} bytes of voxels, but {} x {} x {} voxels need {}", name,
                    bytes.size() - std::min(bytes.size(), h.offset), h.dims[0], h.dims[1], h.dims[2], size));
  Volume out;
  out.notes = h.notes;
  out.oriented = h.oriented;
  for (std::size_t k = 0; k < 3; ++k) {
    out.dims[k] = h.dims[static_cast<std::size_t>(h.axis[k])];
    out.voxel_size[static_cast<int>(k)] = h.voxel_size[h.axis[k]];
  }
  out.values.resize(size / voxel_bytes(h.type));
  const Decoder decode_voxel = decoder(h.type);
  const bool swap = h.big_endian != (std::endian::native == std::endian::big);
  const std::uint8_t* p = bytes.data() + h.offset;
  std::array<std::int64_t, 3> i;  // indices along the file's axes
  for (i[2] = 0; i[2] < h.dims[2]; ++i[2])
    for (i[1] = 0; i[1] < h.dims[1]; ++i[1])
      for (i[0] = 0; i[0] < h.dims[0]; ++i[0], p += voxel_bytes(h.type)) {
        const auto value = static_cast<float>(h.slope * decode_voxel(p, swap) + h.intercept);
        if (!std::isfinite(value))
          throw InputError(fmt::format("{}: the value of voxel ({}, {}, {}) is not a finite number", name,
                                       i[0], i[1], i[2]));
        std::array<std::int64_t, 3> to;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto a = static_cast<std::size_t>(h.axis[k]);
          to[k] = h.flip[a] ? h.dims[a] - 1 - i[a] : i[a];
        }
        out.values[static_cast<std::size_t>(to[0] + out.dims[0] * (to[1] + out.dims[1] * to[2]))] = value;
      }
  return out;
}

Volume parse_volume(std::span<const std::uint8_t> bytes, const std::string& name) {
  const auto head = gunzip(bytes, max_header_bytes, name);
  VolumeHeader header;
  if (is_inrimage(head)) {
    header = parse_inrimage_header(head, name);
  } else if (is_nifti(head)) {
    header = parse_nifti_header(head, name);
  } else {
    throw InputError(
        fmt::format("{}: not a volume file{}; allowed: INRIMAGE-4 (.inr), single-file NIfTI-1 (.nii), either "
                    "also gzipped",
                    name, unsupported_nifti(head)));
  }
  const std::size_t size = check_header(header, name);
  if (!is_gzip(bytes)) return read_voxels(header, bytes, name);
  return read_voxels(header, gunzip(bytes, header.offset + size, name), name);
}

Volume load_volume(const std::filesystem::path& file) {
  return parse_volume(read_file(file), file.string());
}

}  // namespace prosector
