#pragma once
// Typesetting of a DrawText with the size that it is drawn with, for layouts around it.

#include "client/text/typesetter.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Lays out the text with the size and limits of the DrawText. `scale`: units of the result per unit of the
/// text, for instance pixels per point.
inline SetText set_text(Typesetter& typesetter, const DrawText& text, double scale) {
  return typesetter.set(text.text, {.size = scale * text.height,
                                    .least_size = scale * text.least_height,
                                    .width = scale * text.wrap,
                                    .height = scale * text.tallest,
                                    .centred = text.centred});
}

}  // namespace prosector
