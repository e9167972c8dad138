#pragma once
// What a synthetic camera sees: a scene file of flat things that move, and how the camera looks at it. Truth
// is known for each picture.
//
// The room's frame is ours: y up, m.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "drivers/camera/frame.h"
#include "drivers/camera/lens.h"
#include "drivers/camera/synthetic/face_mesh.h"
#include "drivers/camera/synthetic/flat_painter.h"
#include "drivers/camera/synthetic/hand_layer.h"
#include "drivers/camera/synthetic/sensor.h"
#include "drivers/camera/tags/board.h"
#include "drivers/motion_script.h"

namespace prosector {

/// What stands still, or moves by a station of a motion script.
struct Carrier {
  std::string name;
  Pose pose;  // in the room, where nothing moves it
  std::optional<MotionScript> motion;
  std::size_t station = 0;
  bool loop = false;
  Pose offset;  // in the frame of what moves, where it isn't that itself

  Pose at(double seconds) const { return motion ? motion->pose(station, seconds, loop) * offset : pose; }
};

/// A hand of ours, whose carrier is the wrist; bends come from its motion.
struct SyntheticHand {
  std::size_t carrier = 0;
  std::size_t hand = right_hand;
  double size = 1;  // 1: our hand
};

/// A face, whose carrier is the point between the eyes: x to the user's right, y up, −z ahead.
struct SyntheticFace {
  std::size_t carrier = 0;
  std::shared_ptr<const FaceMesh> mesh;
};

/// What goes wrong with a camera, for a span of time.
enum class CameraFault : std::uint8_t { torn, black, resized, upside_down, slow, unplugged };
struct CameraFaultSpan {
  CameraFault fault;
  double from = 0, to = 0;  // s
};

/// A picture's truth.
struct SyntheticTruth {
  double seconds = 0;             // mid-exposure, scene's time
  Pose room_camera;               // OpenCV's camera frame in the room
  std::vector<Pose> room_things;  // of carriers
};

struct SyntheticScene {
  Lens lens;
  double rate = 30;                      // pictures a second
  double exposure = 0.008, readout = 0;  // s
  double delay = 0.02;                   // s from the end of an exposure until its picture is at hand
  int rays = 3;                          // of a pixel's side
  bool clock = false;                    // each picture tells its time: painted_clock.h
  Sensor sensor;
  Carrier camera;  // its pose is the camera's in our frame: x right, y up, −z ahead
  Vec3 to_lamp = Vec3(0.3, 0.9, 0.3).normalized();  // room
  double ambient = 0.6;
  std::vector<Carrier> carriers;
  std::vector<FlatThing> things;
  std::vector<SyntheticHand> hands;
  std::vector<SyntheticFace> faces;
  std::vector<Board> boards;                // for who wants to know
  std::vector<std::size_t> board_carriers;  // of each board
  std::vector<CameraFaultSpan> faults;

  /// Reads a scene's file. Throws InputError with file, line, key and what is allowed.
  static SyntheticScene load(const std::filesystem::path& file);

  /// Adds a board and what it is printed on. Returns its carrier.
  std::size_t add_board(const Board& board, Carrier carrier);

  double seconds_of(std::uint64_t number) const { return (static_cast<double>(number) + 0.5) / rate; }
  SyntheticTruth truth(double seconds) const;
};

/// Draws a scene's pictures. A picture depends on its scene and number alone.
class ScenePainter {
 public:
  explicit ScenePainter(SyntheticScene scene);
  const SyntheticScene& scene() const { return scene_; }
  /// Draws a picture, its faults included, whose middle is at that time of the scene.
  Image paint(std::uint64_t number) const;
  Image paint_at(double seconds, std::uint64_t number) const;

 private:
  std::optional<MeshLayer> solids(const SyntheticTruth& truth, const Lamp& lamp) const;

  SyntheticScene scene_;
  RayGrid grid_;
  std::optional<HandLayer> hands_;  // where the scene has some
};

}  // namespace prosector
