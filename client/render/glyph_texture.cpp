#include "client/render/glyph_texture.h"

namespace prosector {

GlyphTexture::GlyphTexture(const Gl& gl) : gl_(gl) {
  gl_.GenTextures(1, &texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

GlyphTexture::~GlyphTexture() {
  gl_.DeleteTextures(1, &texture_);
}

void GlyphTexture::bind() {
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  const GlyphSheet::Rows changed = sheet_.take_changed();
  if (height_ != sheet_.height()) {
    height_ = sheet_.height();
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, GlyphSheet::width, height_, 0, GL_RED, GL_UNSIGNED_BYTE,
                   sheet_.row(0));
  } else if (changed.first < changed.end) {
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, changed.first, GlyphSheet::width, changed.end - changed.first,
                      GL_RED, GL_UNSIGNED_BYTE, sheet_.row(changed.first));
  }
}

}  // namespace prosector
