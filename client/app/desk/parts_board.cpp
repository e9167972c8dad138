#include "client/app/desk/parts_board.h"

#include <cmath>
#include <utility>

#include "common/index_tip.h"

namespace prosector {
namespace {

constexpr double ahead = 0.42, aside = 0.19, below = 0.12;  // m from the eyes to the board's centre
constexpr double stretched = 0.5;           // flexion below which an index finger operates the board
constexpr std::size_t index_finger = 1;     // index in a hand's flexions
constexpr double points_per_line = 20;      // finger motion that scrolls by a line
const Eigen::Vector2d nowhere(-1e4, -1e4);  // points

/// Returns the pose of a new board: facing the eyes, to their right or left.
Pose place_board(const Pose& eyes, bool right) {
  const Vec3 look = eyes.q * -Vec3::UnitZ();
  Vec3 level = Vec3(look.x(), 0, look.z());
  level = level.norm() > 1e-3 ? Vec3(level.normalized()) : Vec3(eyes.q * Vec3::UnitY());
  level = Vec3(level.x(), 0, level.z()).normalized();
  if (!level.allFinite()) level = -Vec3::UnitZ();
  const Vec3 to_right = level.cross(Vec3::UnitY());
  const Vec3 middle = eyes.p + ahead * level + (right ? aside : -aside) * to_right - below * Vec3::UnitY();
  Mat3 axes;
  axes.col(2) = (eyes.p - middle).normalized();
  axes.col(0) = Vec3::UnitY().cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return {middle, Quat(axes).normalized()};
}

}  // namespace

void PartsBoard::toggle_open(const Pose& eyes, std::size_t hand) {
  desk_.toggle_without_search();
  worker_.reset();
  heights_ = {};
  if (is_open()) pose_ = place_board(eyes, hand == left_hand);
}

std::optional<PlacedPartsList> PartsBoard::shown() const {
  if (desk_.shown() == nullptr) return std::nullopt;
  return PlacedPartsList{desk_.shown(), pose_};
}

void PartsBoard::follow(std::vector<PartRow> rows, const HandInput& user) {
  if (!is_open()) return;
  desk_.lay_out(std::move(rows), std::nullopt, parts_board_picture);
  bool at_board = false;
  for (std::size_t hand = 0; hand < heights_.size(); ++hand) {
    const HandPose& pose = user.hands[hand];
    const Vec3 tip = pose_.inverse() * index_tip(hand, pose);
    const bool points = pose.tracked && pose.flexion[index_finger] < stretched && tip.allFinite();
    const bool is_at = points && tip.z() < felt_within && tip.z() > -felt_behind &&
                       desk_.shown()->board.contains(board_point(tip));
    if (is_at && (!worker_ || worker_ == hand) && !at_board) {
      work(hand, tip);
      at_board = true;
    } else if (worker_ == hand) {
      let_go();
    }
    heights_[hand] = is_at ? std::optional(tip.z()) : std::nullopt;
  }
  if (!at_board) desk_.take(MouseMoved{}, nowhere);
}

/// Processes a tip at the board: points, presses and releases. A tip that comes from behind presses nothing.
void PartsBoard::work(std::size_t hand, const Vec3& tip) {
  const Eigen::Vector2d point = board_point(tip);
  desk_.take(MouseMoved{}, point);
  const bool from_before = heights_[hand] && *heights_[hand] > press_distance;
  if (!worker_ && from_before && tip.z() <= press_distance) {
    worker_ = hand;
    press(point);
  } else if (worker_ && tip.z() > release_distance) {
    let_go();
  } else if (worker_ && scrolls_) {
    scroll(point);
  }
}

void PartsBoard::press(const Eigen::Vector2d& point) {
  using Kind = PartsSpot::Kind;
  const auto spot = spot_at(*desk_.shown(), point);
  scrolls_ = spot && (spot->kind == Kind::name || spot->kind == Kind::board);
  scrolled_from_ = point.y();
  if (!scrolls_ && spot && spot->kind != Kind::search)
    desk_.take(MouseButtonEvent{MouseButton::left, true}, point);
}

/// Scrolls the names by whole lines with the finger.
void PartsBoard::scroll(const Eigen::Vector2d& point) {
  const double lines = std::trunc((scrolled_from_ - point.y()) / points_per_line);
  if (lines == 0) return;
  scrolled_from_ -= points_per_line * lines;
  desk_.scroll(lines);
}

void PartsBoard::let_go() {
  worker_.reset();
  desk_.take(MouseButtonEvent{MouseButton::left, false}, nowhere);
}

}  // namespace prosector
