#include "client/text/glyph_sheet.h"

#include <algorithm>
#include <utility>

namespace prosector {
namespace {

constexpr int apart = 1;  // pixels between glyphs, so that sampling at a border does not reach the neighbour
constexpr int shelf_steps = 4;  // pixels: heights of shelves are multiples

}  // namespace

std::size_t GlyphSheet::Hash::operator()(const GlyphKey& key) const {
  std::uint64_t mixed = std::uint64_t{key.font} << 40 ^ std::uint64_t{key.glyph} << 20 ^
                        static_cast<std::uint64_t>(key.size) << 2 ^ static_cast<std::uint64_t>(key.phase);
  mixed *= 0x9E3779B97F4A7C15U;  // golden-ratio multiplier: spreads keys that differ in a few bits (Knuth)
  return static_cast<std::size_t>(mixed ^ mixed >> 32);
}

std::optional<GlyphSpot> GlyphSheet::spot(const GlyphKey& key, const std::function<GlyphImage()>& make) {
  if (const auto known = spots_.find(key); known != spots_.end()) return known->second;
  const GlyphImage image = make();
  GlyphSpot spot{0, 0, image.width, image.height, image.left, image.top};
  if (image.width == 0 || image.width + apart > width || image.height > most_glyph_height)
    return spots_.emplace(key, GlyphSpot{}).first->second;
  Shelf* shelf = shelf_for(image.width + apart, image.height + apart);
  if (shelf == nullptr) return std::nullopt;
  spot.x = shelf->used;
  spot.y = shelf->top;
  shelf->used += image.width + apart;
  copy(image, spot);
  return spots_.emplace(key, spot).first->second;
}

/// Returns the lowest shelf with room that wastes less than half of its height, or begins a new one.
GlyphSheet::Shelf* GlyphSheet::shelf_for(int glyph_width, int glyph_height) {
  Shelf* best = nullptr;
  for (Shelf& shelf : shelves_)
    if (shelf.height >= glyph_height && shelf.height < 2 * glyph_height + shelf_steps &&
        shelf.used + glyph_width <= width && (best == nullptr || shelf.height < best->height))
      best = &shelf;
  const int rounded = (glyph_height + shelf_steps - 1) / shelf_steps * shelf_steps;
  if (best != nullptr && best->height <= rounded) return best;
  const int top = shelves_.empty() ? 0 : shelves_.back().top + shelves_.back().height;
  if (top + rounded > most_height) return best;
  while (top + rounded > height_) height_ *= 2;
  pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height_));
  shelves_.push_back({top, rounded});
  return &shelves_.back();
}

void GlyphSheet::copy(const GlyphImage& image, const GlyphSpot& spot) {
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * image.width, image.width,
                pixels_.begin() + static_cast<std::ptrdiff_t>(spot.y + y) * width + spot.x);
  const bool none = changed_.first == changed_.end;
  changed_.first = none ? spot.y : std::min(changed_.first, spot.y);
  changed_.end = std::max(none ? 0 : changed_.end, spot.y + image.height);
}

void GlyphSheet::clear() {
  spots_.clear();
  shelves_.clear();
  std::fill(pixels_.begin(), pixels_.end(), std::uint8_t{0});
  changed_ = {0, height_};
}

GlyphSheet::Rows GlyphSheet::take_changed() {
  return std::exchange(changed_, Rows{});
}

}  // namespace prosector
