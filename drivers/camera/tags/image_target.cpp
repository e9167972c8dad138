#include "drivers/camera/tags/image_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "common/error.h"
#include "drivers/camera/base/with_cv.h"
#include "drivers/camera/tags/flow.h"

namespace prosector {
namespace {

constexpr std::array<int, 4> described_sides = {640, 400, 250, 160};  // pixels, longer side of each scale
constexpr int most_features = 500;                                    // per scale
constexpr int most_seen_features = 1000;                              // in a camera image
constexpr int tried_side = 320;     // pixels, longer side of the test image in which the print must be found
constexpr double tried_blur = 0.8;  // pixels
constexpr std::size_t min_own_features = 40;  // least number of features found in the test image
constexpr std::size_t least_found = 12;       // least number of features to accept a detection
constexpr double ratio = 0.8;  // largest ratio of the distances to the best and the second-best descriptor
constexpr int neighbours = 4;  // nearest descriptors compared per feature
constexpr double same_feature_distance = 0.02;  // share of the longer side; nearer features count as the same
constexpr double plane_px = 3;                  // pixels, tolerance of the homography for features
constexpr double flow_plane_px = 1.5;           // pixels, tolerance of the homography for tracked points
constexpr int most_places = 120;                // limit on tracked points
constexpr double least_corner = 0.01;           // corner quality relative to the strongest corner
constexpr double least_apart_px = 5;
constexpr int rim_px = 6;      // pixels, margin of the print without tracked points
constexpr int beyond_px = 32;  // pixels, margin around the print that flow may reach
constexpr std::size_t least_followed = 16;
constexpr double least_followed_share = 0.25;
constexpr double least_scatter = 3;  // grey values: least standard deviation of the print's image
constexpr double repeat_motion_px =
    1;  // pixels, mean motion above which tracking is repeated at the new pose
constexpr int most_looks = 2;
constexpr double nearest = 0.02;  // m

cv::Ptr<cv::SIFT> finder_of(int most) {
  return cv::SIFT::create(most);
}

cv::Mat shrunk(const cv::Mat& image, int side) {
  const double scale = std::min(1.0, static_cast<double>(side) / std::max(image.cols, image.rows));
  cv::Mat out;
  // Sets the size instead of the scale, so that the borders of both images coincide.
  cv::resize(image, out, {std::max(1, cvRound(scale * image.cols)), std::max(1, cvRound(scale * image.rows))},
             0, 0, cv::INTER_AREA);
  return out;
}

/// Returns the points that fit one homography, with their pixels; none if they are too few.
std::vector<DetectedCorner> on_one_plane(const std::vector<cv::Point2d>& places,
                                         const std::vector<cv::Point2d>& pixels, double most_off_px,
                                         std::size_t least) {
  if (places.size() < least) return {};
  std::vector<std::uint8_t> fits;
  if (cv::findHomography(places, pixels, cv::RANSAC, most_off_px, fits).empty()) return {};
  std::vector<DetectedCorner> out;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (fits[i] != 0) out.push_back({{places[i].x, places[i].y, 0}, {pixels[i].x, pixels[i].y}});
  if (out.size() < least) out.clear();
  return out;
}

}  // namespace

/// The print at one resolution.
struct ImageTarget::Level {
  cv::Mat grey;
  double width = 0, height = 0;  // m, size of the print

