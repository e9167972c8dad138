#pragma once
// Finds up to two bare hands in successive images: detects them in the whole image, then follows them. The
// nearest hands are taken. Hands beyond a distance limit are ignored, because they are bystanders'.

#include <filesystem>
#include <vector>

#include "drivers/camera/hands/hand_landmarks.h"
#include "drivers/camera/hands/palm_detector.h"
#include "drivers/camera/nets/hand_nets.h"

namespace prosector {

struct DetectedHand {
  HandPoints points;          // pixels of the image
  HandDepths depths{};        // pixels
  double presence = 0;        // 0 to 1
  bool left = false;          // majority vote over all images in which the hand was followed
  std::uint64_t follows = 0;  // number of earlier images in which the hand was followed
  std::uint64_t number = 0;   // identifier, constant while the hand is followed
};

class HandFinder {
 public:
  /// Loads the files of the hand networks from `folder`. `nets` selects the accurate or the fast ones. Throws
  /// InputError with advice on how to get the files.
  HandFinder(const std::filesystem::path& folder, HandNets nets);

  /// Finds up to two hands in the next image of the camera. Returns none for an unusable image; never throws.
  const std::vector<DetectedHand>& find(const Image& image);
  /// Sets the least length of a hand in the image, pixels. Shorter hands are too far away and are ignored. A
  /// hand that is already followed is kept down to 85 % of this length. The default is 0.
  void set_least_length(double pixels) { least_length_ = pixels; }
  /// Returns whether a hand in the last image was ignored because it is shorter than the least length, so
  /// that it counts as too far away.
  bool ignored_far_hand() const { return saw_far_hand_; }
  /// Stops following all hands, so that they are searched for in the whole image again. Call it before an
  /// image that does not continue the previous ones.
  void forget();
  /// Returns the number of times that the palm detector, a search of the whole image, has run.
  std::uint64_t palm_runs() const { return palm_runs_; }

 private:
  struct Followed {
    ImageRegion region;  // where to search in the next image
    double votes = 0;    // above 0: votes for a right hand; below 0: for a left hand
    DetectedHand hand;
  };
  bool follow(const Image& image, Followed& followed);
  void drop_duplicates();
  void detect_new_hands(const Image& image);
  void take(const Followed& fresh);
  void assign_sides();

  PalmDetector palms_;
  LandmarkNetwork landmarks_;
  std::vector<Followed> followed_;
  std::vector<DetectedHand> hands_;
  double least_length_ = 0;
  bool saw_far_hand_ = false;
  std::uint64_t pictures_ = 0, palm_runs_ = 0, next_number_ = 0;
};

}  // namespace prosector
