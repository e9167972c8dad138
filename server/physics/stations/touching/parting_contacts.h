#pragma once
// Contacts that separate two overlapping solids (parting.h).

#include <optional>
#include <vector>

#include "server/physics/mechanics/contact/parting.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Separates the two bodies in a tick of h s, if needed, by contacts. They replace the contacts from `first`
/// on in `out` that can't determine the way out. `before`: previous entanglement; null: none. `pressed`:
/// whether a hand holds or presses one of them. Returns the new entanglement; none: ordinary contacts
/// suffice.
std::optional<Entanglement> add_parting_contacts(Tissue& a, Tissue& b, const Entanglement* before,
                                                 bool pressed, double h, std::size_t first,
                                                 std::vector<Contact>& out);

}  // namespace prosector
