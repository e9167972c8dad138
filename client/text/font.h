#pragma once
// A font face: its glyph images, and its HarfBuzz font for shaping.

#include <cstdint>
#include <memory>
#include <vector>

#include "client/text/font_catalogue.h"

struct FT_LibraryRec_;
struct FT_FaceRec_;
struct hb_font_t;

namespace prosector {

/// Image of a glyph and its offset from the pen. One byte per pixel, the coverage or the signed distance;
/// rows from the top.
struct GlyphImage {
  int width = 0, height = 0;
  int left = 0;  // pixels from the pen to the image's left
  int top = 0;   // pixels from the baseline up to the image's top
  std::vector<std::uint8_t> pixels;
};

inline constexpr int pen_phases = 4;          // positions within a pixel at which a glyph may begin
inline constexpr int distance_em = 48;        // pixels per em, of distance fields
inline constexpr int distance_reach = 6;      // pixels from the outline to its image's border
inline constexpr double largest_image = 160;  // pixels per em: larger text is scaled up from these images

class Font {
 public:
  /// Opens the font face in the file. The FreeType library must outlive this object. Throws InputError with
  /// the file name if FreeType can't read it.
  Font(FT_LibraryRec_* library, const FontFile& file);

  /// Renders the glyph's coverage of each pixel, 0 to 255, with light hinting (vertical only). `size` is that
  /// of the em, in 64ths of a pixel. The pen is at `phase` / `pen_phases` of a pixel from its pixel's left
  /// border.
  GlyphImage coverage(std::uint32_t glyph, int size, int phase) const;
  /// Computes the glyph's signed distance field: 128 on the outline, up to 255 at `distance_reach` pixels
  /// inside, down to 1 at the same distance outside. The em is `distance_em` pixels.
  GlyphImage distances(std::uint32_t glyph) const;

  hb_font_t* shaping() const { return shaping_.get(); }  // scaled in font units
  double units_per_em() const { return units_per_em_; }

 private:
  std::shared_ptr<FT_FaceRec_> face_;
  std::shared_ptr<hb_font_t> shaping_;
  double units_per_em_ = 1000;
};

}  // namespace prosector
