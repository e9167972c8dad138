#pragma once
// Shapes and poses for the tests of collision, and references that look at everything.

#include <random>
#include <vector>

#include "common/mesh.h"
#include "tests/collision/reference/collision_object.h"

namespace prosector::test {

using Random = std::mt19937_64;

double between(Random& random, double lo, double hi);
/// Each coordinate in [−size, size].
Vec3 random_point(Random& random, double size = 1);
Vec3 random_unit(Random& random);
Quat random_turn(Random& random);
Pose random_pose(Random& random, double size = 1);

/// A unit octahedron's faces halved `levels` times, pushed out to the unit sphere: closed, 8·4^levels
/// triangles.
TriangleMesh ball_mesh(int levels);
/// The ball with smooth dents and bumps, about `size` m across: an organ's kind of shape.
TriangleMesh organ_mesh(int levels, const Vec3& size);
/// A letter U of square section, a unit wide and high: closed, concave.
TriangleMesh horseshoe_mesh();
/// A square of n × n cells in the plane y = 0, `size` m wide: open.
TriangleMesh sheet_mesh(int cells, double size);
std::vector<Vec3> random_cloud(Random& random, int points);
TriangleMesh moved(const TriangleMesh& mesh, const Pose& pose);

struct NamedParts {
  const char* name;
  std::vector<collision::ShapePart> parts;
};
/// Convex, concave, thin, organ-like, and a hand of capsules; each about 0.1 m.
const std::vector<NamedParts>& shape_table();
/// The table's shape at that fidelity; outlines are made once.
CollisionObject from_table(std::size_t shape, Fidelity fidelity, const Pose& pose = {});

CollisionObject rigid(const std::vector<collision::ShapePart>& parts, Fidelity fidelity,
                      const Pose& pose = {});
collision::ShapePart mesh_part(const TriangleMesh& mesh);

/// Depth of two overlapping convex hulls of points: the least overlap over all planes through three points of
/// one of them that has the others on one side, and all products of two edges. Below 0: they are apart.
double brute_force_depth(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace prosector::test
