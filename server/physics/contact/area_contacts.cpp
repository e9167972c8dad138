#include "server/physics/contact/area_contacts.h"

#include <algorithm>
#include <cmath>

#include "server/physics/contact/area_rule.h"
#include "server/physics/contact/facing.h"
#include "server/physics/contact/rigid_soft_contacts.h"
#include "server/physics/contact/surface_point.h"

namespace prosector {
namespace {

// Under what is round a surface gives way by more than elements show, because they spread the load over a
// cell. So the pressure on it is that of the dent within a cell: the depth over the cell's size, times
// E/(1 − ν²) and this. Quadratic elements dent the more by themselves the less compressible they are, so it
// is over 1 − ν. Measured, see docs/understand/contact.md.
constexpr double dent_of_linear = 2.1, dent_of_quadratic = 5.8;

const double usual_stiffness = SceneDesc().contact_stiffness;  // for which that was measured

constexpr double least_round = 0.1;  // 1/m: below it what is round is flat

// Deeper than this share of its radius of curvature, a round thing is no dent any more: what is beyond
// presses as what is flat does.
constexpr double most_dent = 1.0 / 3;

/// Pressure over depth, Pa/m, or for some area force over depth, N/m.
struct Stiffness {
  double at_first = 0;  // as deep as a dent within a cell
  double beyond = 0;    // what comes to it deeper
};

/// What a point of the surface is met with.
struct Met {
  ContactSide side;
  Distance nearest;           // of the thing there
  std::uint32_t feature = 0;  // as Contact::feature
  double area = 0;            // m²
  Stiffness stiffness;
  Vec3 outward = Vec3::Zero();  // of the tissue, unit
  double aslant = 0;            // sine between the surface and the thing there, where it faces that
};

/// Returns the stiffness of a triangle's area under a thing of that curvature (1/m).
Stiffness stiffness_of(const Tissue& tissue, std::uint32_t triangle, double area, double curvature) {
  const SoftDesc& desc = tissue.desc();
  const double flat = area * desc.youngs_modulus * tissue.collision.stiffness_factor / desc.surface_cell;
  if (curvature < least_round) return {flat, 0};
  const double nu = desc.poisson_ratio;
  const double dent =
      (desc.element == "tet10" ? dent_of_quadratic / (1 - nu) : dent_of_linear) / (1 - nu * nu);
  const double wanted = tissue.collision.stiffness_factor / usual_stiffness;
  const double round =
      std::min(flat, area * desc.youngs_modulus * wanted * dent / element_size(tissue, triangle));
  return {round, flat - round};
}

/// Returns the sine between a face and a thing, by unit normals out of both; 0 where it doesn't face that.
double aslant(const Vec3& outward, const Vec3& normal) {
  const double facing = -outward.dot(normal);
  return std::max(0.0, facing) * (normal + facing * outward).norm();
}

/// Returns how many points a surface may be pressed at.
std::uint32_t points_of(const TriangleMesh& surface) {
  return static_cast<std::uint32_t>(surface.positions.size() + most_face_points * surface.triangles.size());
}

class AreaContacts {
 public:
  AreaContacts(const Tissue& tissue, const Collider& collider, double margin, const ContactMemories& held,
               std::vector<Contact>& out)
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
    const SurfaceDetector& places = tissue_.surface.vertices();
    places.near(collider_, margin_, [&](std::uint32_t vertex, const Distance& d) {
      if (!still_ && places.stretch_at(vertex) >= most_stretch) return;
      Met met;
      met.side = surface_side(tissue_, vertex);
      met.nearest = d;
      met.feature = vertex;
      met.outward = places.outward_at(vertex);
      met.aslant = 1;  // of the face that faces most: what the others would press is theirs
      for (const std::uint32_t triangle : places.around(vertex)) {
        const double whole = area_of(triangle), area = whole * corner_share(division(whole, d.curvature));
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
    const SurfaceDetector& places = tissue_.surface.vertices();
    places.near_triangles(collider_, margin_, [&](std::uint32_t triangle) {
      const auto x = places.corners(triangle);
      const Vec3 middle = (x[0] + x[1] + x[2]) / 3;
      double reach = 0;
      for (const Vec3& corner : x) reach = std::max(reach, (corner - middle).norm());
      const Distance d = distance_to(collider_, middle, reach + margin_);
      if (d.value > reach + margin_) return;
      if (division(area_of(triangle), d.curvature) == Division::corners) return;
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

  Division division(double area, double curvature) const {
    return division_for(area, curvature, tissue_.desc().element == "tet10");
  }

  void add_points(std::uint32_t triangle, double curvature) {
    const double area = area_of(triangle);
    const Division parts = division(area, curvature);
    const auto first = static_cast<std::uint32_t>(surface_.positions.size()) + most_face_points * triangle +
                       first_face_point(parts);
    const Vec3 outward = tissue_.surface.vertices().outward(triangle);
    const Stiffness whole = stiffness_of(tissue_, triangle, area, curvature);
    const auto points = face_points(parts);
    for (std::uint32_t p = 0; p < points.size(); ++p) {
      const ContactSide side = surface_side(tissue_, triangle, points[p].weights);
      const Distance d = distance_to(collider_, place_of(side, tissue_), margin_);
      const double share = points[p].share;
      if (d.value > margin_) continue;
      const Stiffness stiffness = {whole.at_first * share, whole.beyond * share};
      add({side, d, first + p, area * share, stiffness, outward, aslant(outward, d.normal)});
    }
  }

  void add(const Met& met) {
    const ContactMemory* memory = find(held_, other_, met.feature);
    Approach approach{place_of(met.side, tissue_), met.nearest};
    if (memory) {
      approach.before = &memory->normal;
      approach.depth = memory->force / met.stiffness.at_first;
    }
    approach.outward = met.outward;
    approach.lip = lip * tissue_.desc().surface_cell;
    const std::optional<Distance> side = side_of(collider_, approach);
    if (!side || !(met.stiffness.at_first > 0)) return;
    Contact& c = out_.emplace_back(rigid_contact(tissue_, approach.at, *side, collider_));
    c.a = met.side;
    c.stiffness = met.stiffness.at_first;
    c.feature = met.feature;
    soften(met, c);
    recall(memory, c);
    if (met.stiffness.beyond > 0) add_beyond(met, c);
  }

  /// Adds what a point presses beyond the depth of a dent, if it may be so deep in this tick.
  void add_beyond(const Met& met, Contact first) {
    first.rest = -most_dent / met.nearest.curvature;
    first.gap -= first.rest;
    if (first.gap > margin_) return;
    first.stiffness = met.stiffness.beyond;
    first.feature += points_of(surface_);
    first.grip.setZero();
    first.gripped = 0;
    recall(find(held_, other_, first.feature), first);
    out_.push_back(first);
  }

  /// Takes the gap for the mean over the point's area, over which it varies as far as the two are aslant.
  void soften(const Met& met, Contact& c) const {
    if (division(met.area, met.nearest.curvature) == Division::corners) return;
    const double width = std::sqrt(met.area);
    c.spread = met.aslant * width / 2;
    c.gap += std::min(met.nearest.curvature * met.area / 24, most_rise * width);
  }

  static constexpr double most_rise = 1.0 / 16;  // of a point's width: what thinner things would take

  const Tissue& tissue_;
  const Collider& collider_;
  double margin_;
  const ContactMemories& held_;
  std::vector<Contact>& out_;
  const TriangleMesh& surface_;
  bool still_;
  ContactSide other_;
};

}  // namespace

std::uint32_t area_features(const TriangleMesh& surface) {
  return 2 * points_of(surface);
}

void add_area_contacts(const Tissue& tissue, const Collider& collider, double margin,
                       const ContactMemories& held, std::vector<Contact>& out) {
  AreaContacts contacts(tissue, collider, margin, held, out);
  contacts.add_vertices();
  contacts.add_faces();
}

}  // namespace prosector
