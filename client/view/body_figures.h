#pragma once
// A deformable's live figures as text, for the picture.

#include <string>

#include "client/language/catalogue.h"
#include "common/messages.h"

namespace prosector {

/// Returns its name, then how it is stepped: "12 steps of 1.39 ms"; then what is known of its error, and
/// whether it was stepped down. A line each.
std::string body_figures(const SceneBody& body, const BodyStatus& status, const Catalogue& words = {});

}  // namespace prosector
