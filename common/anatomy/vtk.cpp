#include "common/anatomy/tet_io.h"
#include "common/anatomy/token_reader.h"

namespace prosector {

TetMesh parse_vtk(std::string_view text, const std::string& name) {
  constexpr int vtk_tetra = 10;
  TokenReader in(text, name);
  in.expect("#");
  in.expect("vtk");
  in.rest();
  if (!in.skip_to("ASCII")) in.fail("no ASCII line; allowed: legacy VTK, ASCII");
  in.expect("DATASET");
  in.expect("UNSTRUCTURED_GRID");

  TetMesh mesh;
  std::vector<std::vector<std::uint64_t>> cells;
  for (std::string_view w = in.word(); !w.empty(); w = in.word()) {
    if (w == "POINTS") {
      mesh.positions.resize(in.count("number of points", 6));
      in.word();  // float or double
      for (Vec3& x : mesh.positions)
        for (int k = 0; k < 3; ++k) x[k] = in.number<double>("a coordinate");
    } else if (w == "CELLS") {
      cells.resize(in.count("number of cells", 4));
      in.number<std::uint64_t>("size of the cell list");
      for (auto& cell : cells) {
        cell.resize(in.count("number of a cell's points"));
        for (auto& v : cell) v = in.number<std::uint64_t>("a point number");
      }
    } else if (w == "CELL_TYPES") {
      const auto types = in.count("number of cell types");
      if (types != cells.size()) in.fail(fmt::format("{} cell types for {} cells", types, cells.size()));
      for (const auto& cell : cells) {
        if (in.number<int>("a cell type") != vtk_tetra) continue;
        if (cell.size() != 4) in.fail(fmt::format("a tetrahedron with {} points", cell.size()));
        std::array<std::uint32_t, 4> tet;
        for (std::size_t k = 0; k < 4; ++k) {
          if (cell[k] >= mesh.positions.size())
            in.fail(fmt::format("cell uses point {}; allowed: below {}", cell[k], mesh.positions.size()));
          tet[k] = static_cast<std::uint32_t>(cell[k]);
        }
        mesh.tets.push_back(tet);
      }
    } else if (w == "CELL_DATA" || w == "POINT_DATA") {
      break;
    }
  }
  return mesh;
}

}  // namespace prosector
