#pragma once
// Texts that libraries and the server hand to the client as they are, which shows them by its catalogue.
// Listed here so that xgettext finds them; deploy/check_language.py holds each to its source.

#include <array>

#include "client/language/catalogue.h"

namespace prosector {

inline constexpr std::array passing_texts = {
    // a panel's controls
    msg("attach"), msg("detach"), msg("hide others"), msg("show others"), msg("transparent"), msg("opaque"),
    msg("light shaft"), msg("light off"), msg("room bright"), msg("dim room"), msg("stiffness"),
    // how a device is
    msg("connecting"), msg("streaming"), msg("silent"), msg("babbling"), msg("absent"),
    // what the server refuses
    msg("only the host stops, slows and steps time"), msg("only parts of the anatomy have a panel"),
    msg("you have no panel open"), msg("a name is needed (--name NAME)"),
    msg("the name has control characters"), msg("a recording is watched: nobody takes part")};

}  // namespace prosector
