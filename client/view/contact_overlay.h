#pragma once
// Contact values of a hand: the green box at the left border.

#include <string>

#include "client/language/catalogue.h"
#include "client/view/draw_list.h"
#include "common/hand_messages.h"

namespace prosector {

/// Returns the values as lines of text: depth, point, normal, impulse, force, the force's error and its
/// direction. `error`: relative error of the force; below 0: unknown.
std::string contact_figures(const ContactSample& contact, const std::string& body, double error = -1,
                            const Catalogue& words = {});

/// Adds the text box next to the axes, over the view of every eye.
void add_contact_overlay(DrawList& list, const ContactSample& contact, const std::string& body,
                         double error = -1);

}  // namespace prosector
