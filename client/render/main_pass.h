#pragma once
// Lit surfaces: one shader program for each kind of Surface, compiled for the lights that there are. Private
// to client/render.

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/render/shadow_pass.h"

namespace prosector {

class MainPass {
 public:
  MainPass(const Gl& gl, const std::filesystem::path& shaders);

  /// `items` nearest first, so that hidden fragments are not shaded. Compiles anew when the number or
  /// kinds of the lights changed, or which one casts the shadow.
  void draw(const DrawList& list, const DrawCamera& camera, const std::vector<QueuedItem>& items,
            const MeshCache& meshes, const Shadow& shadow);

 private:
  static constexpr std::size_t surfaces = static_cast<std::size_t>(Surface::emissive) + 1;

  using Programs = std::array<std::unique_ptr<ShaderProgram>, surfaces>;

  const Programs& programs_for(const std::string& lights);

  const Gl& gl_;
  std::filesystem::path shaders_;
  std::string compiled_lights_;
  Programs programs_;
};

}  // namespace prosector
