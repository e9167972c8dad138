#include "drivers/camera/tags/tag_detector.h"

extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
}

#include <algorithm>
#include <cstdlib>

#include "drivers/camera/tags/board.h"

namespace prosector {
namespace {

constexpr double least_margin = 20;
constexpr double pixel_centre = 0.5;  // centre of libapriltag's first pixel; ours is at 0

}  // namespace

struct TagDetector::Detector {
  apriltag_family_t* family = tag36h11_create();
  apriltag_detector_t* detector = apriltag_detector_create();

  Detector() = default;
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;
  ~Detector() {
    apriltag_detector_destroy(detector);
    tag36h11_destroy(family);
  }
};

TagDetector::TagDetector(const TagDetectorSettings& settings)
    : settings_(settings), detector_(std::make_unique<Detector>()) {
  apriltag_detector_add_family_bits(detector_->detector, detector_->family, 1);
  detector_->detector->nthreads = 1;
  detector_->detector->refine_edges = true;
}

TagDetector::~TagDetector() = default;

std::vector<DetectedTag> TagDetector::find(const GreyImage& straight) const {
  constexpr int least_side = 8;  // pixels; libapriltag divides images into tiles
  if (straight.width < least_side || straight.height < least_side) return {};
  const bool is_small = straight.width <= undecimated_pixels / straight.height;
  detector_->detector->quad_decimate = is_small ? 1.0F : static_cast<float>(settings_.decimate);
  // libapriltag doesn't write to the image.
  image_u8_t image{straight.width, straight.height, straight.width,
                   const_cast<std::uint8_t*>(straight.grey.data())};
  zarray_t* found = apriltag_detector_detect(detector_->detector, &image);
  std::vector<DetectedTag> out;
  for (int k = 0; k < zarray_size(found); ++k) {
    const apriltag_detection_t* one = nullptr;
    zarray_get(found, k, &one);
    if (one->decision_margin < least_margin) continue;
    DetectedTag tag{one->id, {}, one->decision_margin};
    for (std::size_t c = 0; c < tag.corners.size(); ++c)
      tag.corners[c] = {one->p[c][0] - pixel_centre, one->p[c][1] - pixel_centre};
    out.push_back(tag);
  }
  apriltag_detections_destroy(found);
  std::stable_sort(out.begin(), out.end(),
                   [](const DetectedTag& a, const DetectedTag& b) { return a.code < b.code; });
  return out;
}

std::array<std::array<bool, tag_cells>, tag_cells> tag_ink(int code) {
  apriltag_family_t* family = tag36h11_create();
  image_u8_t* image = apriltag_to_image(family, static_cast<std::uint32_t>(code));
  std::array<std::array<bool, tag_cells>, tag_cells> ink{};
  for (std::size_t y = 0; y < tag_cells; ++y)
    for (std::size_t x = 0; x < tag_cells; ++x)
      ink[y][x] = image->buf[y * static_cast<std::size_t>(image->stride) + x] == 0;
  std::free(image->buf);  // same as image_u8_destroy(), which the library doesn't export
  std::free(image);
  tag36h11_destroy(family);
  return ink;
}

}  // namespace prosector
