#pragma once
// What a hand feels, in figures: the green box at the left border.

#include <string>

#include "client/language/catalogue.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Returns the figures as lines of text: depth, point, normal, impulse, force, how far that may be off, and
/// its direction. `error`: of the force, fraction; below 0: not known.
std::string contact_figures(const ContactSample& contact, const std::string& body, double error = -1,
                            const Catalogue& words = {});

/// Adds the figures beside the axes, over the picture of every eye.
void add_contact_overlay(DrawList& list, const ContactSample& contact, const std::string& body,
                         double error = -1);

}  // namespace prosector
