#include "common/anatomy/kuhn_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "common/error.h"

namespace prosector {

TetMesh kuhn_box(const Vec3& size, std::uint32_t nx, std::uint32_t ny, std::uint32_t nz) {
  constexpr std::uint64_t max_nodes = 1u << 24;
  const bool counted = nx > 0 && ny > 0 && nz > 0 && nx < max_nodes && ny < max_nodes && nz < max_nodes;
  const std::uint64_t plane = (nx + 1ull) * (ny + 1ull);
  if (!counted || plane > max_nodes || plane * (nz + 1ull) > max_nodes)
    throw InputError(fmt::format("box mesh: {} x {} x {} cells; allowed: 1 or more each, at most {} nodes",
                                 nx, ny, nz, max_nodes));
  if (!(size.minCoeff() > 0) || !size.allFinite())
    throw InputError(
        fmt::format("box mesh: size {} x {} x {} m must be positive", size[0], size[1], size[2]));

  TetMesh mesh;
  mesh.positions.reserve(plane * (nz + 1ull));
  for (std::uint32_t k = 0; k <= nz; ++k)
    for (std::uint32_t j = 0; j <= ny; ++j)
      for (std::uint32_t i = 0; i <= nx; ++i)
        mesh.positions.emplace_back(size[0] * i / nx, size[1] * j / ny, size[2] * k / nz);

  const std::array<std::uint32_t, 3> stride = {1, nx + 1, (nx + 1) * (ny + 1)};
  mesh.tets.reserve(6ull * nx * ny * nz);
  for (std::uint32_t k = 0; k < nz; ++k)
    for (std::uint32_t j = 0; j < ny; ++j)
      for (std::uint32_t i = 0; i < nx; ++i) {
        const std::uint32_t corner = i * stride[0] + j * stride[1] + k * stride[2];
        std::array<std::size_t, 3> axis = {0, 1, 2};
        bool even = true;  // parities of the permutations in lexicographic order: + − − + + −
        for (int n = 0; n < 6; ++n) {
          std::array<std::uint32_t, 4> tet;
          tet[0] = corner;
          for (std::size_t step = 0; step < 3; ++step) tet[step + 1] = tet[step] + stride[axis[step]];
          if (!even) std::swap(tet[1], tet[2]);
          mesh.tets.push_back(tet);
          if (n % 2 == 0) even = !even;
          std::next_permutation(axis.begin(), axis.end());
        }
      }
  return mesh;
}

}  // namespace prosector
