#pragma once
// Small volumes and folders made up by the tests.

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector::testing_files {

using Bytes = std::vector<std::uint8_t>;

template <class T>
void put(Bytes& out, std::size_t at, T value, bool swap = false) {
  if (out.size() < at + sizeof(T)) out.resize(at + sizeof(T));
  auto* p = reinterpret_cast<std::uint8_t*>(&value);
  for (std::size_t k = 0; k < sizeof(T); ++k) out[at + k] = p[swap ? sizeof(T) - 1 - k : k];
}

/// An INRIMAGE of uint8 voxels.
inline Bytes inrimage(int nx, int ny, int nz, const Vec3& mm, const std::vector<std::uint8_t>& voxels) {
  std::string head = "#INRIMAGE-4#{\nXDIM=" + std::to_string(nx) + "\nYDIM=" + std::to_string(ny) +
                     "\nZDIM=" + std::to_string(nz) +
                     "\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\nVX=" + std::to_string(mm[0]) +
                     "\nVY=" + std::to_string(mm[1]) + "\nVZ=" + std::to_string(mm[2]) + "\n";
  head.resize(252, '\n');
  head += "##}\n";
  Bytes out(head.begin(), head.end());
  out.insert(out.end(), voxels.begin(), voxels.end());
  return out;
}

/// A NIfTI-1 header with room for the voxels after byte 352.
inline Bytes nifti_header(int nx, int ny, int nz, std::int16_t datatype, bool swap = false) {
  Bytes out(352);
  put<std::int32_t>(out, 0, 348, swap);
  const std::int16_t dims[] = {3, static_cast<std::int16_t>(nx), static_cast<std::int16_t>(ny),
                               static_cast<std::int16_t>(nz)};
  for (std::size_t k = 0; k < 4; ++k) put(out, 40 + 2 * k, dims[k], swap);
  put(out, 70, datatype, swap);
  for (std::size_t k = 0; k < 4; ++k) put(out, 76 + 4 * k, 1.f + 0.5f * static_cast<float>(k), swap);
  put(out, 108, 352.f, swap);
  out[123] = 2;  // millimetres
  std::memcpy(out.data() + 344, "n+1", 4);
  return out;
}

/// Voxels on each side of what two_balls_voxels() gives.
inline constexpr int two_balls_side = 40;
/// Two balls: label 7 (radius 12 voxels) with a speck of the same label, and label 9 (radius 5).
inline std::vector<std::uint8_t> two_balls_voxels() {
  constexpr int n = two_balls_side;
  std::vector<std::uint8_t> v(n * n * n);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        auto& voxel = v[static_cast<std::size_t>(i + n * (j + n * k))];
        if ((Vec3(i, j, k) - Vec3(15, 18, 20)).norm() < 12) voxel = 7;
        if ((Vec3(i, j, k) - Vec3(33, 30, 20)).norm() < 5) voxel = 9;
      }
  v[static_cast<std::size_t>(2 + n * (2 + n * 2))] = 7;
  return v;
}

inline Bytes two_balls() {
  constexpr int n = two_balls_side;
  return inrimage(n, n, n, {2, 2, 2}, two_balls_voxels());
}

inline void write(const std::filesystem::path& file, const void* data, std::size_t size) {
  std::ofstream(file, std::ios::binary)
      .write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
}
inline void write(const std::filesystem::path& file, const Bytes& bytes) {
  write(file, bytes.data(), bytes.size());
}
inline void write(const std::filesystem::path& file, const std::string& text) {
  write(file, text.data(), text.size());
}

/// A folder of its own, gone with the object.
struct TempDir {
  std::filesystem::path path;
  TempDir() {
    std::string pattern = (std::filesystem::temp_directory_path() / "prosector_anatomy_XXXXXX").string();
    path = mkdtemp(pattern.data());
  }
  ~TempDir() { std::filesystem::remove_all(path); }
  TempDir(const TempDir&) = delete;
  TempDir& operator=(const TempDir&) = delete;
};

}  // namespace prosector::testing_files
