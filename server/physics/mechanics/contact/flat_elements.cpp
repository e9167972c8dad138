#include "server/physics/mechanics/contact/flat_elements.h"

#include <Eigen/LU>

#include <algorithm>

#include "common/assert.h"

namespace prosector::contact {
namespace {

// Height that vertices keep over their opposite face, as a fraction of the rest height.
constexpr double least_height = 0.1;
constexpr double soon = 0.5;  // times the rest height: lower elements always get a contact
// Factor on the speed at which the height decreases, which may grow within the tick.
constexpr double hurry = 2;

using Tet = std::array<Vec3, 4>;

/// Returns the index of the vertex opposite to the largest face.
std::size_t apex_of(const Tet& at) {
  std::size_t apex = 0;
  double largest = -1;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 &a = at[(k + 1) % 4], &b = at[(k + 2) % 4], &c = at[(k + 3) % 4];
    const double area = (b - a).cross(c - a).squaredNorm();
    if (area <= largest) continue;
    largest = area;
    apex = k;
  }
  return apex;
}

/// Returns the normal of the face opposite to the apex, with length twice its area. `sign` makes it point to
/// the apex if the element is not inverted.
Vec3 face_normal(const Tet& at, std::size_t apex, double sign) {
  const Vec3 &a = at[(apex + 1) % 4], &b = at[(apex + 2) % 4], &c = at[(apex + 3) % 4];
  return sign * (b - a).cross(c - a);
}

Vec3 read(const VecX& values, std::uint32_t node) {
  return values.segment<3>(3 * static_cast<Eigen::Index>(node));
}

double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

}  // namespace

bool mark_inverted(const TetMesh& mesh, const VecX& x, std::vector<char>& marks) {
  marks.clear();
  for (const auto& t : mesh.tets) {
    const auto& X = mesh.positions;
    const double now = six_volumes(read(x, t[0]), read(x, t[1]), read(x, t[2]), read(x, t[3]));
    if (now * six_volumes(X[t[0]], X[t[1]], X[t[2]], X[t[3]]) > 0) continue;
    marks.resize(static_cast<std::size_t>(x.size() / 3), 0);
    for (const std::uint32_t node : t) marks[node] = 1;
  }
  return !marks.empty();
}

void find_flat_elements(const TetMesh& mesh, const VecX& x, const VecX& v, const FlatElementSearch& search,
                        std::vector<Contact>& out) {
  PROSECTOR_ASSERT(x.size() == v.size());
  for (const auto& t : mesh.tets) {
    Tet at, rest;
    for (std::size_t k = 0; k < 4; ++k) {
      at[k] = read(x, t[k]);
      rest[k] = mesh.positions[t[k]];
    }
    const std::size_t apex = apex_of(at);
    // Six times the volume.
    const double volume = face_normal(rest, apex, 1).dot(rest[apex] - rest[(apex + 1) % 4]);
    const double sign = volume < 0 ? -1 : 1;
    const Vec3 rest_face = face_normal(rest, apex, 1), face = face_normal(at, apex, sign);
    const double area = face.norm(), rest_area = rest_face.norm();
    if (!(area > 0) || volume == 0) continue;
    const Vec3 n = face / area;
    const double rest_height = std::abs(volume) / rest_area, least = least_height * rest_height;
    const std::array<std::uint32_t, 3> corner = {t[(apex + 1) % 4], t[(apex + 2) % 4], t[(apex + 3) % 4]};
    const double height = n.dot(at[apex] - at[(apex + 1) % 4]);
    // Barycentric weights of the apex' projection on the face, so that the contact forces have no moment.
    const Vec3 foot = at[apex] - height * n;
    Vec3 weights;
    for (std::size_t k = 0; k < 3; ++k)
      weights[static_cast<Eigen::Index>(k)] =
          n.dot((at[(apex + 1 + (k + 1) % 3) % 4] - foot).cross(at[(apex + 1 + (k + 2) % 3) % 4] - foot)) /
          (sign * area);
    Vec3 nearing = -read(v, t[apex]);
    for (std::size_t k = 0; k < 3; ++k) nearing += weights[static_cast<Eigen::Index>(k)] * read(v, corner[k]);
    if (height > soon * rest_height && height - least > hurry * search.h * std::max(0.0, n.dot(nearing)))
      continue;
    Contact& c = out.emplace_back();
    c.a.kind = c.b.kind = ContactSide::Kind::soft;
    c.a.body = c.b.body = search.body;
    c.a.nodes = 1;
    c.a.node[0] = t[apex];
    c.a.weight[0] = 1;
    c.b.nodes = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      c.b.node[k] = corner[k];
      c.b.weight[k] = weights[static_cast<Eigen::Index>(k)];
    }
    c.point = at[apex];
    c.normal = n;
    c.gap = std::max(height - least, -2 * least);
    c.stiffness = search.stiffness * rest_area / 6 / rest_height;
  }
}

}  // namespace prosector::contact
