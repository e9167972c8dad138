#pragma once
// Up to two bare hands in picture after picture: looked for in all of it once, then followed. The nearest
// ones are taken, and none that are too far away: these are bystanders'.

#include <filesystem>
#include <vector>

#include "drivers/camera/hands/hand_landmarks.h"
#include "drivers/camera/hands/hand_nets.h"
#include "drivers/camera/hands/palm_finder.h"

namespace prosector {

struct FoundHand {
  HandPoints points;          // pixels
  HandDepths depths{};        // pixels
  double presence = 0;        // 0 to 1
  bool left = false;          // by the vote of all pictures that it was followed through
  std::uint64_t follows = 0;  // pictures before this one through which it was followed
  std::uint64_t number = 0;   // the same while it is followed
};

class HandFinder {
 public:
  /// Takes the networks' files from this folder. Throws InputError that says how to get them.
  HandFinder(const std::filesystem::path& folder, HandNets nets);

  /// Looks at the next picture. Throws nothing, whatever the picture.
  const std::vector<FoundHand>& find(const Image& image);
  /// Leaves out hands that look shorter, pixels: they are too far away. At first none are left out.
  void set_least_length(double pixels) { least_length_ = pixels; }
  /// Returns whether a hand was left out of the last picture.
  bool saw_far_hand() const { return saw_far_hand_; }
  /// Forgets whom it follows: the next picture is of something else.
  void forget();
  /// Returns how often it looked for palms.
  std::uint64_t palm_runs() const { return palm_runs_; }

 private:
  struct Followed {
    PictureRegion region;  // where to look next
    double votes = 0;      // for right; against below 0
    FoundHand hand;
  };
  bool follow(const Image& image, Followed& followed);
  void drop_doubles();
  void look_for_more(const Image& image);
  void take(const Followed& fresh);
  void tell_sides();

  PalmFinder palms_;
  LandmarkNetwork landmarks_;
  std::vector<Followed> followed_;
  std::vector<FoundHand> hands_;
  double least_length_ = 0;
  bool saw_far_hand_ = false;
  std::uint64_t pictures_ = 0, palm_runs_ = 0, next_number_ = 0;
};

}  // namespace prosector
