#pragma once
// A contact sheet of a session: a small image at regular intervals.

#include <vector>

#include "client/render/image.h"

namespace prosector {

class TimedSheet {
 public:
  /// Creates an empty contact sheet (small images of a session in one image). An image is taken every
  /// `interval` seconds, starting with the first one available.
  explicit TimedSheet(double interval) : interval_(interval) {}

  bool wants(double seconds) const { return seconds >= next_; }
  /// Adds the image, scaled down, if one is due at the session time `seconds`; ignores it otherwise.
  void take(const Image& image, double seconds);
  std::size_t pictures() const { return tiles_.size(); }
  /// Returns one image with all added images row by row in chronological order. Throws std::invalid_argument
  /// if there are none.
  Image sheet() const;

 private:
  double interval_;
  double next_ = 0;  // s
  std::vector<Image> tiles_;
};

}  // namespace prosector
