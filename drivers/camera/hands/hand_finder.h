#pragma once
// Up to two bare hands in picture after picture: looked for in all of it once, then followed.

#include <filesystem>
#include <vector>

#include "drivers/camera/hands/hand_landmarks.h"
#include "drivers/camera/hands/hand_nets.h"
#include "drivers/camera/hands/palm_finder.h"

namespace prosector {

struct FoundHand {
  HandPoints points;          // pixels
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
  void tell_sides();

  PalmFinder palms_;
  LandmarkNetwork landmarks_;
  std::vector<Followed> followed_;
  std::vector<FoundHand> hands_;
  std::uint64_t pictures_ = 0, palm_runs_ = 0, next_number_ = 0;
};

}  // namespace prosector
