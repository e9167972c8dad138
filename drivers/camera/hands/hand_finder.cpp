#include "drivers/camera/hands/hand_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drivers/camera/nets/net_file.h"

namespace prosector {
namespace {

constexpr std::size_t most_hands = 2;
constexpr double present = 0.5, still_present = 0.25;  // least presence to detect a hand, and to follow it
constexpr std::uint64_t second_hand_interval = 10;     // images between searches for a second hand
constexpr std::uint64_t nearer_hand_interval =
    30;                         // images between searches for a nearer hand while two are followed
constexpr double nearer = 1.4;  // size ratio above which a new hand replaces a followed one
constexpr double stays = 0.85;  // factor of the least length; a followed hand shorter than this is dropped
constexpr double same_hand = 0.35;  // share of a region's side; regions nearer than this belong to one hand
constexpr double most_votes = 6;  // limit of the votes: about this many images overturn the clearest majority
constexpr double least_side = 8;  // pixels; a smaller region is no hand

const char* suffix(HandNets nets) {
  return nets == HandNets::lite ? "lite" : "full";
}

bool can_be_a_hand(const Image& image, const ImageRegion& region) {
  return std::isfinite(region.side) && region.center.allFinite() && region.side > least_side &&
         region.side < 4 * std::max(image.width, image.height);
}

}  // namespace

HandFinder::HandFinder(const std::filesystem::path& folder, HandNets nets)
    : palms_(load_fetched_net(folder, fmt::format("palm_{}.tflite", suffix(nets)), "bare hands")),
      landmarks_(
          load_fetched_net(folder, fmt::format("hand_landmark_{}.tflite", suffix(nets)), "bare hands")) {}

void HandFinder::forget() {
  followed_.clear();
}

/// Searches for a hand in its region. Returns whether it was found.
bool HandFinder::follow(const Image& image, Followed& followed) {
  if (!can_be_a_hand(image, followed.region)) return false;
  const LandmarkAnswer answer = landmarks_.look(image, followed.region);
  if (!(answer.presence >= (followed.hand.presence > 0 ? still_present : present))) return false;
  for (const Vec2& x : answer.points)
    if (!x.allFinite()) return false;
  const bool is_followed = followed.hand.presence > 0;
  if (length_of_hand(answer.points) < (is_followed ? stays : 1) * least_length_) {
    saw_far_hand_ = true;
    return false;
  }
  followed.votes = std::clamp(followed.votes + 2 * answer.right - 1, -most_votes, most_votes);
  followed.region = region_around(answer.points);
  followed.hand.points = answer.points;
  followed.hand.depths = answer.depths;
  followed.hand.presence = answer.presence;
  return true;
}

/// Drops the hand with the lower presence if two followed hands are the same one.
void HandFinder::drop_duplicates() {
  if (followed_.size() < 2) return;
  const ImageRegion &a = followed_[0].region, &b = followed_[1].region;
  if ((a.center - b.center).norm() > same_hand * std::min(a.side, b.side)) return;
  followed_.erase(followed_.begin() + (followed_[0].hand.presence < followed_[1].hand.presence ? 0 : 1));
}

void HandFinder::detect_new_hands(const Image& image) {
  ++palm_runs_;
  std::vector<ImageRegion> palms = palms_.find(image);
  std::stable_sort(palms.begin(), palms.end(),
                   [](const ImageRegion& a, const ImageRegion& b) { return a.side > b.side; });
  for (const ImageRegion& palm : palms) {
    const bool known = std::any_of(followed_.begin(), followed_.end(), [&](const Followed& f) {
      return (f.region.center - palm.center).norm() < same_hand * std::max(f.region.side, palm.side);
    });
    Followed fresh{palm, 0, {}};
    if (known || !follow(image, fresh)) continue;
    follow(image, fresh);  // second run, because the palm's square is only rough
    take(fresh);
  }
}

/// Starts to follow a hand, in addition to others, or instead of the smallest if the new one is much larger.
void HandFinder::take(const Followed& fresh) {
  const auto smallest =
      std::min_element(followed_.begin(), followed_.end(),
                       [](const Followed& a, const Followed& b) { return a.region.side < b.region.side; });
  if (followed_.size() == most_hands) {
    if (fresh.region.side < nearer * smallest->region.side) return;
    followed_.erase(smallest);
  }
  followed_.push_back(fresh);
  followed_.back().hand.number = next_number_++;
}

/// Sets each hand's side by majority vote. Two hands get different sides.
void HandFinder::assign_sides() {
  for (Followed& f : followed_) f.hand.left = f.votes < 0;
  if (followed_.size() == 2 && followed_[0].hand.left == followed_[1].hand.left) {
    Followed& weaker =
        std::abs(followed_[0].votes) < std::abs(followed_[1].votes) ? followed_[0] : followed_[1];
    weaker.hand.left = !weaker.hand.left;
  }
}

const std::vector<DetectedHand>& HandFinder::find(const Image& image) {
  hands_.clear();
  saw_far_hand_ = false;
  if (!is_whole(image)) return hands_;
  std::erase_if(followed_, [&](Followed& f) {
    if (!follow(image, f)) return true;
    ++f.hand.follows;
    return false;
  });
  drop_duplicates();
  const std::uint64_t pause = followed_.size() < most_hands ? second_hand_interval : nearer_hand_interval;
  if (followed_.empty() || pictures_ % pause == 0) detect_new_hands(image);
  ++pictures_;
  assign_sides();
  for (const Followed& f : followed_) hands_.push_back(f.hand);
  return hands_;
}

}  // namespace prosector
