#pragma once
// A glyph atlas of bounded size. No GL: the user of the sheet uploads the rows that changed.

#include <functional>
#include <optional>
#include <unordered_map>

#include "client/text/font.h"

namespace prosector {

/// Key of a glyph's image on the sheet (texture atlas): the font, the glyph, its size, and the pen's phase
/// within a pixel.
struct GlyphKey {
  std::uint32_t font = 0, glyph = 0;
  int size = 0;   // 64ths of a pixel
  int phase = 0;  // 0 … pen_phases − 1
  bool operator==(const GlyphKey&) const = default;
};

struct GlyphSpot {
  int x = 0, y = 0, width = 0, height = 0;  // on the sheet, pixels; width 0: nothing to draw
  int left = 0, top = 0;                    // as in GlyphImage
};

class GlyphSheet {
 public:
  static constexpr int width = 1024;             // pixels, one byte each
  static constexpr int least_height = 256;       // initial height
  static constexpr int most_height = 2048;       // limits a sheet to 2 MiB
  static constexpr int most_glyph_height = 512;  // higher glyphs are not stored

  /// Returns the position of the glyph's image on the sheet. At the key's first use, `make` renders the
  /// image, which is then added. Returns nullopt if the sheet is full; it must be cleared first.
  std::optional<GlyphSpot> spot(const GlyphKey& key, const std::function<GlyphImage()>& make);
  /// Removes all glyph images from the sheet. The sheet's height stays.
  void clear();

  int height() const { return height_; }
  std::size_t glyphs() const { return spots_.size(); }
  const std::uint8_t* row(int y) const {
    return pixels_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }

  struct Rows {
    int first = 0, end = 0;
  };
  /// Returns the range of the sheet's pixel rows that changed since the last call, which must be uploaded to
  /// the texture.
  Rows take_changed();

 private:
  struct Hash {
    std::size_t operator()(const GlyphKey& key) const;
  };
  /// Shelf of the glyph sheet: a strip of pixel rows in which images of similar height are placed from left
  /// to right.
  struct Shelf {
    int top, height, used = 0;
  };
  Shelf* shelf_for(int glyph_width, int glyph_height);
  void copy(const GlyphImage& image, const GlyphSpot& spot);

  int height_ = least_height;
  std::vector<std::uint8_t> pixels_ =
      std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(least_height));
  std::vector<Shelf> shelves_;
  std::unordered_map<GlyphKey, GlyphSpot, Hash> spots_;
  Rows changed_;
};

}  // namespace prosector
