#pragma once
// What the volume formats share: typed voxels to floats, and the checks on what a header claims.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "common/anatomy/volume.h"

namespace prosector {

enum class VoxelType : std::uint8_t {
  uint8,
  int8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};
std::size_t voxel_bytes(VoxelType type);

/// What a header says before its voxels are read.
struct VolumeHeader {
  std::array<std::int64_t, 3> dims{};
  Vec3 voxel_size = Vec3::Zero();  // m
  VoxelType type = VoxelType::uint8;
  bool big_endian = false;
  std::size_t offset = 0;  // bytes from the file's start to the voxels
  double slope = 1, intercept = 0;
  std::array<int, 3> axis = {0, 1, 2};  // file axis that becomes x, y, z
  std::array<bool, 3> flip{};           // of the file's axes
  bool oriented = false;                // x, y, z are the patient's right, anterior, superior
  std::vector<std::string> notes;       // as of Volume
};

/// Throws InputError when dims, voxel size or scaling are out of range. Returns the bytes of all voxels.
std::size_t check_header(const VolumeHeader& header, const std::string& name);

/// Reads the voxels; `bytes` is the whole unpacked file. Throws InputError when it is too short or a voxel
/// isn't finite.
Volume read_voxels(const VolumeHeader& header, std::span<const std::uint8_t> bytes, const std::string& name);

/// The most bytes of a file that its header takes. Headers are read from the file's first bytes.
inline constexpr std::size_t max_header_bytes = 64 * 1024;
bool is_inrimage(std::span<const std::uint8_t> head);
VolumeHeader parse_inrimage_header(std::span<const std::uint8_t> head, const std::string& name);
bool is_nifti(std::span<const std::uint8_t> head);
/// Returns which kind of NIfTI file that isn't read it is, and what to do, in parentheses; "": none.
std::string other_nifti(std::span<const std::uint8_t> head);
VolumeHeader parse_nifti_header(std::span<const std::uint8_t> head, const std::string& name);

}  // namespace prosector
