#pragma once
// What keeps the elements of a solid that is hit from turning inside out.
//
// A body's surface tells others which side of it is tissue, and that of an element inside out says the
// opposite: what touches there is drawn in, and held. Most laws resist being turned inside out no more than
// being pressed (the corotational one, springs). So a body that is hit hard enough goes through itself before
// it stops. An element's vertices are therefore kept from passing its opposite face like those of one thing
// from passing into another. It is done by contacts of the vertex over the largest face. They are like the
// layers of air between things of Müller, Chentanez, Kim and Macklin 2015, "Air meshes for robust collision
// handling", but of tissue.

#include <vector>

#include "server/physics/contact/contact.h"

namespace prosector {

/// How to search one body.
struct FlatElementSearch {
  std::size_t body = 0;  // as in ContactSide::body
  double stiffness = 0;  // Pa: of an element at its limit, as an elastic modulus over its height
  double h = 0;          // s: how far ahead
};

/// Appends contacts of elements that are pressed flat, inside out, or may be h s on. `mesh`: linear
/// tetrahedra at rest; x, v: 3n, m and m/s, of their nodes.
void find_flat_elements(const TetMesh& mesh, const VecX& x, const VecX& v, const FlatElementSearch& search,
                        std::vector<Contact>& out);

/// Marks (1) the nodes of elements that are inside out, where mesh and x are as above; `marks`: one a node.
/// Returns whether there are any.
bool mark_inverted(const TetMesh& mesh, const VecX& x, std::vector<char>& marks);

/// Tells whether the contact is one of those: nothing touches there.
inline bool within_element(const Contact& c) {
  return c.a.kind == ContactSide::Kind::soft && c.b.kind == ContactSide::Kind::soft && c.a.body == c.b.body &&
         c.feature == Contact::no_feature;
}

}  // namespace prosector
