#include "server/physics/stations/touching/area_contacts.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/contact/area_rule.h"
#include "server/physics/mechanics/contact/dent.h"
#include "server/physics/mechanics/contact/part_boxes.h"
#include "server/physics/mechanics/contact/vertex_gap.h"
#include "server/physics/stations/touching/pressed_patch.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"
#include "server/physics/stations/touching/surface_point.h"

namespace prosector {
namespace {

// Under a round body, quadratic elements yield less than the continuum. Their pressure is depth over element
// size, times E/(1 − ν²), times this factor over 1 − ν. Measured, see docs/look-up/contact-figures.md.
constexpr double dent_of_quadratic = 5.8;

constexpr double least_round = 0.1;  // 1/m: smaller curvature counts as flat

// The deepest dent of a ball is half of the larger of: this fraction of its radius; its radius without this
// fraction of a surface cell. Excess depth presses like a flat body, so that the ball stays outside.
constexpr double dent_of_radius = 1.0 / 3, part_of_cell = 0.4;

constexpr double least_facing = 0.5;  // cosine: steeper points count as this steep
constexpr double from_inside = 0.5;   // cosine between outward normals of tissue and collider
constexpr double rounding = 1e-9;     // m

/// A point of the surface near a collider.
struct Met {
  contact::ContactSide side;
  contact::Distance nearest;    // to the collider, from there
  std::uint32_t feature = 0;    // as Contact::feature
  double area = 0;              // m²
  double size = 0;              // m: of the elements there; 0 under a flat body
  Vec3 outward = Vec3::Zero();  // normal of the tissue, unit
  double aslant = 0;  // sine between the surface and the collider; 0 if the surface does not face it
  const contact::ContactMemory *memory = nullptr, *beyond = nullptr;  // of the last tick; null: none
};

/// Ratio of force to depth, N/m.
struct Stiffness {
  double at_first = 0;  // up to the depth of a dent
  double beyond = 0;    // additional, beyond that depth
};

bool is_round(const contact::Distance& d) {
  return d.curvature >= least_round;
}

/// Returns the radius (m) of a ball of the same curvature.
double ball_radius(const contact::Distance& d) {
  return 2 / d.curvature;
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
        still_(collider.fixed && !collider.driven_to),
        flat_(!tissue.desc().configuration.is_quadratic()),
        parts_(collider, margin + rounding),
        patches_(collider.parts->size()) {
    other_.body = collider.slot;
  }

  void meet_vertices() {
    const contact::SurfaceDetector& places = tissue_.surface.vertices();
    places.near(collider_, margin_, [&](std::uint32_t vertex, const contact::Distance& d) {
      if (!still_ && places.stretch_at(vertex) >= most_stretch) return;
      Met met;
      met.side = surface_side(tissue_, vertex);
      met.nearest = d;
      met.feature = vertex;
      met.outward = places.outward_at(vertex);
      met.aslant = 1;   // of the most parallel triangle; the others' load is carried by their own points
      double size = 0;  // m³: times area
      for (const std::uint32_t triangle : places.around(vertex)) {
        const double whole = area_of(triangle),
                     area = whole * contact::corner_share(division(whole, d.curvature));
        met.area += area;
        met.aslant = std::min(met.aslant, aslant(places.outward(triangle), d.normal));
        if (is_round(d)) size += area * element_size(tissue_, triangle);
      }
      met.size = size / met.area;
      meet(met);
    });
  }

  void meet_faces() {
    const contact::SurfaceDetector& places = tissue_.surface.vertices();
    places.near_triangles(collider_, margin_, [&](std::uint32_t triangle) {
      const auto x = places.corners(triangle);
      const std::vector<std::uint32_t>& parts =
          parts_.meeting(x[0].cwiseMin(x[1]).cwiseMin(x[2]), x[0].cwiseMax(x[1]).cwiseMax(x[2]));
      if (flat_ && parts.empty()) return;
      const Vec3 middle = (x[0] + x[1] + x[2]) / 3;
      double reach = 0;
      for (const Vec3& corner : x) reach = std::max(reach, (corner - middle).norm());
      const contact::Distance d = contact::distance_to(collider_, middle, reach + margin_);
      if (d.value > reach + margin_) return;
      if (division(area_of(triangle), d.curvature) == contact::Division::corners) return;
      if (!still_ && places.stretch(triangle) >= most_stretch) return;
      meet_points(triangle, x, d.curvature, parts);
    });
  }

  void add_contacts() {
    for (const PressedPatch& patch : patches_) spreads_.push_back(patch.spread());
    for (const Met& met : met_) add(met);
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

  /// Stores the points of the triangle that are near the collider. `x`: its corners; `parts`: indices of the
  /// collider's parts that may be near it.
  void meet_points(std::uint32_t triangle, const std::array<Vec3, 3>& x, double curvature,
                   std::span<const std::uint32_t> parts) {
    const double area = area_of(triangle);
    const contact::Division division = this->division(area, curvature);
    const auto first = static_cast<std::uint32_t>(surface_.positions.size()) +
                       contact::most_face_points * triangle + contact::first_face_point(division);
    const Vec3 outward = tissue_.surface.vertices().outward(triangle);
    const double size = curvature >= least_round ? element_size(tissue_, triangle) : 0;
    const auto points = contact::face_points(division);
    for (std::uint32_t p = 0; p < points.size(); ++p) {
      const Vec3& w = points[p].weights;
      if (flat_ && distance(w[0] * x[0] + w[1] * x[1] + w[2] * x[2], parts).value > margin_ + rounding)
        continue;
      const contact::ContactSide side = surface_side(tissue_, triangle, w);
      const contact::Distance d = distance(place_of(side, tissue_), parts);
      if (d.value > margin_) continue;
      meet({side, d, first + p, area * points[p].share, size, outward, aslant(outward, d.normal)});
    }
  }

  contact::Distance distance(const Vec3& x, std::span<const std::uint32_t> parts) const {
    return flat_ ? contact::distance_to(collider_, x, margin_ + rounding, parts)
                 : contact::distance_to(collider_, x, margin_);
  }

  /// Stores the point, and adds its last force to the patch that this part of the collider presses.
  void meet(Met met) {
    met.memory = contact::find(held_, other_, met.feature);
    met.beyond = contact::find(held_, other_, met.feature + points_of(surface_));
    for (const contact::ContactMemory* memory : {met.memory, met.beyond})
      if (memory) patches_[met.nearest.part].add(met.side, memory->force);
    met_.push_back(met);
  }

  Stiffness stiffness_of(const Met& met) const {
    const SoftDesc& desc = tissue_.desc();
    const double scale = is_round(met.nearest)
                             ? std::min(desc.geometry.surface_cell, ball_radius(met.nearest))
                             : desc.geometry.surface_cell;
    const double flat = met.area * desc.material.youngs_modulus * tissue_.collision.stiffness_factor / scale;
    if (!(met.size > 0)) return {flat, 0};
    const double round = std::min(flat, met.area * dent_pressure(met));
    return {round, flat - round};
  }

  /// Returns the ratio (Pa/m) of pressure to depth under a round body. Depth is measured along the collider's
  /// normal, so that a slope of angle θ divides the ratio by cos²θ.
  double dent_pressure(const Met& met) const {
    const SoftDesc& desc = tissue_.desc();
    const double nu = desc.material.poisson_ratio, modulus = desc.material.youngs_modulus / (1 - nu * nu);
    if (desc.configuration.is_quadratic()) return modulus * dent_of_quadratic / ((1 - nu) * met.size);
    const PressedPatch& patch = patches_[met.nearest.part];
    const double length = contact::dent_length(met.size, spreads_[met.nearest.part], nu),
                 radius = contact::contact_radius(patch.force(), ball_radius(met.nearest), modulus),
                 facing = std::max(-met.outward.dot(met.nearest.normal), least_facing);
    return modulus * contact::dent_stiffness(radius, length) / (facing * facing);
  }

  void add(const Met& met) const {
    // A collider that comes from inside the tissue, such as a hand that was placed there, is let out.
    if (!met.memory && met.outward.dot(met.nearest.normal) > from_inside) return;
    contact::Approach approach{place_of(met.side, tissue_), met.nearest};
    if (met.memory) {
      approach.before = &met.memory->normal;
      approach.depth = met.memory->force / met.memory->stiffness;
    }
    approach.outward = met.outward;
    approach.lip = lip * tissue_.desc().geometry.surface_cell;
    const std::optional<contact::Distance> side = contact::side_of(collider_, approach);
    const Stiffness stiffness = stiffness_of(met);
    if (!side || !(stiffness.at_first > 0)) return;
    contact::Contact& c = out_.emplace_back(rigid_contact(tissue_, approach.at, *side, collider_));
    c.a = met.side;
    c.stiffness = stiffness.at_first;
    c.feature = met.feature;
    soften(met, c);
    contact::recall(met.memory, c);
    if (stiffness.beyond > 0) add_beyond(met, stiffness.beyond);
  }

  /// Adds the contact beyond the depth of a dent, if the last one, which is up to that depth, may get so deep
  /// in this tick.
  void add_beyond(const Met& met, double stiffness) const {
    const double radius = ball_radius(met.nearest),
                 without = radius - part_of_cell * tissue_.desc().geometry.surface_cell,
                 rest = -std::max(dent_of_radius * radius, without) / 2;
    if (out_.back().gap - rest > margin_) return;
    contact::Contact c = out_.back();
    c.rest = rest;
    c.gap -= rest;
    c.stiffness = stiffness;
    c.feature += points_of(surface_);
    c.grip.setZero();
    c.gripped = 0;
    contact::recall(met.beyond, c);
    out_.push_back(c);
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
  bool flat_;  // triangles are flat: the points of linear elements are those between the corners
  contact::PartBoxes parts_;
  contact::ContactSide other_;
  std::vector<Met> met_;
  std::vector<PressedPatch> patches_;  // by part of the collider
  std::vector<double> spreads_;        // of the patches
};

}  // namespace

std::uint32_t area_features(const TriangleMesh& surface) {
  return 2 * points_of(surface);
}

void add_area_contacts(const Tissue& tissue, const contact::Collider& collider, double margin,
                       const contact::ContactMemories& held, std::vector<contact::Contact>& out) {
  AreaContacts contacts(tissue, collider, margin, held, out);
  contacts.meet_vertices();
  contacts.meet_faces();
  contacts.add_contacts();
}

}  // namespace prosector
