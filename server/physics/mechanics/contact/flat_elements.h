#pragma once
// Contacts that keep elements of a solid from inverting under impact.
//
// The body's surface defines which side of it is tissue. Where an element is inverted, the surface defines
// the opposite side, and a contact there attracts and holds the other body. Most laws (the corotational law,
// springs) resist inversion no more than compression. A body that is hit hard enough would therefore pass
// through itself before it stops. To prevent that, a contact keeps each element's vertex from passing its
// largest face. These contacts resemble the air layers of Müller, Chentanez, Kim and Macklin 2015, "Air
// meshes for robust collision handling", but lie in tissue.

#include <vector>

#include "server/physics/mechanics/contact/contact.h"

namespace prosector::contact {

/// Parameters of the search of one soft body for tetrahedra that are flat or inverted.
struct FlatElementSearch {
  std::size_t body = 0;  // as in ContactSide::body
  // Elastic modulus, Pa. A contact's stiffness is the modulus times a third of the face's area over the
  // height, both at rest.
  double stiffness = 0;
  double h = 0;  // s: look-ahead
};

/// Appends contacts that keep tetrahedra of a soft body from inverting. Each is between an element's vertex
/// and its largest face. Elements get one if they are flat or inverted, or may become so within the
/// look-ahead time `search.h`. `mesh`: linear tetrahedra at rest. x, v: three coordinates per node, m and
/// m/s.
void find_flat_elements(const TetMesh& mesh, const VecX& x, const VecX& v, const FlatElementSearch& search,
                        std::vector<Contact>& out);

/// Marks with 1 the nodes of inverted tetrahedra. `mesh`: linear tetrahedra at rest. `x`: current node
/// positions, three coordinates per node, m. `marks`: one entry per node, or empty if no element is inverted.
/// Returns whether any element is inverted.
bool mark_inverted(const TetMesh& mesh, const VecX& x, std::vector<char>& marks);

/// Returns whether the contact is within one tetrahedron, which it keeps from inverting
/// (find_flat_elements()), so that no two bodies touch there.
inline bool within_element(const Contact& c) {
  return c.a.kind == ContactSide::Kind::soft && c.b.kind == ContactSide::Kind::soft && c.a.body == c.b.body &&
         c.feature == Contact::no_feature;
}

}  // namespace prosector::contact
