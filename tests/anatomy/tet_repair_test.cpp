// Meshes of other cells, doubled, parted or tangled ones: by their volumes and by what is said.

#include "common/anatomy/tet_repair.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <map>

#include "common/anatomy/kuhn_box.h"
#include "common/anatomy/mesh_cells.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/sources.h"
#include "common/anatomy/tet_io.h"
#include "common/error.h"
#include "tests/anatomy/files.h"
#include "tests/anatomy/reported_lines.h"

namespace prosector {
namespace {

using namespace testing_files;

struct Element {
  int type;
  std::vector<std::uint32_t> nodes;
};

std::string gmsh_text(const std::vector<Vec3>& nodes, const std::vector<Element>& elements) {
  std::string out = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    out += fmt::format("{} {} {} {}\n", i + 1, nodes[i][0], nodes[i][1], nodes[i][2]);
  out += fmt::format("$EndNodes\n$Elements\n{}\n", elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    out += fmt::format("{} {} 2 1 1", i + 1, elements[i].type);
    for (const std::uint32_t n : elements[i].nodes) out += fmt::format(" {}", n + 1);
    out += "\n";
  }
  return out + "$EndElements\n";
}

std::string vtk_text(const std::vector<Vec3>& nodes, const std::vector<Element>& elements) {
  std::string out = fmt::format(
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n", nodes.size());
  for (const Vec3& x : nodes) out += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  std::size_t size = 0;
  for (const Element& e : elements) size += 1 + e.nodes.size();
  out += fmt::format("CELLS {} {}\n", elements.size(), size);
  for (const Element& e : elements) {
    out += fmt::format("{}", e.nodes.size());
    for (const std::uint32_t n : e.nodes) out += fmt::format(" {}", n);
    out += "\n";
  }
  out += fmt::format("CELL_TYPES {}\n", elements.size());
  for (const Element& e : elements) out += fmt::format("{}\n", e.type);
  return out;
}

struct MadeOfCells {
  Anatomy anatomy;
  double volume = 0;
  std::string refusal;
  Lines said;
};

MadeOfCells made_from(const std::string& name, const std::string& text, double accepted = 0) {
  const TempDir dir;
  write(dir.path / name, text);
  SoftDesc desc;
  desc.name = "organ";
  desc.geometry.mesh = name;
  desc.geometry.max_volume_error.value = accepted;
  MadeOfCells out;
  try {
    out.anatomy = make_anatomy(desc, {dir.path, {}, {}}, out.said.progress());
    out.volume = tet_quality(out.anatomy.tets).volume;
  } catch (const InputError& error) {
    out.refusal = error.what();
  }
  return out;
}

/// Nodes of a row of cubes along x: 4 (i) to 4 (i) + 3 at x = i, in a ring.
std::vector<Vec3> ring_nodes(int cubes) {
  std::vector<Vec3> out;
  for (int i = 0; i <= cubes; ++i)
    for (const auto& [y, z] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
      out.emplace_back(0.1 * i, 0.1 * y, 0.1 * z);
  return out;
}

const std::vector<Element> cube_tets = {{4, {0, 1, 2, 4}}, {4, {1, 5, 4, 2}}, {4, {4, 5, 6, 2}},
                                        {4, {0, 2, 3, 4}}, {4, {3, 2, 7, 4}}, {4, {2, 6, 7, 4}}};

std::vector<Element> as_vtk(std::vector<Element> elements) {
  const std::map<int, int> numbers = {{2, 5}, {4, 10}, {5, 12}, {6, 13}, {7, 14}, {11, 24}};
  for (Element& e : elements) e.type = numbers.at(e.type);
  return elements;
}

TEST(TetRepair, HexahedraBesideTetrahedraAreSplit) {
  std::vector<Element> elements = cube_tets;
  elements.push_back({5, {4, 5, 6, 7, 8, 9, 10, 11}});
  for (const bool gmsh : {true, false}) {
    const MadeOfCells made = gmsh ? made_from("m.msh", gmsh_text(ring_nodes(2), elements))
                                  : made_from("m.vtk", vtk_text(ring_nodes(2), as_vtk(elements)));
    EXPECT_NEAR(made.volume, 2e-3, 1e-12) << made.refusal;
    EXPECT_TRUE(made.said.say("organ: repaired: 1 hexahedra are split into tetrahedra"));
    EXPECT_EQ(tet_quality(made.anatomy.tets).components, 1u);
    EXPECT_EQ(tet_quality(made.anatomy.tets).non_manifold_edges, 0u);
    EXPECT_EQ(made.anatomy.surface.triangles.size(), 20u);
  }
}

TEST(TetRepair, CellsThatDontFitAreRefused) {
  std::vector<Element> elements = cube_tets;
  elements.push_back({5, {4, 5, 6, 7, 8, 9, 10, 11}});
  // The tetrahedra split the common face 4 5 6 7 along 4-6 as the hexahedron does; turned by a node they
  // don't.
  for (std::size_t t = 0; t < cube_tets.size(); ++t)
    for (std::uint32_t& n : elements[t].nodes) n = n / 4 * 4 + (n + 1) % 4;
  const MadeOfCells made = made_from("m.msh", gmsh_text(ring_nodes(2), elements));
  EXPECT_NE(made.refusal.find("at 1 quadrilateral faces the cells on both sides do not match"),
            std::string::npos)
      << made.refusal;
  EXPECT_NE(made.refusal.find("Save the mesh with tetrahedra only"), std::string::npos);
}

TEST(TetRepair, RowsOfEveryCellKeepTheirVolume) {
  for (int first = 0; first < 8; ++first) {  // each corner is the lowest once
    SCOPED_TRACE(first);
    std::vector<Vec3> nodes = ring_nodes(3);
    std::vector<std::uint32_t> at(nodes.size());
    for (std::uint32_t n = 0; n < at.size(); ++n)
      at[n] = (n * 7 + static_cast<std::uint32_t>(first) * 5) % 16;
    std::vector<Vec3> shuffled(nodes.size());
    for (std::uint32_t n = 0; n < at.size(); ++n) shuffled[at[n]] = nodes[n];
    std::vector<Element> elements = {{5, {0, 1, 2, 3, 4, 5, 6, 7}},
                                     {6, {4, 5, 8, 7, 6, 11}},
                                     {6, {5, 9, 8, 6, 10, 11}},
                                     {5, {8, 9, 10, 11, 12, 13, 14, 15}}};
    for (Element& e : elements)
      for (std::uint32_t& n : e.nodes) n = at[n];
    const MadeOfCells made = made_from("m.vtk", vtk_text(shuffled, as_vtk(elements)));
    EXPECT_NEAR(made.volume, 3e-3, 1e-12) << made.refusal;
    EXPECT_EQ(tet_quality(made.anatomy.tets).non_manifold_edges, 0u);
    EXPECT_TRUE(made.said.say("2 prisms are split"));
  }
  const MadeOfCells pyramid = made_from("p.msh", gmsh_text(ring_nodes(1), {{7, {0, 1, 2, 3, 4}}}));
  EXPECT_NEAR(pyramid.volume, 1e-3 / 3, 1e-12);
}

TEST(TetRepair, QuadraticCellsAreTakenByTheirCorners) {
  std::vector<Vec3> nodes = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}})
    nodes.push_back(0.5 * (nodes[static_cast<std::size_t>(a)] + nodes[static_cast<std::size_t>(b)]));
  const std::vector<Element> elements = {{2, {0, 1, 2}}, {11, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  for (const bool gmsh : {true, false}) {
    const MadeOfCells made = gmsh ? made_from("t.MSH", gmsh_text(nodes, elements))
                                  : made_from("t.Vtk", vtk_text(nodes, as_vtk(elements)));
    EXPECT_NEAR(made.volume, 1e-3 / 6, 1e-12) << made.refusal;
    EXPECT_EQ(made.anatomy.tets.positions.size(), 4u);
    EXPECT_TRUE(made.said.say(
        "organ: repaired: 1 quadratic tetrahedra are replaced by linear elements with straight edges"));
    EXPECT_TRUE(made.said.say("organ: not used: 1 triangles"));
  }
}

TEST(TetRepair, UnknownElementsAreRefused) {
  const MadeOfCells made =
      made_from("u.vtk", vtk_text(ring_nodes(1), {{10, {0, 1, 2, 4}}, {42, {0, 1, 2, 4}}}));
  EXPECT_NE(made.refusal.find("elements of type 42; allowed: tetrahedra, hexahedra"), std::string::npos)
      << made.refusal;
}

TEST(TetRepair, ElementsThatAreThereTwiceAreDropped) {
  std::vector<Element> twice = cube_tets;
  twice.insert(twice.end(), cube_tets.begin(), cube_tets.end());
  const MadeOfCells made = made_from("m.msh", gmsh_text(ring_nodes(1), twice));
  EXPECT_NEAR(made.volume, 1e-3, 1e-12) << made.refusal;
  EXPECT_EQ(made.anatomy.surface.triangles.size(), 12u);
  EXPECT_TRUE(made.said.say("organ: repaired: 6 duplicate tetrahedra are dropped"));
  // Others on the same faces aren't the same elements.
  std::vector<Vec3> nodes = ring_nodes(1);
  nodes.push_back({0.02, 0.09, 0.05});
  twice.resize(6);
  twice.push_back({4, {0, 1, 2, 8}});
  twice.push_back({4, {0, 2, 4, 8}});
  EXPECT_NE(made_from("m.msh", gmsh_text(nodes, twice)).refusal.find("belong to more than two tetrahedra"),
            std::string::npos);
}

TEST(TetRepair, NodesThatAreNotMergedAre) {
  const std::vector<Vec3> nodes = ring_nodes(1);
  std::vector<Vec3> apart;
  std::vector<Element> elements = cube_tets;
  for (Element& e : elements)
    for (std::uint32_t& n : e.nodes) {
      apart.push_back(nodes[n] + Vec3(0, 0, apart.size() % 2 == 0 ? 1e-9 : 0));
      n = static_cast<std::uint32_t>(apart.size() - 1);
    }
  const MadeOfCells made = made_from("m.msh", gmsh_text(apart, elements));
  EXPECT_NEAR(made.volume, 1e-3, 1e-9) << made.refusal;
  EXPECT_EQ(made.anatomy.tets.positions.size(), 8u);
  EXPECT_TRUE(made.said.say("which joins 6 pieces to 1"));
}

TEST(TetRepair, TangledElementsAreFound) {
  TetMesh box = kuhn_box({0.1, 0.1, 0.1}, 4, 4, 4);
  EXPECT_EQ(find_tet_overlap(box).tets, 0u);
  EXPECT_NEAR(find_tet_overlap(box).enclosed, 1e-3, 1e-12);
  constexpr std::size_t inner = 2 + 5 * (2 + 5 * 2);  // the middle node
  box.positions[inner] += Vec3(0.03, 0.004, 0.002);   // through the faces opposite
  const auto text = [&] {
    std::vector<Element> elements;
    for (const auto& t : box.tets) elements.push_back({4, {t.begin(), t.end()}});
    return gmsh_text(box.positions, elements);
  };
  const MadeOfCells made = made_from("m.msh", text());
  EXPECT_EQ(made.refusal, "");
  EXPECT_TRUE(made.said.say("tetrahedra overlap: they are on the wrong side of a neighbour"));
  EXPECT_NEAR(find_tet_overlap(made.anatomy.tets).enclosed, 1e-3, 1e-9);
  // Far more: what they fill is no longer what they enclose.
  box.positions[inner] += Vec3(0.3, 0, 0);
  const MadeOfCells far = made_from("m.msh", text());
  EXPECT_NE(far.refusal.find("more than the 1000 ml that its file encloses"), std::string::npos)
      << far.refusal;
  EXPECT_EQ(made_from("m.msh", text(), 1000).refusal, "");
}

}  // namespace
}  // namespace prosector
