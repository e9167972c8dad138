#pragma once
// Input fields shared by several pages.

#include "client/setup/interface.h"
#include "drivers/config/client_config.h"

namespace prosector {

/// Draws input fields for the three components of a vector, with the label `name`. Returns whether the user
/// changed them.
bool edit_vector(const char* name, Vec3& v);
/// Draws a list to choose a tracker's receiver by its role, such as right hand or head, and sets `role`.
void edit_role(Interface& ui, StationRole& role);
/// Draws a choice between the right and the left glove, and sets `hand` to right_hand or left_hand.
void edit_hand(Interface& ui, std::size_t& hand);

}  // namespace prosector
