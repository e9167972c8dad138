#include "client/render/timed_sheet.h"

#include <cmath>

#include "client/render/contact_sheet.h"

namespace prosector {
namespace {

constexpr int columns = 5, tile_width = 240;

}  // namespace

void TimedSheet::take(const Image& image, double seconds) {
  if (!wants(seconds)) return;
  tiles_.push_back(shrunk(image, tile_width));
  next_ = interval_ * (std::floor(seconds / interval_) + 1);
}

Image TimedSheet::sheet() const {
  return contact_sheet(tiles_, columns, tile_width);
}

}  // namespace prosector
