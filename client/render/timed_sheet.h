#pragma once
// A contact sheet of a session: a small image at regular intervals.

#include <vector>

#include "client/render/image.h"

namespace prosector {

class TimedSheet {
 public:
  /// Takes an image every `interval` seconds, starting with the first one available.
  explicit TimedSheet(double interval) : interval_(interval) {}

  bool wants(double seconds) const { return seconds >= next_; }
  /// Adds the image if one is due.
  void take(const Image& image, double seconds);
  std::size_t pictures() const { return tiles_.size(); }
  /// Arranges the images row by row in chronological order. Throws std::invalid_argument if there are none.
  Image sheet() const;

 private:
  double interval_;
  double next_ = 0;  // s
  std::vector<Image> tiles_;
};

}  // namespace prosector
