#include "tests/play/judge.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/collision/surface/triangle_surface.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/unfold.h"

namespace prosector::test {
namespace {

/// Whether it has a volume; not of what is hidden, which stands still until somebody shows it again.
bool is_solid(const Simulation& simulation, BodyId body) {
  return simulation.kind(body) == BodyKind::soft && !simulation.soft(body).linear_tets().tets.empty() &&
         !simulation.surface(body).triangles.empty() && !simulation.part(body).out_of_touch();
}

bool willing(const SoftDesc& a, const SoftDesc& b) {
  return a.contact.touches.empty() ||
         std::ranges::find(a.contact.touches, b.contact.group) != a.contact.touches.end();
}

/// Whether the bodies' surfaces keep each other out.
bool may_touch(const Simulation& simulation, BodyId a, BodyId b) {
  const SoftDesc &first = simulation.soft(a).desc(), &second = simulation.soft(b).desc();
  return first.contact.collision == Fidelity::mesh && second.contact.collision == Fidelity::mesh &&
         willing(first, second) && willing(second, first);
}

std::vector<Vec3> surface_positions(const Simulation& simulation, BodyId body) {
  const Anatomy& anatomy = simulation.soft(body).anatomy();
  std::vector<Vec3> out(anatomy.surface.positions.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = anatomy.embedding.apply(i, simulation.soft_state(body).motion.x.data());
  return out;
}

collision::Aabb box_of(const std::vector<Vec3>& points) {
  collision::Aabb box{points.front(), points.front()};
  for (const Vec3& x : points) {
    box.lo = box.lo.cwiseMin(x);
    box.hi = box.hi.cwiseMax(x);
  }
  return box;
}

double deepest(std::span<const Vec3> points, const collision::Aabb& box,
               const collision::TriangleSurface& in) {
  double most = 0;
  for (const Vec3& x : points) {
    if ((x.array() < box.lo.array()).any() || (x.array() > box.hi.array()).any()) continue;
    if (const auto near = in.nearest(x);
        near->distance > most && in.is_inside(x, *near) && in.winding_number(x) > 0.5)
      most = near->distance;
  }
  return most;
}

/// Calls visit(a, b, depth) for every pair of solids that may touch.
template <class Visit>
void for_each_overlap(const Simulation& simulation, const Visit& visit) {
  std::vector<BodyId> bodies;
  std::vector<collision::Aabb> boxes;
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    if (!is_solid(simulation, b)) continue;
    bodies.push_back(b);
    boxes.push_back(box_of(surface_positions(simulation, b)));
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = i + 1; j < bodies.size(); ++j)
      if (boxes[i].overlaps(boxes[j]) && may_touch(simulation, bodies[i], bodies[j]))
        visit(bodies[i], bodies[j], overlap(simulation, bodies[i], bodies[j]));
}

}  // namespace

double volume_ratio(const Simulation& simulation, BodyId body) {
  return soft::volume_share(simulation.soft(body).linear_tets(), simulation.soft_state(body).motion.x);
}

double overlap(const Simulation& simulation, BodyId a, BodyId b) {
  const std::vector<Vec3> first = surface_positions(simulation, a), second = surface_positions(simulation, b);
  const auto surface = [&](BodyId body, const std::vector<Vec3>& at) {
    TriangleMesh mesh = simulation.soft(body).anatomy().surface;
    mesh.positions = at;
    return collision::TriangleSurface(mesh);
  };
  const collision::TriangleSurface in_first = surface(a, first), in_second = surface(b, second);
  return std::max(deepest(first, box_of(second), in_second), deepest(second, box_of(first), in_first));
}

Judge::Judge(const Simulation& simulation) {
  for_each_overlap(simulation, [&](BodyId a, BodyId b, double depth) { at_start_[{a, b}] = depth; });
}

Finding Judge::look(const Simulation& simulation, const Bounds& bounds) const {
  Finding out;
  const auto blame = [&](std::string where) {
    if (out.where.empty()) out.where = std::move(where);
  };
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    if (!is_solid(simulation, b)) continue;
    const double ratio = volume_ratio(simulation, b);
    out.least_volume = std::min(out.least_volume, ratio);
    out.most_volume = std::max(out.most_volume, ratio);
    out.inverted = std::max(out.inverted, soft::inverted_share(simulation.soft(b).linear_tets(),
                                                               simulation.soft_state(b).motion.x));
    if (!(ratio >= bounds.least_volume && ratio <= bounds.most_volume))
      blame(fmt::format("{} has {:.3f} of its volume", simulation.name(b), ratio));
  }
  for_each_overlap(simulation, [&](BodyId a, BodyId b, double depth) {
    const auto known = at_start_.find({a, b});
    const double own = known == at_start_.end() ? 0 : known->second;
    out.overlap = std::max(out.overlap, depth - own);
    if (depth - own > bounds.most_overlap)
      blame(fmt::format("{} and {} overlap by {:.2f} mm ({:.2f} mm as the scene has them)",
                        simulation.name(a), simulation.name(b), 1e3 * depth, 1e3 * own));
  });
  return out;
}

}  // namespace prosector::test
