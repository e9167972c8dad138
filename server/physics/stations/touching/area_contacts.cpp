#include "server/physics/stations/touching/area_contacts.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/contact/area_rule.h"
#include "server/physics/mechanics/contact/vertex_gap.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"
#include "server/physics/stations/touching/surface_point.h"

namespace prosector {
namespace {

// Under a round body, a surface yields more than its elements resolve, because they spread the load over a
// cell. So the pressure models the dent within a cell: depth over cell size, times E/(1 − ν²), times this
// factor. Quadratic elements resolve more of the dent the less compressible they are, so their factor is
// divided by 1 − ν. Measured, see docs/understand/contact.md.
constexpr double dent_of_linear = 2.1, dent_of_quadratic = 5.8;

// Contact stiffness with which the factors were measured.
const double usual_stiffness = SceneDesc().contact_stiffness;

constexpr double least_round = 0.1;  // 1/m: smaller curvature counts as flat

// Deeper than this fraction of its radius of curvature, a round body no longer makes a dent: the excess depth
// presses like a flat body.
constexpr double most_dent = 1.0 / 3;

/// Ratio of pressure to depth, Pa/m, or of force to depth for an area, N/m.
struct Stiffness {
  double at_first = 0;  // up to the depth of a dent within a cell
  double beyond = 0;    // additional, beyond that depth
};

/// A point of the surface near a collider.
struct Met {
  contact::ContactSide side;
  contact::Distance nearest;  // to the collider, from there
  std::uint32_t feature = 0;  // as Contact::feature
  double area = 0;            // m²
  Stiffness stiffness;
  Vec3 outward = Vec3::Zero();  // normal of the tissue, unit
  double aslant = 0;  // sine between the surface and the collider; 0 if the surface does not face it
};

/// Returns the stiffness of a triangle's area against a body of that curvature (1/m).
Stiffness stiffness_of(const Tissue& tissue, std::uint32_t triangle, double area, double curvature) {
  const SoftDesc& desc = tissue.desc();
  const double flat =
      area * desc.material.youngs_modulus * tissue.collision.stiffness_factor / desc.geometry.surface_cell;
  if (curvature < least_round) return {flat, 0};
  const double nu = desc.material.poisson_ratio;
  const double dent =
      (desc.configuration.is_quadratic() ? dent_of_quadratic / (1 - nu) : dent_of_linear) / (1 - nu * nu);
  const double wanted = tissue.collision.stiffness_factor / usual_stiffness;
  const double round =
      std::min(flat, area * desc.material.youngs_modulus * wanted * dent / element_size(tissue, triangle));
  return {round, flat - round};
}

/// Returns the sine between a face and a collider's surface, from their outward unit normals; 0 if the face
/// does not face the collider.
double aslant(const Vec3& outward, const Vec3& normal) {
  const double facing = -outward.dot(normal);
  return std::max(0.0, facing) * (normal + facing * outward).norm();
}

/// Returns the number of contact points of a surface.
std::uint32_t points_of(const TriangleMesh& surface) {
  return static_cast<std::uint32_t>(surface.positions.size() +
                                    contact::most_face_points * surface.triangles.size());
}

class AreaContacts {
 public:
  AreaContacts(const Tissue& tissue, const contact::Collider& collider, double margin,
               const contact::ContactMemories& held, std::vector<contact::Contact>& out)
      : tissue_(tissue),
        collider_(collider),
        margin_(margin),
        held_(held),
        out_(out),
        surface_(tissue.anatomy().surface),
        still_(collider.fixed && !collider.driven_to) {
    other_.body = collider.slot;
  }

  void add_vertices() {
    const contact::SurfaceDetector& places = tissue_.surface.vertices();
    places.near(collider_, margin_, [&](std::uint32_t vertex, const contact::Distance& d) {
      if (!still_ && places.stretch_at(vertex) >= most_stretch) return;
      Met met;
      met.side = surface_side(tissue_, vertex);
      met.nearest = d;
      met.feature = vertex;
      met.outward = places.outward_at(vertex);
      met.aslant = 1;  // of the most parallel triangle; the others' load is carried by their own points
      for (const std::uint32_t triangle : places.around(vertex)) {
        const double whole = area_of(triangle),
                     area = whole * contact::corner_share(division(whole, d.curvature));
        met.area += area;
        met.aslant = std::min(met.aslant, aslant(places.outward(triangle), d.normal));
        const Stiffness of_part = stiffness_of(tissue_, triangle, area, d.curvature);
        met.stiffness.at_first += of_part.at_first;
        met.stiffness.beyond += of_part.beyond;
      }
      add(met);
    });
  }

