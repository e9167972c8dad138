#pragma once
// Scene of a synthetic camera: a scene file with moving objects and the camera's pose and lens. The true
// poses are known for each image.
//
// The room's frame has y up; m.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/ids.h"
#include "drivers/camera/base/frame.h"
#include "drivers/camera/base/lens.h"
#include "drivers/camera/tags/board.h"
#include "drivers/recordings/motion_script.h"
#include "twins/camera/face_mesh.h"
#include "twins/camera/hand_layer.h"
#include "twins/camera/quad_renderer.h"
#include "twins/camera/sensor.h"

namespace prosector {

/// A frame to which objects of a synthetic scene are attached. It is fixed in the room, or follows a station
/// (tracked object) of a motion script.
struct Carrier {
  std::string name;
  Pose pose;  // in the room, used without a motion
  std::optional<MotionScript> motion;
  std::size_t station = 0;
  bool loop = false;
  Pose offset;  // pose in the moving frame; the identity unless the script moves another frame

  Pose at(double seconds) const { return motion ? motion->pose(station, seconds, loop) * offset : pose; }
};

/// A hand in a synthetic scene. Its wrist is the frame `carrier` (index), whose motion also gives its
/// flexions.
struct SyntheticHand {
  std::size_t carrier = 0;
  std::size_t hand = right_hand;
  double size = 1;  // scale of the hand model
};

/// A face in a synthetic scene. The frame `carrier` (index) is at the point between its eyes: x to the user's
/// right, y up, −z forward.
struct SyntheticFace {
  std::size_t carrier = 0;
  std::shared_ptr<const FaceMesh> mesh;
};

/// Simulated faults of a synthetic camera: torn, black, resized or upside-down images, a slow image rate, or
/// an unplugged camera.
enum class CameraFault : std::uint8_t { torn, black, resized, upside_down, slow, unplugged };
struct CameraFaultSpan {
  CameraFault fault;
  double from = 0, to = 0;  // s
};

/// True poses of the camera and of all moving frames at an image of a synthetic scene.
struct SyntheticTruth {
  double seconds = 0;             // s, mid-exposure in scene time
  Pose room_camera;               // pose of OpenCV's camera frame in the room
  std::vector<Pose> room_things;  // poses of the carriers in the room
};

struct SyntheticScene {
  Lens lens;
  double rate = 30;                      // images per second
  double exposure = 0.008, readout = 0;  // s
  double delay = 0.02;                   // s from the end of an exposure to the image's delivery
  int rays = 3;                          // rays per pixel side
  bool clock = false;                    // true: each image shows its time (painted_clock.h)
  Sensor sensor;
  Carrier camera;  // its pose is that of the camera frame with x right, y up, −z forward
  Vec3 to_lamp = Vec3(0.3, 0.9, 0.3).normalized();  // unit vector to the lamp, room frame
  double ambient = 0.6;
  std::vector<Carrier> carriers;
  std::vector<TexturedQuad> things;
  std::vector<SyntheticHand> hands;
  std::vector<SyntheticFace> faces;
  std::vector<Board> boards;                // all boards of the scene, for callers that compare poses
  std::vector<std::size_t> board_carriers;  // carrier of each board
  std::vector<CameraFaultSpan> faults;

  /// Reads a synthetic camera's scene from a TOML file. Throws InputError with file, line, key and the
  /// allowed values.
  static SyntheticScene load(const std::filesystem::path& file);

  /// Adds a printed board, with its paper if it is a flat board of tags, to the scene. It moves with the
  /// frame `carrier`. Returns the index of this frame in `carriers`.
  std::size_t add_board(const Board& board, Carrier carrier);

  double seconds_of(std::uint64_t number) const { return (static_cast<double>(number) + 0.5) / rate; }
  SyntheticTruth truth(double seconds) const;
};

/// Renderer of a synthetic scene's images. An image is determined by its scene, time and number.
class SceneRenderer {
 public:
  explicit SceneRenderer(SyntheticScene scene);
  const SyntheticScene& scene() const { return scene_; }
  /// Draws the image with this number, including the faults that the scene simulates at its time,
  /// seconds_of(number) at mid-exposure.
  Image paint(std::uint64_t number) const;
  Image paint_at(double seconds, std::uint64_t number) const;

 private:
  std::optional<MeshDepthBuffer> solids(const SyntheticTruth& truth, const Lamp& lamp) const;

  SyntheticScene scene_;
  RayGrid grid_;
  std::optional<HandRenderer> hands_;  // only if the scene has hands
};

}  // namespace prosector
