#pragma once
// Signed distance fields of glyph outlines. Private to client/text.

#include "client/text/font.h"

struct FT_GlyphSlotRec_;

namespace prosector {

/// Draws the distance field of the outline in the slot, as documented at Font::distances(), and renders the
/// slot. FreeType's equivalent (FT_RENDER_MODE_SDF) takes twenty times as long.
GlyphImage distance_field(FT_GlyphSlotRec_* slot);

}  // namespace prosector
