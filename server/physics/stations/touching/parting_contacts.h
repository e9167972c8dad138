#pragma once
// Contacts that separate two overlapping solids (parting.h).

#include <optional>
#include <vector>

#include "server/physics/mechanics/contact/parting.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Appends contacts that separate the soft bodies a and b in a tick of h s, if they overlap too deeply for
/// ordinary contacts. Removes ordinary contacts between them, which `out` contains from index `first` on,
/// that can't determine the way out. `before` is their entanglement in the last tick, or null. `pressed`:
/// whether a hand holds or presses one of them. Returns the new entanglement, or none if ordinary contacts
/// suffice.
std::optional<contact::Entanglement> add_parting_contacts(Tissue& a, Tissue& b,
                                                          const contact::Entanglement* before, bool pressed,
                                                          double h, std::size_t first,
                                                          std::vector<contact::Contact>& out);

}  // namespace prosector
