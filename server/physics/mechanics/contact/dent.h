#pragma once
// Contact stiffness under round bodies, which models the part of a dent that linear elements do not resolve.
//
// Elements spread a load over their nodes, so the surface of a mesh yields less under a small patch than the
// continuum. The contact's compliance adds the difference (docs/understand/contact.md).

namespace prosector::contact {

/// Returns the radius (m) of the contact patch between a ball and a half-space (Hertz): a³ = 3FR/(4E*).
/// `force`: F, N. `radius`: R of the ball, m. `modulus`: E* = E/(1 − ν²), Pa.
double contact_radius(double force, double radius, double modulus);

/// Returns the length l (m) that relates a mesh's displacement to a half-space's. Under a patch of radius a,
/// the mesh yields a/l of what a half-space yields to the same force (Hertz). A mesh's mean displacement
/// under a load is about 0.9·√spread·F/(E*·element_size), less where linear elements lock.
/// `element_size`: m, edge of a cube each of whose faces consists of two element faces.
/// `spread`: Σw² of the fractions w of the force that nodes take, 1 if one node takes all.
double dent_length(double element_size, double spread, double poisson_ratio);

/// Returns the ratio (1/m) of pressure over E* to depth, in a contact with a ball, with which contact and
/// mesh together yield like a half-space. `patch`: radius a of the contact patch, m. `length`: l, m.
/// Where elements are large, the mesh moves evenly under the patch. The contact then yields the depth
/// (1 − a/l)·a²/R, and a bed of springs under a ball gives 4/(3πa(1 − a/l)²). Where elements are small, the
/// pressure is Hertz's, whose mean depth is (4/5 − a/l)·a²/R, which gives 3/(2πa(4/5 − a/l)). The formulas
/// agree at a/l = 0.696, where they take over. Patches count as at least 0.05·l large.
double dent_stiffness(double patch, double length);

}  // namespace prosector::contact
