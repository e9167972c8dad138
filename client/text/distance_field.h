#pragma once
// Signed distance fields of glyph outlines. Private to client/text.

#include "client/text/font.h"

struct FT_GlyphSlotRec_;

namespace prosector {

/// Computes the signed distance field of the glyph outline in the FreeType slot, in the format of
/// Font::distances(), and returns it. Also renders the slot's bitmap. FreeType's equivalent
/// (FT_RENDER_MODE_SDF) takes twenty times as long. Returns an empty image for a glyph without an outline.
GlyphImage distance_field(FT_GlyphSlotRec_* slot);

}  // namespace prosector
