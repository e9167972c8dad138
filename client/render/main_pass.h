#pragma once
// Lit surfaces: one shader program for each kind of Surface. Private to client/render.

#include <array>
#include <filesystem>
#include <memory>
#include <vector>

#include "client/render/shadow_pass.h"

namespace prosector {

class MainPass {
 public:
  MainPass(const Gl& gl, const std::filesystem::path& shaders);

  /// `items` nearest first, so that hidden fragments are not shaded.
  void draw(const DrawList& list, const DrawCamera& camera, const std::vector<QueuedItem>& items,
            const MeshCache& meshes, const Shadow& shadow) const;

 private:
  static constexpr std::size_t surfaces = static_cast<std::size_t>(Surface::emissive) + 1;

  const Gl& gl_;
  std::array<std::unique_ptr<ShaderProgram>, surfaces> programs_;
};

}  // namespace prosector
