#pragma once
// Finds tags of the family 36h11 in straight pictures, by libapriltag (Krogius, Haggenmiller and Olson 2019).

#include <array>
#include <memory>
#include <vector>

#include "drivers/camera/grey_image.h"
#include "drivers/camera/lens.h"

namespace prosector {

/// A tag in a picture.
struct SeenTag {
  int code = 0;
  std::array<Vec2, 4>
      corners;        // pixels; of the black square: lower left, lower right, upper right, upper left
  double margin = 0;  // how sure its bits are; less than 20 was left out
};

struct TagFinderSettings {
  double decimate =
      2;  // quads are looked for in a picture so many times smaller; 1 sees farther and takes longer.
          // Pictures of at most `undecimated_pixels` are always searched at 1: there it is as quick
};

inline constexpr int undecimated_pixels = 400 * 300;

class TagFinder {
 public:
  explicit TagFinder(const TagFinderSettings& settings);
  ~TagFinder();

  /// Finds what is there, by code. A code may come twice where it is printed twice.
  std::vector<SeenTag> find(const GreyImage& straight) const;

 private:
  struct Detector;
  TagFinderSettings settings_;
  std::unique_ptr<Detector> detector_;
};

}  // namespace prosector
