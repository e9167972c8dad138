#pragma once
// A font face: its shapes as pictures, and what HarfBuzz shapes with.

#include <cstdint>
#include <memory>
#include <vector>

#include "client/text/font_catalogue.h"

struct FT_LibraryRec_;
struct FT_FaceRec_;
struct hb_font_t;

namespace prosector {

/// A glyph as it is drawn: one byte a pixel, rows from the top.
struct GlyphImage {
  int width = 0, height = 0;
  int left = 0;  // pixels from the pen to the image's left
  int top = 0;   // pixels from the baseline up to the image's top
  std::vector<std::uint8_t> pixels;
};

inline constexpr int pen_phases = 4;          // places within a pixel at which a glyph may begin
inline constexpr int distance_em = 48;        // pixels of an em, of images of distances
inline constexpr int distance_reach = 6;      // pixels from the outline to where its image ends
inline constexpr double largest_image = 160;  // pixels of an em: larger text enlarges such images

class Font {
 public:
  /// Opens the face; the library outlives it. Throws InputError naming the file.
  Font(FT_LibraryRec_* library, const FontFile& file);

  /// Draws the glyph for a screen: what it covers of each pixel, 0…255. The em is `size` 64ths of a pixel,
  /// hinted lightly (in height alone). The pen stands `phase` of `pen_phases` within its pixel.
  GlyphImage coverage(std::uint32_t glyph, int size, int phase) const;
  /// Draws the glyph as distances from its outline: 128 on it, up to 255 `distance_reach` pixels inside, down
  /// to 1 as far outside. The em is `distance_em` pixels.
  GlyphImage distances(std::uint32_t glyph) const;

  hb_font_t* shaping() const { return shaping_.get(); }  // its scale: units of the em
  double units_per_em() const { return units_per_em_; }

 private:
  std::shared_ptr<FT_FaceRec_> face_;
  std::shared_ptr<hb_font_t> shaping_;
  double units_per_em_ = 1000;
};

}  // namespace prosector
