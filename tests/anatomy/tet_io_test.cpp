#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "common/anatomy/kuhn_box.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/tet_io.h"
#include "common/error.h"
#include "tests/anatomy/files.h"

namespace prosector {
namespace {

using namespace testing_files;

const std::string gmsh1 = R"($NOD
5
10 0 0 0
20 1 0 0
30 0 1 0
40 0 0 1
50 1 1 1
$ENDNOD
$ELM
3
1 2 0 1 3 10 20 30
2 4 0 1 4 10 20 30 40
3 4 0 1 4 20 30 40 50
$ENDELM
)";
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

const std::string vtk5 = R"(# vtk DataFile Version 5.1
two tetrahedra and a triangle
ASCII
DATASET UNSTRUCTURED_GRID
FIELD FieldData 1
TIME 1 1 double
0.5
POINTS 5 double
0 0 0  1 0 0  0 1 0
0 0 1  1 1 1
METADATA
INFORMATION 0

CELLS 4 11
OFFSETS vtktypeint64
0 3 7 11
CONNECTIVITY vtktypeint64
0 1 2  0 1 2 3  1 2 3 4
CELL_TYPES 3
5
10
10
)";

std::string big(auto value) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof(value));
  if constexpr (std::endian::native == std::endian::little) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}
template <class T>
std::string big_all(const std::vector<double>& values) {
  std::string out;
  for (const double v : values) out += big(static_cast<T>(v));
  return out;
}

/// The same two tetrahedra and triangle in binary, positions as Real; as version 4 or 5 writes cells.
template <class Real>
std::string vtk_binary(bool offsets) {
  std::string out = offsets ? "# vtk DataFile Version 5.1\n" : "# vtk DataFile Version 4.2\n";
  out += "POINTS 9 float\nBINARY\nDATASET UNSTRUCTURED_GRID\n";  // a title that reads like a keyword
  out += "FIELD FieldData 1\nTIME 1 2 double\n" + big_all<double>({0.5, 1}) + "\n";
  out += std::string("POINTS 5 ") + (sizeof(Real) == 4 ? "float\n" : "double\n") +
         big_all<Real>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}) + "\n";
  if (offsets) {
    out += "METADATA\nINFORMATION 0\n\nCELLS 4 11\nOFFSETS vtktypeint64\n" +
           big_all<std::int64_t>({0, 3, 7, 11}) + "\nCONNECTIVITY vtktypeint64\n" +
           big_all<std::int64_t>({0, 1, 2, 0, 1, 2, 3, 1, 2, 3, 4});
  } else {
    out += "CELLS 3 14\n" + big_all<std::int32_t>({3, 0, 1, 2, 4, 0, 1, 2, 3, 4, 1, 2, 3, 4});
  }
  return out + "\nCELL_TYPES 3\n" + big_all<std::int32_t>({5, 10, 10}) + "\nCELL_DATA 3\n\x00\xff";
}

struct Format {
  const char* file;
  std::string text;
};
const std::vector<Format> formats = {{"one.msh", gmsh1},
                                     {"a.msh", gmsh2},
                                     {"b.msh", gmsh4},
                                     {"c.vtk", vtk},
                                     {"d.vtk", vtk5},
                                     {"e.vtk", vtk_binary<float>(false)},
                                     {"f.vtk", vtk_binary<double>(false)},
                                     {"g.vtk", vtk_binary<float>(true)},
                                     {"h.vtk", vtk_binary<double>(true)}};

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

