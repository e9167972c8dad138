#pragma once
// What finding bare hands gets wrong on pictures of our own hand, and how long it takes.

#include <filesystem>
#include <map>
#include <vector>

#include "common/hand_pose.h"
#include "drivers/camera/hands/hand_finder.h"
#include "tests/hands/hand_pictures.h"

namespace prosector {

/// Errors of one kind.
class ErrorList {
 public:
  void add(double error) { errors_.push_back(error); }
  void add(const ErrorList& others) {
    errors_.insert(errors_.end(), others.errors_.begin(), others.errors_.end());
  }
  /// Returns the error that this share of them is below; 0.5: the median.
  double at(double share) const;
  double mean() const;
  std::size_t count() const { return errors_.size(); }

 private:
  std::vector<double> errors_;
};

struct HandTrial {
  std::size_t pictures = 0, seen = 0;  // hands that were shown, and where one was seen
  std::size_t views = 0;               // by one camera, of hands that it saw
  std::size_t right_points = 0;  // seen with points that are less than a tenth of the hand off, in the mean
  std::size_t right_side = 0;
  std::size_t sure = 0;  // the fit says that it holds
  std::uint64_t palm_runs = 0;
  ErrorList points;          // shares of the hand's length in the picture, each point that our hand has
  ErrorList lateral, depth;  // of the palm's middle, m
  ErrorList turn;            // rad
  ErrorList flexion;
  ErrorList find_ms, fit_ms;  // CPU time of a thread, a picture
};

/// Shows that many hands, each for one picture: random poses, light, tones, noise, at 0.35 to 0.7 m.
HandTrial first_sight(const std::filesystem::path& nets, HandNets size, const HandPainter& painter,
                      std::size_t pictures, unsigned seed);

/// Shows one hand that moves and bends for that many pictures at 30 Hz, to one or two cameras 120 mm apart.
HandTrial followed_hand(const std::filesystem::path& nets, HandNets size, const HandPainter& painter,
                        std::size_t pictures, std::size_t cameras, unsigned seed);

/// What was told of gestures that hands made, picture by picture.
struct GestureTrial {
  std::map<Gesture, std::map<Gesture, std::size_t>> told;  // by what was made
  std::size_t pictures = 0, right_side = 0;

  std::size_t pictures_of(Gesture made) const;
  /// Returns the share of pictures of it in which it was told, by whichever hand.
  double right_share(Gesture made) const;
};

/// Shows hands that rest open and then make a gesture, each of the table from that many sides. What counts is
/// told from one picture after it is made on.
GestureTrial made_gestures(const std::filesystem::path& nets, HandNets size, const HandPainter& painter,
                           std::size_t views, unsigned seed);

/// Returns the folder of the fetched networks, empty where there are none.
std::filesystem::path fetched_nets();

}  // namespace prosector
