// Meshes that are graded at the rims of what is attached.

#include "server/physics/stations/compile/grading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/anatomy/embedding.h"
#include "common/anatomy/kuhn_box.h"
#include "common/anatomy/mesh_quality.h"
#include "common/error.h"

namespace prosector {
namespace {

const Vec3 size(0.2, 0.1, 0.2);
constexpr double cell = 0.05;

/// Tissue that is held at its foot, y = 0.
SoftDesc on_foot() {
  constexpr double flat = 1e4;
  SoftDesc desc;
  desc.name = "block";
  desc.geometry.grade = Grading::rims;
  desc.attach.push_back({Vec3(size.x() / 2, -flat, size.z() / 2), flat + 1e-4, 1e13});
  return desc;
}

Anatomy block() {
  TriangleMesh surface;
  const TetMesh fine = kuhn_box(size, 8, 4, 8);
  surface.positions = fine.positions;
  surface.triangles = boundary_faces(fine);
  return embed(kuhn_box(size, 4, 2, 4), surface).anatomy;
}

double from_rim(const Vec3& x) {
  const double side = std::min({x.x(), size.x() - x.x(), x.z(), size.z() - x.z()});
  return std::hypot(x.y(), side);
}

double longest_edge(const TetMesh& mesh, const std::array<std::uint32_t, 4>& tet) {
  double out = 0;
  for (const std::uint32_t a : tet)
    for (const std::uint32_t b : tet) out = std::max(out, (mesh.positions[a] - mesh.positions[b]).norm());
  return out;
}

TEST(Grading, MakesElementsSmallAtTheRimOnly) {
  const Anatomy whole = block(), graded = graded_at_rims(on_foot(), whole);
  EXPECT_GT(graded.tets.tets.size(), 1.3 * static_cast<double>(whole.tets.tets.size()));
  EXPECT_LT(graded.tets.tets.size(), 3 * whole.tets.tets.size());
  int far = 0, far_and_small = 0;
  for (const auto& tet : graded.tets.tets) {
    double nearest = 1;
    for (const std::uint32_t node : tet) nearest = std::min(nearest, from_rim(graded.tets.positions[node]));
    if (nearest < 1e-9) {
      EXPECT_LE(longest_edge(graded.tets, tet), 1.25 * cell);
    }
    if (nearest < 0.9 * cell) continue;
    ++far;
    far_and_small += longest_edge(graded.tets, tet) < 1.4 * cell;
  }
  EXPECT_GT(far, 20);
  EXPECT_LT(far_and_small, 0.1 * far) << "none but what conforms";
}

TEST(Grading, KeepsShapeVolumeAndSurface) {
  const Anatomy whole = block();
  Anatomy graded = graded_at_rims(on_foot(), whole);
  const TetQuality before = tet_quality(whole.tets), after = tet_quality(graded.tets);
  EXPECT_NEAR(after.volume, before.volume, 1e-12);
  EXPECT_EQ(after.components, 1u);
  EXPECT_EQ(after.non_manifold_edges, 0u);
  EXPECT_GE(after.min_dihedral_deg, 0.6 * before.min_dihedral_deg);
  EXPECT_EQ(graded.surface.triangles, whole.surface.triangles);
  apply_embedding(graded);
  for (std::size_t i = 0; i < whole.surface.positions.size(); ++i)
    EXPECT_LT((graded.surface.positions[i] - whole.surface.positions[i]).norm(), 1e-12);
}

/// What hangs free, or is held all over, has no rim.
TEST(Grading, LeavesWhatHasNoRim) {
  SoftDesc free = on_foot(), held = on_foot();
  free.attach.clear();
  held.attach[0].center.setZero();
  const Anatomy whole = block();
  for (const SoftDesc& desc : {free, held}) EXPECT_EQ(graded_at_rims(desc, whole).tets.tets, whole.tets.tets);
}

TEST(Grading, RefusesWhatItCantDivide) {
  const auto message = [](const Anatomy& anatomy) -> std::string {
    try {
      graded_at_rims(on_foot(), anatomy);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  Anatomy rope = block();
  rope.tets.tets.clear();
  rope.segments = {{0, 1}};
  EXPECT_NE(message(rope).find("[[soft]] \"block\": grade is \"rims\", which is allowed only for solids"),
            std::string::npos)
      << message(rope);
  Anatomy flat = block();
  flat.tets.positions[flat.tets.tets[0][0]] = flat.tets.positions[flat.tets.tets[0][1]];
  EXPECT_NE(message(flat).find("but its mesh does not allow it: "), std::string::npos) << message(flat);
}

}  // namespace
}  // namespace prosector
