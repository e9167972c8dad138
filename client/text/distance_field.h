#pragma once
// Distances from a glyph's outline. Private to client/text.

#include "client/text/font.h"

struct FT_GlyphSlotRec_;

namespace prosector {

/// Draws the outline in the slot as Font::distances() says, and renders the slot. FreeType draws the same
/// (FT_RENDER_MODE_SDF) in twenty times the time.
GlyphImage distance_field(FT_GlyphSlotRec_* slot);

}  // namespace prosector
