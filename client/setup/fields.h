#pragma once
// Input fields shared by several pages.

#include "client/setup/interface.h"
#include "drivers/config/client_config.h"

namespace prosector {

/// Draws three editable numbers. Returns whether they changed.
bool edit_vector(const char* name, Vec3& v);
/// Draws a choice of a tracker's receivers, named by their roles.
void edit_role(Interface& ui, StationRole& role);
/// Draws a choice of the glove's hand.
void edit_hand(Interface& ui, std::size_t& hand);

}  // namespace prosector
