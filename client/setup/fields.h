#pragma once
// Fields that several pages ask people to fill in.

#include "client/setup/interface.h"
#include "drivers/client_config.h"

namespace prosector {

/// Shows three numbers to edit. Returns whether they were changed.
bool edit_vector(const char* name, Vec3& v);
/// Shows which of a tracker's receivers is meant, by what it is fixed to.
void edit_role(Interface& ui, StationRole& role);
/// Shows which hand's glove is meant.
void edit_hand(Interface& ui, std::size_t& hand);

}  // namespace prosector
