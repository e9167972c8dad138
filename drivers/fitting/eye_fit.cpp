#include "drivers/fitting/eye_fit.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

using Projection = Eigen::Matrix<double, 3, 4>;

/// Returns the transformation to mean 0 and RMS distance √dimension.
template <int N>
Eigen::Matrix<double, N + 1, N + 1> normaliser(const Eigen::Matrix<double, N, Eigen::Dynamic>& points) {
  const Eigen::Matrix<double, N, 1> mean = points.rowwise().mean();
  const double rms = std::sqrt((points.colwise() - mean).squaredNorm() / static_cast<double>(points.cols()));
  const double scale = std::sqrt(static_cast<double>(N)) / rms;
  Eigen::Matrix<double, N + 1, N + 1> out = Eigen::Matrix<double, N + 1, N + 1>::Identity();
  out.template topLeftCorner<N, N>() *= scale;
  out.template topRightCorner<N, 1>() = -scale * mean;
  return out;
}

/// Solves for the projection matrix up to scale.
Projection solve_projection(std::span<const SeenPoint> seen) {
  const auto n = static_cast<Eigen::Index>(seen.size());
  Eigen::Matrix3Xd points(3, n);
  Eigen::Matrix2Xd pixels(2, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    points.col(i) = seen[static_cast<std::size_t>(i)].point;
    pixels.col(i) = seen[static_cast<std::size_t>(i)].pixel;
  }
  const Eigen::Matrix4d of_points = normaliser<3>(points);
  const Mat3 of_pixels = normaliser<2>(pixels);
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(2 * n, 12);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::RowVector4d x = (of_points * points.col(i).homogeneous()).transpose();
    const Vec3 u = of_pixels * pixels.col(i).homogeneous();
    m.block<1, 4>(2 * i, 0) = x;
    m.block<1, 4>(2 * i, 8) = -u.x() * x;
    m.block<1, 4>(2 * i + 1, 4) = x;
    m.block<1, 4>(2 * i + 1, 8) = -u.y() * x;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(m, Eigen::ComputeThinV);
  constexpr double least_ratio = 1e-3;
  if (svd.singularValues()[10] < least_ratio * svd.singularValues()[0])
    throw InputError(
        "the marked points are nearly in one plane or at one distance: take some near and some far, over the "
        "whole image");
  const VecX v = svd.matrixV().col(11);
  Projection p;
  p << v.segment<4>(0).transpose(), v.segment<4>(4).transpose(), v.segment<4>(8).transpose();
  return of_pixels.inverse() * p * of_points;
}

/// Decomposes M into an upper triangular K with positive diagonal and a rotation R.
void split(const Mat3& m, Mat3& k, Mat3& r) {
  Mat3 flip = Mat3::Zero();
  flip(0, 2) = flip(1, 1) = flip(2, 0) = 1;
  const Eigen::HouseholderQR<Mat3> qr((flip * m).transpose());
  const Mat3 q = qr.householderQ();
  const Mat3 upper = qr.matrixQR().triangularView<Eigen::Upper>();
  k = flip * upper.transpose() * flip;
  r = flip * q.transpose();
  for (int i = 0; i < 3; ++i)
    if (k(i, i) < 0) {
      k.col(i) = -k.col(i);
      r.row(i) = -r.row(i);
    }
}

}  // namespace

EyeDistance eye_distance_by_sighting(double marks_apart, double screen, double rod, double mark_error,
                                     double length_error) {
  if (!(rod > 0 && screen > rod)) throw InputError("the rod must be between the eyes and the screen");
  const double ratio = rod / (screen - rod);
  const double e = marks_apart * ratio;
  if (!(e >= least_eye_distance && e <= most_eye_distance))
    throw InputError(fmt::format(
        "the result is {:.0f} mm between the eyes; usual are {:.0f} to {:.0f} mm: repeat the measurements",
        1e3 * e, 1e3 * least_eye_distance, 1e3 * most_eye_distance));
  const double by_screen = e / (screen - rod), by_rod = e * (1 / rod + 1 / (screen - rod));
  return {e, std::sqrt(std::pow(ratio * mark_error, 2) + std::pow(by_screen * length_error, 2) +
                       std::pow(by_rod * length_error, 2))};
}

double pixel_size_from_card(double card_pixels) {
  constexpr double finest = 2e-5, coarsest = 2e-3;  // m per pixel: a phone's screen, an LED wall
  const double pixel = card_width / card_pixels;
  if (!(pixel >= finest && pixel <= coarsest))
    throw InputError(
        fmt::format("a card of {} pixels is not plausible for any screen: hold it to the screen and drag "
                    "both marks to its ends",
                    card_pixels));
  return pixel;
}

double EyeFit::fov_horizontal() const {
  return std::atan(right) - std::atan(left);
}

double EyeFit::fov_vertical() const {
  return std::atan(top) - std::atan(bottom);
}

EyeFit fit_eye(std::span<const SeenPoint> seen, int width, int height) {
  if (seen.size() < min_seen_points)
    throw InputError(fmt::format("{} points were measured for an eye: at least {} are needed, 20 are better",
                                 seen.size(), min_seen_points));
  EyeFit fit;
  fit.projection = solve_projection(seen);
  double ahead = 0;
  for (const SeenPoint& s : seen) ahead += fit.projection.row(2).dot(s.point.homogeneous()) > 0 ? 1 : -1;
  if (ahead < 0) fit.projection = -fit.projection;
  Mat3 m = fit.projection.leftCols<3>();
  if (m.determinant() < 0)
    throw InputError(
        "the points are mirrored: their pixels must be counted from the upper left corner of the image");
  Mat3 k, r;
  split(m, k, r);
  fit.projection /= k(2, 2);
  k /= k(2, 2);
  // The camera of K faces +z with y down; ours faces −z with y up.
  const Mat3 ours = r.transpose() * Vec3(1, -1, -1).asDiagonal();
  fit.eye = {-fit.projection.leftCols<3>().inverse() * fit.projection.col(3), Quat(ours).normalized()};
  fit.left = -k(0, 2) / k(0, 0);
  fit.right = (width - k(0, 2)) / k(0, 0);
  fit.top = k(1, 2) / k(1, 1);
  fit.bottom = -(height - k(1, 2)) / k(1, 1);
  double squares = 0;
  for (const SeenPoint& s : seen)
    squares += ((fit.projection * s.point.homogeneous()).hnormalized() - s.pixel).squaredNorm();
  fit.residual = std::sqrt(squares / static_cast<double>(seen.size()));
  return fit;
}

EyesFit join_eyes(const EyeFit& left, const EyeFit& right) {
  EyesFit out;
  const Vec3 across = right.eye.p - left.eye.p;
  out.distance = across.norm();
  // Eyes are drawn with fields of view symmetric about their own axis (client/view/camera.h).
  const auto full = [](double a, double b) { return 2 * std::atan((b - a) / 2); };
  out.fov_horizontal = (full(left.left, left.right) + full(right.left, right.right)) / 2;
  out.fov_vertical = (full(left.bottom, left.top) + full(right.bottom, right.top)) / 2;
  // Images that coincide at distance D are shifted by e/(2D) each, the left one to the right.
  const double shift = ((left.left + left.right) - (right.left + right.right)) / 4;
  constexpr double least_shift = 1e-3;
  out.convergence = shift > least_shift ? out.distance / (2 * shift) : 0;
  out.head = {(left.eye.p + right.eye.p) / 2, left.eye.q.slerp(0.5, right.eye.q)};
  return out;
}

}  // namespace prosector
