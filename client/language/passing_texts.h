#pragma once
// Texts that libraries and the server pass to the client unchanged and that the client translates. They are
// listed here so that xgettext finds them; deploy/check_language.py compares each with its source.

#include <array>

#include "client/language/catalogue.h"

namespace prosector {

inline constexpr std::array passing_texts = {
    // controls of a panel
    msg("attach"), msg("detach"), msg("hide others"), msg("show others"), msg("transparent"), msg("opaque"),
    msg("light shaft"), msg("light off"), msg("room bright"), msg("dim room"), msg("stiffness"),
    // states of a device
    msg("connecting"), msg("streaming"), msg("silent"), msg("babbling"), msg("absent"),
    // reasons for the server's refusals
    msg("only the host can stop, slow or step time"), msg("only parts of the anatomy have a panel"),
    msg("you have no panel open"), msg("a name is needed (--name NAME)"),
    msg("the name has control characters"), msg("this is a recording: join as an observer")};

}  // namespace prosector
