#include "client/text/font.h"

#include <fmt/format.h>
#include <ft2build.h>
#include <hb.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "client/text/distance_field.h"
#include "common/error.h"

namespace prosector {
namespace {

std::shared_ptr<hb_font_t> shaping_font(const FontFile& file) {
  hb_blob_t* blob = hb_blob_create_from_file(file.path.c_str());
  // FreeType's index: the face in the lower half, a variable font's named instance, counted from 1, in the
  // upper one.
  hb_face_t* face = hb_face_create(blob, static_cast<unsigned>(file.index & 0xFFFF));
  hb_font_t* font = hb_font_create(face);
  if (const int instance = file.index >> 16; instance > 0)
    hb_font_set_var_named_instance(font, static_cast<unsigned>(instance - 1));
  hb_face_destroy(face);
  hb_blob_destroy(blob);
  return {font, &hb_font_destroy};
}

/// Copies the slot's bitmap; returns an empty image for a glyph without a shape.
GlyphImage image_of(const FT_GlyphSlot slot) {
  const FT_Bitmap& bitmap = slot->bitmap;
  GlyphImage image{
      static_cast<int>(bitmap.width), static_cast<int>(bitmap.rows), slot->bitmap_left, slot->bitmap_top, {}};
  if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY || image.width == 0 || image.height == 0) return {};
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* row = bitmap.buffer + static_cast<std::ptrdiff_t>(y) * bitmap.pitch;
    image.pixels.insert(image.pixels.end(), row, row + image.width);
  }
  return image;
}

}  // namespace

Font::Font(FT_LibraryRec_* library, const FontFile& file) {
  FT_Face face = nullptr;
  if (FT_New_Face(library, file.path.c_str(), file.index, &face) != 0)
    throw InputError(fmt::format("text: FreeType cannot read the font {}", file.path.string()));
  face_.reset(face, &FT_Done_Face);
  shaping_ = shaping_font(file);
  units_per_em_ = hb_face_get_upem(hb_font_get_face(shaping_.get()));
}

GlyphImage Font::coverage(std::uint32_t glyph, int size, int phase) const {
  FT_Face face = face_.get();
  if (FT_Set_Char_Size(face, size, size, 72, 72) != 0) return {};
  if (FT_Load_Glyph(face, glyph, FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP) != 0) return {};
  if (face->glyph->format == FT_GLYPH_FORMAT_OUTLINE)
    FT_Outline_Translate(&face->glyph->outline, phase * 64 / pen_phases, 0);
  if (FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) != 0) return {};
  return image_of(face->glyph);
}

GlyphImage Font::distances(std::uint32_t glyph) const {
  FT_Face face = face_.get();
  if (FT_Set_Pixel_Sizes(face, distance_em, distance_em) != 0) return {};
  if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) return {};
  return distance_field(face->glyph);
}

}  // namespace prosector
