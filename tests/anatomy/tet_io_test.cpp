#include <gtest/gtest.h>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/tet_io.h"
#include "common/error.h"
#include "tests/anatomy/files.h"

namespace prosector {
namespace {

using namespace testing_files;

const std::string gmsh2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
5
10 0 0 0
20 1 0 0
30 0 1 0
40 0 0 1
50 1 1 1
$EndNodes
$Elements
3
1 2 2 0 1 10 20 30
2 4 2 0 1 10 20 30 40
3 4 2 0 1 20 30 40 50
$EndElements
)";
const std::string gmsh4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Nodes
2 5 10 50
0 1 0 2
10
20
0 0 0
1 0 0
3 1 0 3
30
40
50
0 1 0
0 0 1
1 1 1
$EndNodes
$Elements
2 3 1 3
2 1 2 1
1 10 20 30
3 1 4 2
2 10 20 30 40
3 20 30 40 50
$EndElements
)";
const std::string vtk = R"(# vtk DataFile Version 3.0
two tetrahedra and a triangle
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 5 float
0 0 0  1 0 0  0 1 0
0 0 1  1 1 1
CELLS 3 14
3 0 1 2
4 0 1 2 3
4 1 2 3 4
CELL_TYPES 3
5
10
10
)";

struct Format {
  const char* file;
  const std::string& text;
};
const std::vector<Format> formats = {{"a.msh", gmsh2}, {"b.msh", gmsh4}, {"c.vtk", vtk}};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.rfind(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST(TetFiles, EveryFormatGivesTheSameMesh) {
  const TempDir dir;
  for (const Format& f : formats) {
    SCOPED_TRACE(f.file);
    write(dir.path / f.file, f.text);
    const TetMesh mesh = load_tets(dir.path / f.file, 0.1);
    ASSERT_EQ(mesh.tets.size(), 2u);
    EXPECT_EQ(mesh.positions.size(), 5u);
    EXPECT_NEAR(tet_quality(mesh).volume, 1e-3 * (1.0 / 6 + 1.0 / 3), 1e-12);
    EXPECT_EQ(boundary_faces(mesh).size(), 6u);
  }
}

TEST(TetFiles, InvertedAreTurnedAndFlatDropped) {
  const TempDir dir;
  write(dir.path / "inverted.vtk", replaced(vtk, "4 0 1 2 3", "4 1 0 2 3"));
  const TetMesh mesh = load_tets(dir.path / "inverted.vtk", 1);
  EXPECT_EQ(mesh.tets.size(), 2u);
  for (const auto& t : mesh.tets)
    EXPECT_GT(
        tet_volume(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], mesh.positions[t[3]]),
        0);
  write(dir.path / "flat.vtk", replaced(vtk, "4 0 1 2 3", "4 0 1 2 2"));
  EXPECT_EQ(load_tets(dir.path / "flat.vtk", 1).tets.size(), 1u);
}

TEST(TetFiles, BadFilesAreRefusedWithTheirLine) {
  const TempDir dir;
  const auto error_of = [&](const std::string& name, const std::string& text) {
    write(dir.path / name, text);
    try {
      load_tets(dir.path / name, 1);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(error_of("x.msh", replaced(gmsh2, "20 30 40 50\n", "20 30 40 60\n"))
                .find("x.msh:16: element uses node 60"),
            std::string::npos)
      << error_of("x.msh", replaced(gmsh2, "20 30 40 50\n", "20 30 40 60\n"));
  EXPECT_NE(error_of("x.msh", replaced(gmsh2, "2.2 0 8", "3.0 0 8")).find("allowed: 2.2 or 4.1"),
            std::string::npos);
  EXPECT_NE(error_of("x.msh", replaced(gmsh2, "2.2 0 8", "2.2 1 8")).find("binary"), std::string::npos);
  EXPECT_NE(
      error_of("x.msh", replaced(gmsh2, "\n5\n10", "\n999999999999\n10")).find("more than the file can hold"),
      std::string::npos);
  EXPECT_NE(error_of("x.msh", replaced(gmsh2, "50 1 1 1", "50 1 nan 1")), "accepted");
  EXPECT_NE(error_of("x.msh", gmsh2.substr(0, gmsh2.size() / 2)), "accepted");
  EXPECT_NE(error_of("x.msh", "").find("MeshFormat"), std::string::npos);
  EXPECT_NE(error_of("x.vtk", replaced(vtk, "4 1 2 3 4", "4 1 2 3 5")).find("point 5; allowed: below 5"),
            std::string::npos);
  EXPECT_NE(error_of("x.vtk", replaced(vtk, "ASCII", "BINARY")).find("ASCII"), std::string::npos);
  EXPECT_NE(error_of("x.vtk", replaced(vtk, "5\n10\n10", "5\n5\n5")).find("no tetrahedra"),
            std::string::npos);
  EXPECT_NE(error_of("x.stl", vtk).find("allowed: .msh"), std::string::npos);
}

}  // namespace
}  // namespace prosector
