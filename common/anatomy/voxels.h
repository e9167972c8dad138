#pragma once
// Functions shared by the volume formats: conversion of typed voxels to floats, and checks of headers.

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

/// Content of the header of a medical volume file: dimensions, voxel size and type, scaling, and axes.
struct VolumeHeader {
  std::array<std::int64_t, 3> dims{};
  Vec3 voxel_size = Vec3::Zero();  // m
  VoxelType type = VoxelType::uint8;
  bool big_endian = false;
  std::size_t offset = 0;  // bytes from the start of the file to the voxels
  double slope = 1, intercept = 0;
  std::array<int, 3> axis = {0, 1, 2};  // file axis mapped to x, y, z
  std::array<bool, 3> flip{};           // whether each file axis is reversed
  bool oriented = false;                // x, y, z are the patient's right, anterior, superior
  std::vector<std::string> notes;       // as in Volume
};

/// Checks the header of a medical volume file. Throws InputError, naming `name`, if dimensions, voxel size or
/// scaling are out of range. Returns the number of bytes of all voxels.
std::size_t check_header(const VolumeHeader& header, const std::string& name);

/// Converts the voxels of a medical volume file; `bytes` is the whole decompressed file. Throws InputError,
/// naming `name`, if it is too short or a voxel isn't finite.
Volume read_voxels(const VolumeHeader& header, std::span<const std::uint8_t> bytes, const std::string& name);

/// Number of bytes from the start of a medical volume file in which its whole header is contained.
inline constexpr std::size_t max_header_bytes = 64 * 1024;
bool is_inrimage(std::span<const std::uint8_t> head);
VolumeHeader parse_inrimage_header(std::span<const std::uint8_t> head, const std::string& name);
bool is_nifti(std::span<const std::uint8_t> head);
/// Returns the name of an unsupported variant of NIfTI and a remedy, in parentheses, if `head` is the start
/// of such a file; "" for other files.
std::string unsupported_nifti(std::span<const std::uint8_t> head);
VolumeHeader parse_nifti_header(std::span<const std::uint8_t> head, const std::string& name);

}  // namespace prosector
