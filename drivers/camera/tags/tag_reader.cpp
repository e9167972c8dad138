#include "drivers/camera/tags/tag_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double beyond = 1;              // margin around a tag's last position, as a factor of its side
constexpr double most_region = 0.4;       // largest share of an image that is searched thoroughly each time
constexpr double shape_tolerance = 0.01;  // relative tolerance of the image's aspect ratio

double seconds_from(std::int64_t earlier_ns, std::int64_t later_ns) {
  return static_cast<double>(later_ns - earlier_ns) * 1e-9;
}

double side_of(const DetectedTag& tag) {
  return (tag.corners[1] - tag.corners[0]).norm();
}

/// Reports whether `others` contains a tag with the same code at about the same position.
bool is_among(const DetectedTag& tag, const std::vector<DetectedTag>& others) {
  return std::any_of(others.begin(), others.end(), [&](const DetectedTag& other) {
    return other.code == tag.code && (other.corners[0] - tag.corners[0]).norm() < side_of(tag) / 2;
  });
}

/// Adds tags that aren't yet in the list, and sorts it by code.
void add_new(std::vector<DetectedTag>& tags, const std::vector<DetectedTag>& found) {
  for (const DetectedTag& tag : found)
    if (!is_among(tag, tags)) tags.push_back(tag);
  std::stable_sort(tags.begin(), tags.end(),
                   [](const DetectedTag& a, const DetectedTag& b) { return a.code < b.code; });
}

/// A rectangle of pixels.
struct Region {
  int left = 0, top = 0, width = 0, height = 0;
};

Region around(const std::vector<DetectedTag>& tags, const GreyImage& image) {
  Eigen::AlignedBox2d box;
  for (const DetectedTag& tag : tags)
    for (const Vec2& corner : tag.corners)
      for (const double reach : {-beyond, beyond}) box.extend(corner + Vec2::Constant(reach * side_of(tag)));
  const auto bounded = [](double at, int most) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(most)));
  };
  Region out{bounded(box.min().x(), image.width), bounded(box.min().y(), image.height), 0, 0};
  out.width = bounded(box.max().x(), image.width) - out.left;
  out.height = bounded(box.max().y(), image.height) - out.top;
  return out;
}

GreyImage cut_out(const GreyImage& image, const Region& region) {
  GreyImage out{region.width, region.height, {}};
  out.grey.reserve(static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height));
  for (int y = region.top; y < region.top + region.height; ++y) {
    const auto row = image.grey.begin() + static_cast<std::ptrdiff_t>(y) * image.width + region.left;
    out.grey.insert(out.grey.end(), row, row + region.width);
  }
  return out;
}

}  // namespace

TagReader::TagReader(std::optional<CameraCalibration> calibration)
    : is_calibrated_(calibration.has_value()), calibration_(std::move(calibration)) {}

TagReader::TagReader(const std::filesystem::path& lens)
    : TagReader(lens.empty() ? std::nullopt : std::optional(load_calibration(lens))) {}

void TagReader::begin(const Camera& camera) {
  number_.reset();
  if (is_calibrated_) return;
  const auto lens = camera.lens();
  const std::optional<Lens> before = calibration_ ? std::optional(calibration_->lens) : std::nullopt;
  if (lens != before) width_ = height_ = 0;
  calibration_.reset();
  if (lens) calibration_ = CameraCalibration{camera.identity(), *lens, camera.response(), 0};
}

void TagReader::make_ready(int width, int height) {
  if (width_ == width && height_ == height) return;
  const CameraCalibration known = calibration_.value_or(guessed_calibration(width, height));
  const double stretch =
      static_cast<double>(width) * known.lens.height / (static_cast<double>(height) * known.lens.width);
  if (std::abs(stretch - 1) > shape_tolerance)
    throw InputError(
        fmt::format("the camera's images have {} × {} pixels, but it was calibrated with {} × {}: calibrate "
                    "it again, or set it to that size",
                    width, height, known.lens.width, known.lens.height));
  optics_.bent = known.lens.scaled(width, height);
  optics_.response = known.response;
  straightener_ = std::make_unique<Undistorter>(optics_.bent);
  optics_.straight = straightener_->lens();
  width_ = width;
  height_ = height;
  ++changes_;
}

const TagImage& TagReader::read(const Frame& frame) {
  if (number_ == frame.number) return picture_;
  number_.reset();
  make_ready(frame.image.width, frame.image.height);
  picture_.bent = grey_of(frame.image);
  picture_.straight = straightener_->straight(picture_.bent);
  picture_.tags = finder_.find(picture_.straight);
  picture_.time_ns = frame.time_ns;
  find_missing_tags(picture_);
  number_ = frame.number;
  return picture_;
}

void TagReader::expect(const Board& board) {
  for (const BoardTag& tag : board.tags) expected_.insert(tag.code);
}

/// Finds tags that the quick search misses: distant tags with small cells. Recently detected tags are
/// searched near their last position, others now and then in the whole image.
void TagReader::find_missing_tags(TagImage& picture) {
  const auto is_read = [&](int code) {
    return std::any_of(picture.tags.begin(), picture.tags.end(),
                       [&](const DetectedTag& tag) { return tag.code == code; });
  };
  std::erase_if(recent_tags_, [&](const Lately& one) {
    const double age = seconds_from(one.time_ns, picture.time_ns);
    return age < 0 || age > remembered || is_read(one.tag.code);
  });
  std::vector<DetectedTag> missing;
  for (const Lately& one : recent_tags_) missing.push_back(one.tag);
  const auto is_known = [&](int code) {
    return is_read(code) || std::any_of(missing.begin(), missing.end(),
                                        [&](const DetectedTag& tag) { return tag.code == code; });
  };
  const bool is_due =
      !thorough_ns_ || std::abs(seconds_from(*thorough_ns_, picture.time_ns)) > thorough_interval;
  if (is_due && !std::all_of(expected_.begin(), expected_.end(), is_known)) {
    thorough_ns_ = picture.time_ns;
    add_new(picture.tags, thorough_finder_.find(picture.straight));
  } else if (!missing.empty()) {
    const Region region = around(missing, picture.straight);
    if (region.width * region.height < most_region * picture.straight.width * picture.straight.height) {
      std::vector<DetectedTag> found = thorough_finder_.find(cut_out(picture.straight, region));
      for (DetectedTag& tag : found)
        for (Vec2& corner : tag.corners) corner += Vec2(region.left, region.top);
      add_new(picture.tags, found);
    }
  }
  for (const DetectedTag& tag : picture.tags) {
    std::erase_if(recent_tags_, [&](const Lately& one) { return one.tag.code == tag.code; });
    recent_tags_.push_back({tag, picture.time_ns});
  }
}

}  // namespace prosector