  double metres() const { return width / grey.cols; }  // size of a pixel
  Vec3 place(const cv::Point2f& pixel) const {
    return {((pixel.x + 0.5) / grey.cols - 0.5) * width, (0.5 - (pixel.y + 0.5) / grey.rows) * height, 0};
  }
  /// Returns the homography from this level's pixels to the camera's.
  Mat3 map(const Lens& lens, const Pose& camera_board) const {
    Mat3 pinhole, to_plane;
    pinhole << lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1;
    const double x = width / grey.cols, y = height / grey.rows;
    to_plane << x, 0, 0.5 * x - 0.5 * width, 0, -y, 0.5 * height - 0.5 * y, 0, 0, 1;
    const Mat3 turn = camera_board.q.toRotationMatrix();
    Mat3 pose;
    pose << turn.col(0), turn.col(1), camera_board.p;
    return pinhole * pose * to_plane;
  }
};

struct ImageTarget::Features {
  cv::Mat descriptions;
  std::vector<Vec3> places;
  double reach = 0;  // m; nearer features count as the same
};

ImageTarget::ImageTarget(const Board& board) : features_(std::make_unique<Features>()) {
  const PrintedImage& picture = *board.picture;
  const GreyImage grey = grey_of(picture.image);
  const cv::Mat whole = matrix_of(grey);
  const double width = picture.width, height = picture.height();
  features_->reach = same_feature_distance * std::max(width, height);
  for (const int side : described_sides) {
    const Level level{shrunk(whole, side), width, height};
    std::vector<cv::KeyPoint> points;
    cv::Mat descriptions;
    finder_of(most_features)->detectAndCompute(level.grey, cv::noArray(), points, descriptions);
    for (const cv::KeyPoint& point : points) features_->places.push_back(level.place(point.pt));
    if (!points.empty()) features_->descriptions.push_back(descriptions);
    levels_.push_back(level);
  }
  cv::Mat tried;
  cv::GaussianBlur(shrunk(whole, tried_side), tried, {}, tried_blur);
  const GreyImage seen{tried.cols, tried.rows, {tried.datastart, tried.dataend}};
  if (const std::size_t own = find(seen).size(); own < min_own_features)
    throw InputError(
        fmt::format("board {}: its picture has {} distinguishable features, but needs {}: use a picture with "
                    "detail everywhere and without repeating patterns",
                    board.name, own, min_own_features));
}

ImageTarget::~ImageTarget() = default;

std::vector<DetectedCorner> ImageTarget::find(const GreyImage& straight) const {
  std::vector<cv::KeyPoint> points;
  cv::Mat descriptions;
  finder_of(most_seen_features)->detectAndCompute(matrix_of(straight), cv::noArray(), points, descriptions);
  if (points.size() < least_found || features_->places.size() < neighbours) return {};
  std::vector<std::vector<cv::DMatch>> matches;
  cv::BFMatcher(cv::NORM_L2).knnMatch(descriptions, features_->descriptions, matches, neighbours);
  std::vector<cv::Point2d> plane, pixels;
  for (const std::vector<cv::DMatch>& match : matches) {
    const auto place = [&](const cv::DMatch& one) {
      return features_->places[static_cast<std::size_t>(one.trainIdx)];
    };
    // A point is described at several scales, so the second-best match must be at another point. Without one,
    // the last of the nearest descriptors is used.
    const auto other = std::find_if(match.begin() + 1, match.end(), [&](const cv::DMatch& one) {
      return (place(one) - place(match.front())).norm() > features_->reach;
    });
    const float bound = (other == match.end() ? match.back() : *other).distance;
    if (match.front().distance >= ratio * bound) continue;
    const Vec3 at = place(match.front());
    plane.emplace_back(at.x(), at.y());
    pixels.emplace_back(points[static_cast<std::size_t>(match.front().queryIdx)].pt);
  }
  return on_one_plane(plane, pixels, plane_px, least_found);
}

/// Rendered and actual image of the print near a predicted pose: a region of the camera's image.
struct ImageTarget::Expected {
  int left = 0, top = 0;  // upper left corner of the region
  GreyImage drawn, seen;  // rendered image; actual image
  cv::Mat inside;         // mask of the print without its margin
};

std::optional<ImageTarget::Expected> ImageTarget::expect(const GreyImage& straight, const Lens& lens,
                                                         const Pose& camera_board) const {
  const double width = levels_.front().width, height = levels_.front().height;
  std::vector<cv::Point2f> outline;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    const Vec3 corner = camera_board * Vec3(x * width, y * height, 0);
    if (corner.z() < nearest) return std::nullopt;
    const Vec2 pixel = lens.project(corner);
    outline.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  }
  if ((camera_board.q * Vec3::UnitZ()).dot(camera_board.p) >= 0) return std::nullopt;  // back side is visible
  const cv::Rect2d reach = cv::boundingRect(outline);
  const cv::Rect part = cv::Rect(cv::Rect2d(reach.x - beyond_px, reach.y - beyond_px,
                                            reach.width + 2 * beyond_px, reach.height + 2 * beyond_px) &
                                 cv::Rect2d(0, 0, straight.width, straight.height));
  if (part.width < 2 * beyond_px || part.height < 2 * beyond_px) return std::nullopt;
  // Selects the level with pixels closest in size to the camera's.
  const double metres = camera_board.p.z() / lens.fx;
  const Level& level = *std::min_element(levels_.begin(), levels_.end(), [&](const Level& a, const Level& b) {
    return std::abs(std::log(a.metres() / metres)) < std::abs(std::log(b.metres() / metres));
  });
  Mat3 to_part = Mat3::Identity();
  to_part(0, 2) = -part.x;
  to_part(1, 2) = -part.y;
  const Mat3 map = to_part * level.map(lens, camera_board);
  const cv::Matx33d map_cv(map(0, 0), map(0, 1), map(0, 2), map(1, 0), map(1, 1), map(1, 2), map(2, 0),
                           map(2, 1), map(2, 2));
  cv::Mat drawn;
  cv::warpPerspective(level.grey, drawn, map_cv, part.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  Expected out;
  out.left = part.x;
  out.top = part.y;
  out.inside = cv::Mat::zeros(part.size(), CV_8UC1);
  std::vector<cv::Point> corners;
  for (const cv::Point2f& corner : outline)
    corners.emplace_back(cvRound(corner.x) - part.x, cvRound(corner.y) - part.y);
  cv::fillConvexPoly(out.inside, corners, cv::Scalar(255));
  cv::erode(out.inside, out.inside, cv::Mat::ones(2 * rim_px + 1, 2 * rim_px + 1, CV_8UC1));
  const cv::Mat seen = matrix_of(straight)(part).clone();
  cv::Scalar drawn_mean, drawn_scatter, seen_mean, seen_scatter;
  cv::meanStdDev(drawn, drawn_mean, drawn_scatter, out.inside);
  cv::meanStdDev(seen, seen_mean, seen_scatter, out.inside);
  if (drawn_scatter[0] < least_scatter || seen_scatter[0] < least_scatter) return std::nullopt;
  // Matches mean and contrast to the camera's image, because optical flow assumes constant brightness.
  const double gain = seen_scatter[0] / drawn_scatter[0];
  drawn.convertTo(drawn, CV_8UC1, gain, seen_mean[0] - gain * drawn_mean[0]);
  out.drawn = {part.width, part.height, {drawn.datastart, drawn.dataend}};
  out.seen = {part.width, part.height, {seen.datastart, seen.dataend}};
  return out;
}

std::vector<DetectedCorner> ImageTarget::follow(const GreyImage& straight, const Lens& lens,
                                                const Pose& camera_board) const {
  Pose pose = camera_board;
  std::vector<DetectedCorner> found;
  for (int look = 0; look < most_looks; ++look) {
    const auto expected = expect(straight, lens, pose);
    if (!expected) return {};
    std::vector<cv::Point2f> corners;
    cv::goodFeaturesToTrack(matrix_of(expected->drawn), corners, most_places, least_corner, least_apart_px,
                            expected->inside);
    std::vector<Vec2> starts;
    for (const cv::Point2f& corner : corners) starts.emplace_back(corner.x, corner.y);
    const auto ends = follow_places(expected->drawn, expected->seen, starts);
    const Vec2 shift(expected->left, expected->top);
    std::vector<cv::Point2d> places, pixels;
    double moved = 0;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      if (!ends[i]) continue;
      // Intersects the start's line of sight with the print's plane.
      const Vec3 ray = pose.q.conjugate() * lens.ray(starts[i] + shift), eye = pose.inverse().p;
      const Vec3 place = eye - eye.z() / ray.z() * ray;
      places.emplace_back(place.x(), place.y());
      pixels.emplace_back(ends[i]->x() + shift.x(), ends[i]->y() + shift.y());
      moved += (*ends[i] - starts[i]).norm();
    }
    const auto share = static_cast<std::size_t>(least_followed_share * static_cast<double>(starts.size()));
    found = on_one_plane(places, pixels, flow_plane_px, std::max(least_followed, share));
    if (found.empty() || moved < repeat_motion_px * static_cast<double>(places.size())) return found;
    const auto poses = solve_board(found, lens);
    if (poses.empty()) return {};
    const auto turned = [&](const BoardPose& one) { return one.camera_board.q.angularDistance(pose.q); };
    pose = std::min_element(poses.begin(), poses.end(), [&](const BoardPose& a, const BoardPose& b) {
             return turned(a) < turned(b);
           })->camera_board;
  }
  return found;
}

}  // namespace prosector