TEST(TetFiles, BinaryVtkKeepsEveryBitOfAMesh) {
  const TetMesh box = kuhn_box({0.1, 0.07, 0.03}, 7, 5, 3);
  std::string text = "# vtk DataFile Version 3.0\nbox\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                     std::to_string(box.positions.size()) + " double\n";
  for (const Vec3& x : box.positions) text += big_all<double>({x[0], x[1], x[2]});
  text += "\nCELLS " + std::to_string(box.tets.size()) + ' ' + std::to_string(5 * box.tets.size()) + '\n';
  for (const auto& t : box.tets) {
    text += big(std::int32_t{4});
    for (const std::uint32_t v : t) text += big(v);
  }
  text += "\nCELL_TYPES " + std::to_string(box.tets.size()) + '\n';
  for (std::size_t i = 0; i < box.tets.size(); ++i) text += big(std::int32_t{10});
  const TetMesh read = parse_vtk(text, "box.vtk");
  EXPECT_EQ(read.positions, box.positions);
  EXPECT_EQ(read.tets, box.tets);
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
                .find("x.msh:16: an element uses node 60"),
            std::string::npos)
      << error_of("x.msh", replaced(gmsh2, "20 30 40 50\n", "20 30 40 60\n"));
  EXPECT_NE(error_of("x.msh", replaced(gmsh2, "2.2 0 8", "3.0 0 8")).find("allowed: 2.2 or 4.1"),
            std::string::npos);
  EXPECT_NE(error_of("x.msh", replaced(gmsh2, "2.2 0 8", "2.2 1 8")).find("binary"), std::string::npos);
  EXPECT_NE(error_of("x.msh", replaced(gmsh2, "\n5\n10", "\n999999999999\n10")).find("exceeds the file size"),
            std::string::npos);
  EXPECT_NE(error_of("x.msh", replaced(gmsh2, "50 1 1 1", "50 1 nan 1")), "accepted");
  EXPECT_NE(error_of("x.msh", gmsh2.substr(0, gmsh2.size() / 2)), "accepted");
  EXPECT_NE(error_of("x.msh", "").find("MeshFormat"), std::string::npos);
  EXPECT_NE(
      error_of("x.msh", replaced(gmsh1, "4 20 30 40 50", "5 20 30 40 50 10")).find("5 nodes; allowed: 4"),
      std::string::npos);
  EXPECT_NE(error_of("x.msh", gmsh1.substr(0, gmsh1.find("$ELM"))).find("no $ELM"), std::string::npos);
  EXPECT_NE(
      error_of("x.vtk", replaced(vtk, "4 1 2 3 4", "4 1 2 3 5")).find("point 5; allowed: points below 5"),
      std::string::npos);
  EXPECT_NE(error_of("x.vtk", replaced(vtk, "ASCII", "BINARY")), "accepted");
  EXPECT_NE(error_of("x.vtk", replaced(vtk, "ASCII", "HEX")).find("allowed: ASCII or BINARY"),
            std::string::npos);
  EXPECT_NE(error_of("x.vtk", replaced(vtk, "3.0", "6.0")).find("version 6; allowed: 1.0 to 5.1"),
            std::string::npos);
  EXPECT_NE(error_of("x.vtk", replaced(vtk, "4 1 2 3 4", "9 1 2 3 4")).find("extends beyond the end"),
            std::string::npos);
  EXPECT_NE(error_of("x.vtk", replaced(vtk5, "0 3 7 11", "0 3 7 12")).find("does not have 4 points"),
            std::string::npos);
  EXPECT_NE(
      error_of("x.vtk", replaced(vtk5, "1 1 double", "9999999 9999999 double")).find("exceeds the file size"),
      std::string::npos);
  for (const bool offsets : {false, true}) {  // cut anywhere before the types are whole
    const std::string whole = vtk_binary<float>(offsets);
    for (std::size_t size = 0; size < whole.find("\nCELL_DATA"); ++size)
      EXPECT_NE(error_of("x.vtk", whole.substr(0, size)), "accepted") << size;
  }
  EXPECT_NE(error_of("x.vtk", replaced(vtk, "5\n10\n10", "5\n5\n5")).find("no tetrahedra"),
            std::string::npos);
  EXPECT_NE(error_of("x.stl", vtk).find("allowed: .msh"), std::string::npos);
}

}  // namespace
}  // namespace prosector
