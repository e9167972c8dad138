#pragma once
// A camera image as background. Private to client/render.

#include <filesystem>

#include "client/render/draw_queue.h"
#include "client/render/shader_program.h"
#include "client/view/draw_list.h"

namespace prosector {

class BackdropPass {
 public:
  BackdropPass(const Gl& gl, const std::filesystem::path& shaders);
  ~BackdropPass();
  BackdropPass(const BackdropPass&) = delete;
  BackdropPass& operator=(const BackdropPass&) = delete;

  /// Fills the camera's viewport with the camera image. Pixels outside the image stay unchanged. Uploads each
  /// image only once.
  void draw(const DrawBackdrop& backdrop, const DrawCamera& camera);
  /// Draws the camera image, with soft borders, over the silhouettes of real objects, such as the user's
  /// hands, so that they occlude virtual ones.
  void uncover(const DrawBackdrop& backdrop, const DrawCamera& camera, const std::vector<QueuedItem>& items,
               const MeshCache& meshes);

 private:
  void upload(const DrawBackdrop& backdrop);
  void set_image(const ShaderProgram& program, const DrawBackdrop& backdrop, const DrawCamera& camera);

  const Gl& gl_;
  ShaderProgram program_, uncover_;
  GLuint texture_ = 0, no_vertices_ = 0;
  int width_ = 0, height_ = 0;  // of the texture
  std::uint64_t number_ = 0;    // of the uploaded image
};

}  // namespace prosector
