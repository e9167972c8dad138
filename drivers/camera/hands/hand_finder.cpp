#include "drivers/camera/hands/hand_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "drivers/camera/hands/net_file.h"

namespace prosector {
namespace {

constexpr std::size_t most_hands = 2;
constexpr double present = 0.5, still_present = 0.25;  // to be found, and to be followed on
constexpr std::uint64_t look_again = 10;               // pictures: so often a second hand is looked for
constexpr double same_hand = 0.35;  // of a region's side: two regions nearer than this are of one hand
constexpr double most_votes = 6;    // so many pictures turn the surest vote
constexpr double least_side = 8;    // pixels: nothing smaller is a hand

NetPlan load_hand_net(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path file = folder / name;
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw InputError(fmt::format("bare hands need '{}': run deploy/fetch_models.sh", file.string()));
  return load_net(file);
}

const char* suffix(HandNets nets) {
  return nets == HandNets::lite ? "lite" : "full";
}

bool can_be_a_hand(const Image& image, const PictureRegion& region) {
  return std::isfinite(region.side) && region.center.allFinite() && region.side > least_side &&
         region.side < 4 * std::max(image.width, image.height);
}

}  // namespace

HandFinder::HandFinder(const std::filesystem::path& folder, HandNets nets)
    : palms_(load_hand_net(folder, fmt::format("palm_{}.tflite", suffix(nets)))),
      landmarks_(load_hand_net(folder, fmt::format("hand_landmark_{}.tflite", suffix(nets)))) {}

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
  followed.votes = std::clamp(followed.votes + 2 * answer.right - 1, -most_votes, most_votes);
  followed.region = region_around(answer.points);
  followed.hand.points = answer.points;
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
  for (const FoundPalm& palm : palms_.find(image)) {
    if (followed_.size() == most_hands) return;
    const bool known = std::any_of(followed_.begin(), followed_.end(), [&](const Followed& f) {
      return (f.region.center - palm.region.center).norm() <
             same_hand * std::max(f.region.side, palm.region.side);
    });
    Followed fresh{palm.region, 0, {}};
    if (known || !follow(image, fresh)) continue;
    follow(image, fresh);  // the palm's square is rough: look again where the hand is
    fresh.hand.number = next_number_++;
    followed_.push_back(fresh);
  }
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
  const auto bytes = 3 * static_cast<std::size_t>(std::max(image.width, 0)) *
                     static_cast<std::size_t>(std::max(image.height, 0));
  if (bytes == 0 || image.rgb.size() < bytes) return hands_;
  std::erase_if(followed_, [&](Followed& f) {
    if (!follow(image, f)) return true;
    ++f.hand.follows;
    return false;
  });
  drop_doubles();
  if (followed_.empty() || (followed_.size() < most_hands && pictures_ % look_again == 0))
    look_for_more(image);
  ++pictures_;
  tell_sides();
  for (const Followed& f : followed_) hands_.push_back(f.hand);
  return hands_;
}

}  // namespace prosector
