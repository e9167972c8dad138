#include "drivers/camera/hands/hand_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drivers/camera/hands/net_file.h"

namespace prosector {
namespace {

constexpr std::size_t most_hands = 2;
constexpr double present = 0.5, still_present = 0.25;  // to be found, and to be followed on
constexpr std::uint64_t look_again = 10;               // pictures: so often a second hand is looked for …
constexpr std::uint64_t look_for_nearer = 30;          // … and a nearer one where there are two
constexpr double nearer = 1.4;      // times as large: a hand takes the place of another one
constexpr double stays = 0.85;      // of the least length: shorter than this a hand that is followed is left
constexpr double same_hand = 0.35;  // of a region's side: two regions nearer than this are of one hand
constexpr double most_votes = 6;    // so many pictures turn the surest vote
constexpr double least_side = 8;    // pixels: nothing smaller is a hand

const char* suffix(HandNets nets) {
  return nets == HandNets::lite ? "lite" : "full";
}

bool can_be_a_hand(const Image& image, const PictureRegion& region) {
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

/// Looks where a hand should be; tells whether it is there.
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

/// Drops the less sure of two that follow one hand.
void HandFinder::drop_doubles() {
  if (followed_.size() < 2) return;
  const PictureRegion &a = followed_[0].region, &b = followed_[1].region;
  if ((a.center - b.center).norm() > same_hand * std::min(a.side, b.side)) return;
  followed_.erase(followed_.begin() + (followed_[0].hand.presence < followed_[1].hand.presence ? 0 : 1));
}

void HandFinder::look_for_more(const Image& image) {
  ++palm_runs_;
  std::vector<PictureRegion> palms = palms_.find(image);
  std::stable_sort(palms.begin(), palms.end(),
                   [](const PictureRegion& a, const PictureRegion& b) { return a.side > b.side; });
  for (const PictureRegion& palm : palms) {
    const bool known = std::any_of(followed_.begin(), followed_.end(), [&](const Followed& f) {
      return (f.region.center - palm.center).norm() < same_hand * std::max(f.region.side, palm.side);
    });
    Followed fresh{palm, 0, {}};
    if (known || !follow(image, fresh)) continue;
    follow(image, fresh);  // the palm's square is rough: look again where the hand is
    take(fresh);
  }
}

/// Follows a hand from now on: beside others, or in the place of the smallest where it is much nearer.
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

/// Gives each hand the side that more votes are for; two hands have two sides.
void HandFinder::tell_sides() {
  for (Followed& f : followed_) f.hand.left = f.votes < 0;
  if (followed_.size() == 2 && followed_[0].hand.left == followed_[1].hand.left) {
    Followed& weaker =
        std::abs(followed_[0].votes) < std::abs(followed_[1].votes) ? followed_[0] : followed_[1];
    weaker.hand.left = !weaker.hand.left;
  }
}

const std::vector<FoundHand>& HandFinder::find(const Image& image) {
  hands_.clear();
  saw_far_hand_ = false;
  if (!is_whole(image)) return hands_;
  std::erase_if(followed_, [&](Followed& f) {
    if (!follow(image, f)) return true;
    ++f.hand.follows;
    return false;
  });
  drop_doubles();
  const std::uint64_t pause = followed_.size() < most_hands ? look_again : look_for_nearer;
  if (followed_.empty() || pictures_ % pause == 0) look_for_more(image);
  ++pictures_;
  tell_sides();
  for (const Followed& f : followed_) hands_.push_back(f.hand);
  return hands_;
}

}  // namespace prosector
