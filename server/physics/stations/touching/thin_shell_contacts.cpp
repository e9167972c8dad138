#include "server/physics/stations/touching/thin_shell_contacts.h"

#include <algorithm>

#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/stations/touching/soft_pair_contacts.h"

namespace prosector {
namespace {

// Parts of one surface that are nearer than this at rest count as neighbours.
constexpr double cells_apart = 2.5;
constexpr double thicknesses_apart = 1.5;
constexpr double approach_safety = 1.5;   // factor on the approach speed, which may grow in the tick
constexpr double tangential_share = 0.2;  // share of tangential motion that may turn into approach
// Largest stiffness, times the effective mass over h². It stops an approach of one cell per tick within a
// fraction of a millimetre, and tangles under mutual pressure store almost no energy.
constexpr double most_stiffness_over_mass = 30;  // 1/h²

/// Returns the inverse effective mass of a point, 1/kg: velocity change per impulse.
double lightness(const soft::SoftBody& body, const contact::ContactSide& side) {
  double sum = 0;
  for (std::size_t k = 0; k < side.nodes; ++k)
    sum += side.weight[k] * side.weight[k] / body.node_mass()[Eigen::Index{side.node[k]}];
  return sum;
}

Vec3 velocity_of(const soft::SoftBodyState& state, const contact::ContactSide& side) {
  Vec3 v = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k)
    v += side.weight[k] * state.motion.v.segment<3>(3 * Eigen::Index{side.node[k]});
  return v;
}

/// Returns whether the sides of the contact, now `gap` m apart, may come together within h s.
bool nears(const Tissue& tissue_a, const Tissue& tissue_b, const contact::Contact& contact, double gap,
           double h) {
  const soft::SoftBodyState &a = tissue_a.state, &b = tissue_b.state;
  // Bodies in relaxation have zero velocity, but move by whole steps.
  if (gap <= contact::contact_margin || (a.motion.v.isZero(0) && b.motion.v.isZero(0))) return true;
  const Vec3 apart = velocity_of(a, contact.a) - velocity_of(b, contact.b);
  const double nearing =
      approach_safety * std::max(0.0, -apart.dot(contact.normal)) + tangential_share * apart.norm();
  return gap <= contact::contact_margin + h * nearing;
}

}  // namespace

int add_thin_shell_contacts(Tissue& a, Tissue& b, std::vector<contact::LayerSide>& sides, bool one_organ,
                            double margin, double h, std::vector<contact::Contact>& out) {
  const contact::ElementSurface &of_a = a.elements(), &of_b = b.elements();
  contact::LayerSearch search;
  search.thickness = a.half_thickness() + b.half_thickness();
  search.margin = margin;
  if (one_organ) {
    search.apart_at_rest =
        std::max(cells_apart * a.desc().geometry.cell, thicknesses_apart * search.thickness);
    search.seam = (thicknesses_apart - 1) * search.thickness;
  }
  std::vector<contact::LayerMeeting> found;
  const int passed = contact::find_layers(of_a, of_b, search, sides, found);
  for (contact::LayerMeeting meeting : found) {
    // The side with the corner stores the memory.
    const bool turned = meeting.kind == contact::LayerMeet::corner_of_b;
    if (turned) contact::swap_sides(meeting);
    const Tissue &first = turned ? b : a, &second = turned ? a : b;
    const contact::ElementSurface &own = turned ? of_b : of_a, &other = turned ? of_a : of_b;
    contact::Contact c = pair_contact(first, second, meeting.normal, meeting.gap);
    own.add(meeting.a, meeting.weights_a, c.a);
    other.add(meeting.b, meeting.weights_b, c.b);
    if (!nears(first, second, c, meeting.gap, h)) continue;
    c.gap = std::max(c.gap, -overlap_opening_speed * h);
    c.point = collision::at(own.now(meeting.a), meeting.weights_a);
    c.stiffness = 0;
    for (std::size_t k = 0; k < 3; ++k)
      c.stiffness += meeting.weights_a[static_cast<Eigen::Index>(k)] *
                     pair_stiffness(first, second, own.corners(meeting.a)[k]);
    const double mass = 1 / (lightness(*first.solver, c.a) + lightness(*second.solver, c.b));
    c.stiffness = std::min(c.stiffness, most_stiffness_over_mass * mass / (h * h));
    c.feature = own.feature(meeting.a, meeting.weights_a);
    c.met = other.feature(meeting.b, meeting.weights_b);
    contact::recall(contact::find_layer(first.memories, c), c);
    out.push_back(c);
  }
  return passed;
}

}  // namespace prosector
