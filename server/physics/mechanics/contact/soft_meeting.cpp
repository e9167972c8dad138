#include "server/physics/mechanics/contact/soft_meeting.h"

#include <algorithm>

namespace prosector::contact {
namespace {

constexpr double least_facing = 0.1;  // cosine between a solid's inward normal and the contact normal

/// Returns the normal at a vertex; zero if it has no faces.
Vec3 vertex_normal(const collision::TriangleSurface& faces, std::uint32_t vertex) {
  const auto around = faces.topology().around(vertex);
  if (around.empty()) return Vec3::Zero();
  const auto& corners = faces.topology().triangles()[around.front()];
  Vec3 weights = Vec3::Zero();
  weights[std::find(corners.begin(), corners.end(), vertex) - corners.begin()] = 1;
  return faces.normal_at(around.front(), weights);
}

}  // namespace

void find_meetings(const SoftSkin& from, const SoftSkin& to, double margin, std::vector<VertexMeeting>& out) {
  if (to.faces == nullptr || to.skin > 0 || !to.faces->topology().closed()) return;
  const double limit = std::max(margin + from.skin, deepest_meeting * to.cell);
  const Vec3 grow = Vec3::Constant(margin + from.skin);
  from.vertices->in_box(to.faces->box().lo - grow, to.faces->box().hi + grow, [&](std::uint32_t vertex) {
    const Vec3& x = from.vertices->positions()[vertex];
    const auto near = to.faces->nearest(x, limit);
    if (!near) return;
    const Vec3 away = x - near->point, outward = to.faces->normal_at(near->triangle, near->weights);
    const bool inside = away.dot(outward) < 0;
    VertexMeeting found{vertex, {near->triangle, near->weights}};
    found.gap = (inside ? -near->distance : near->distance) - from.skin;
    if (found.gap > margin) return;
    found.normal = near->distance > 0 ? Vec3((inside ? -1 : 1) / near->distance * away) : outward;
    if (found.normal.isZero(0) || !found.normal.allFinite()) return;
    const bool solid = from.skin == 0 && from.faces != nullptr;
    if (solid && found.gap > 0 && vertex_normal(*from.faces, vertex).dot(found.normal) > -least_facing)
      return;
    out.push_back(found);
  });
}

}  // namespace prosector::contact
