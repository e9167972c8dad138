#pragma once
// Contacts that lead two solids out of each other (parting.h).

#include <optional>
#include <vector>

#include "server/physics/contact/parting.h"
#include "server/physics/tissue.h"

namespace prosector {

/// Leads the two bodies apart in a tick of h s, where that is needed, by contacts. They replace those from
/// `first` on in `out` that can't tell the way out. `before`: what was known of the bodies; null: nothing.
/// `pressed`: a hand holds or presses one of them. Returns how they are led; none: contacts press them apart
/// by themselves.
std::optional<Entanglement> add_parting_contacts(Tissue& a, Tissue& b, const Entanglement* before,
                                                 bool pressed, double h, std::size_t first,
                                                 std::vector<Contact>& out);

}  // namespace prosector
