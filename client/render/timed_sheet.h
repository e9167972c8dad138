#pragma once
// A contact sheet of a session: a small picture every so often.

#include <vector>

#include "client/render/image.h"

namespace prosector {

class TimedSheet {
 public:
  /// Takes a picture every `interval` seconds, the first one as soon as there is one.
  explicit TimedSheet(double interval) : interval_(interval) {}

  bool wants(double seconds) const { return seconds >= next_; }
  /// Takes the picture where one is due.
  void take(const Image& image, double seconds);
  std::size_t pictures() const { return tiles_.size(); }
  /// Lays the pictures row by row in the order taken. Throws std::invalid_argument while there is none.
  Image sheet() const;

 private:
  double interval_;
  double next_ = 0;  // s
  std::vector<Image> tiles_;
};

}  // namespace prosector
