#pragma once
// What a camera sees of the table, for who looks through it: each picture with the pose from which it was
// taken.

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "client/language/catalogue.h"
#include "common/image.h"
#include "drivers/camera/shared_camera.h"
#include "drivers/camera/tags/tag_reader.h"
#include "drivers/device.h"

namespace prosector {

/// A picture without distortion.
struct SightPicture {
  std::shared_ptr<const Image> image;
  Lens bent, straight;                    // of the camera, and of `image`
  std::int64_t time_ns = 0;               // of its exposure
  std::uint64_t number = 0;               // counts what was seen, from 1
  std::optional<Pose> room_eye;           // x right, y up, −z ahead; nullopt: the board is lost
  std::optional<Pose> room_tablet = {};   // of the panel that it is; nullopt: it isn't seen
  std::optional<Vec3> paper = {};         // light of the board's white paper, as paper_light() has it
  std::optional<Pose> room_phantom = {};  // of the phantom that is on a board; nullopt: it wasn't seen yet
};

/// A board that something is fixed to: the looker's tablet, a phantom.
struct SightBoard {
  std::string board;  // a known one's name, or a file
  Pose mount;         // of the panel, where it is worn, or of the phantom's shape, in the board's frame
};

class CameraSight {
 public:
  /// Looks from now on. `config` says which lens the camera has, which board lies on the table, and where
  /// there. Throws InputError where a lens' or board's file can't be read.
  CameraSight(std::shared_ptr<SharedCamera> camera, const DeviceConfig& config,
              const std::optional<SightBoard>& tablet, const std::optional<SightBoard>& phantom = {});

  /// Waits for a picture that wasn't returned yet, at most that long. Returns the newest, which may be an old
  /// one; null: none was ever seen.
  std::shared_ptr<const SightPicture> next(std::chrono::milliseconds patience);
  /// Tells whether all who see by the camera have looked at the picture of that time.
  bool all_saw(std::int64_t time_ns) const { return camera_->told_ns() >= time_ns; }
  /// Returns what is wrong with what was seen last, for people; empty: nothing.
  std::string trouble(const Catalogue& words = {}) const;
  const Pose& room_board() const { return room_board_; }

  static constexpr double held = 0.5;  // s that the last pose holds while the board isn't seen

 private:
  void see(const Frame& frame);
  void find_boards(SightPicture& out, const TagPicture& picture);

  std::shared_ptr<SharedCamera> camera_;
  const Pose room_board_;

  // Only the camera's thread uses these.
  const std::shared_ptr<TagReader> reader_;
  BoardTracker tracker_;
  std::optional<BoardTracker> tablet_;
  const Pose tablet_panel_;  // in its board's frame
  std::optional<BoardTracker> phantom_;
  const Pose board_phantom_;
  std::optional<Pose> room_phantom_;  // where it was last
  int changes_ = 0;                   // of the reader that the tracker knows of
  std::optional<Pose> last_eye_;
  std::optional<Vec3> paper_;
  std::int64_t seen_ns_ = 0;  // of the last picture that showed the board

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable came_;
  std::shared_ptr<const SightPicture> newest_;
  std::uint64_t taken_ = 0;  // number of the last one that was returned

  SharedCamera::Seat seat_;  // last: it uses what is above
};

}  // namespace prosector
