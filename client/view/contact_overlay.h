#pragma once
// Contact values of a hand: the green box at the left border.

#include <string>

#include "client/language/catalogue.h"
#include "client/view/draw_list.h"
#include "common/hand_messages.h"

namespace prosector {

/// Returns the values of a hand's contact with a body as lines of text: depth, point, normal, impulse, force,
/// the force's error and its direction. `body`: the body's name. `error`: relative error of the force; below
/// 0: unknown.
std::string contact_figures(const ContactSample& contact, const std::string& body, double error = -1,
                            const Catalogue& words = {});

/// Adds a text box with the values of a hand's contact to the left border of every eye's view. `body`: name
/// of the touched body. `error`: relative error of the force; below 0: unknown.
void add_contact_overlay(DrawList& list, const ContactSample& contact, const std::string& body,
                         double error = -1);

}  // namespace prosector