  void add_faces() {
    const contact::SurfaceDetector& places = tissue_.surface.vertices();
    places.near_triangles(collider_, margin_, [&](std::uint32_t triangle) {
      const auto x = places.corners(triangle);
      const Vec3 middle = (x[0] + x[1] + x[2]) / 3;
      double reach = 0;
      for (const Vec3& corner : x) reach = std::max(reach, (corner - middle).norm());
      const contact::Distance d = contact::distance_to(collider_, middle, reach + margin_);
      if (d.value > reach + margin_) return;
      if (division(area_of(triangle), d.curvature) == contact::Division::corners) return;
      if (!still_ && places.stretch(triangle) >= most_stretch) return;
      add_points(triangle, d.curvature);
    });
  }

 private:
  double area_of(std::uint32_t triangle) const {
    const auto& t = surface_.triangles[triangle];
    const Vec3 &a = surface_.positions[t[0]], &b = surface_.positions[t[1]], &c = surface_.positions[t[2]];
    return (b - a).cross(c - a).norm() / 2;
  }

  contact::Division division(double area, double curvature) const {
    return contact::division_for(area, curvature, tissue_.desc().configuration.is_quadratic());
  }

  void add_points(std::uint32_t triangle, double curvature) {
    const double area = area_of(triangle);
    const contact::Division parts = division(area, curvature);
    const auto first = static_cast<std::uint32_t>(surface_.positions.size()) +
                       contact::most_face_points * triangle + contact::first_face_point(parts);
    const Vec3 outward = tissue_.surface.vertices().outward(triangle);
    const Stiffness whole = stiffness_of(tissue_, triangle, area, curvature);
    const auto points = contact::face_points(parts);
    for (std::uint32_t p = 0; p < points.size(); ++p) {
      const contact::ContactSide side = surface_side(tissue_, triangle, points[p].weights);
      const contact::Distance d = contact::distance_to(collider_, place_of(side, tissue_), margin_);
      const double share = points[p].share;
      if (d.value > margin_) continue;
      const Stiffness stiffness = {whole.at_first * share, whole.beyond * share};
      add({side, d, first + p, area * share, stiffness, outward, aslant(outward, d.normal)});
    }
  }

  void add(const Met& met) {
    const contact::ContactMemory* memory = contact::find(held_, other_, met.feature);
    contact::Approach approach{place_of(met.side, tissue_), met.nearest};
    if (memory) {
      approach.before = &memory->normal;
      approach.depth = memory->force / met.stiffness.at_first;
    }
    approach.outward = met.outward;
    approach.lip = lip * tissue_.desc().geometry.surface_cell;
    const std::optional<contact::Distance> side = contact::side_of(collider_, approach);
    if (!side || !(met.stiffness.at_first > 0)) return;
    contact::Contact& c = out_.emplace_back(rigid_contact(tissue_, approach.at, *side, collider_));
    c.a = met.side;
    c.stiffness = met.stiffness.at_first;
    c.feature = met.feature;
    soften(met, c);
    contact::recall(memory, c);
    if (met.stiffness.beyond > 0) add_beyond(met, c);
  }

  /// Adds the contact beyond the depth of a dent, if the point may get so deep in this tick.
  void add_beyond(const Met& met, contact::Contact first) {
    first.rest = -most_dent / met.nearest.curvature;
    first.gap -= first.rest;
    if (first.gap > margin_) return;
    first.stiffness = met.stiffness.beyond;
    first.feature += points_of(surface_);
    first.grip.setZero();
    first.gripped = 0;
    contact::recall(contact::find(held_, other_, first.feature), first);
    out_.push_back(first);
  }

  /// Makes the gap the mean over the point's area, with a spread by the angle between the surfaces.
  void soften(const Met& met, contact::Contact& c) const {
    if (division(met.area, met.nearest.curvature) == contact::Division::corners) return;
    const double width = std::sqrt(met.area);
    c.spread = met.aslant * width / 2;
    c.gap += std::min(met.nearest.curvature * met.area / 24, most_rise * width);
  }

  // Limit of the correction, as a fraction of a point's width, which thin bodies would exceed.
  static constexpr double most_rise = 1.0 / 16;

  const Tissue& tissue_;
  const contact::Collider& collider_;
  double margin_;
  const contact::ContactMemories& held_;
  std::vector<contact::Contact>& out_;
  const TriangleMesh& surface_;
  bool still_;
  contact::ContactSide other_;
};

}  // namespace

std::uint32_t area_features(const TriangleMesh& surface) {
  return 2 * points_of(surface);
}

void add_area_contacts(const Tissue& tissue, const contact::Collider& collider, double margin,
                       const contact::ContactMemories& held, std::vector<contact::Contact>& out) {
  AreaContacts contacts(tissue, collider, margin, held, out);
  contacts.add_vertices();
  contacts.add_faces();
}

}  // namespace prosector
