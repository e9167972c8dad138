#pragma once
// How large a DrawText is as it will be drawn: for whoever stands something beside it.

#include "client/text/typesetter.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Sets the text; `scale` is how many of the result's units one of the text's is: pixels of a point, for
/// instance, or 1.
inline SetText set_text(Typesetter& typesetter, const DrawText& text, double scale) {
  return typesetter.set(text.text, {.size = scale * text.height,
                                    .least_size = scale * text.least_height,
                                    .width = scale * text.wrap,
                                    .height = scale * text.tallest,
                                    .centred = text.centred});
}

}  // namespace prosector
