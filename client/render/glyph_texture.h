#pragma once
// A glyph sheet on the GPU. Private to client/render.

#include "client/render/gl.h"
#include "client/text/glyph_sheet.h"

namespace prosector {

class GlyphTexture {
 public:
  explicit GlyphTexture(const Gl& gl);
  ~GlyphTexture();
  GlyphTexture(const GlyphTexture&) = delete;
  GlyphTexture& operator=(const GlyphTexture&) = delete;

  GlyphSheet& sheet() { return sheet_; }
  /// Uploads the rows of the glyph sheet that changed since the last call, and binds the sheet's texture to
  /// unit 0.
  void bind();

 private:
  const Gl& gl_;
  GlyphSheet sheet_;
  GLuint texture_ = 0;
  int height_ = 0;  // of the texture, pixels
};

}  // namespace prosector
