#pragma once
// Draws a DrawList's texts. Private to client/render.

#include "client/render/glyph_texture.h"
#include "client/render/shader_program.h"
#include "client/render/text_layout.h"
#include "client/render/text_vertices.h"
#include "client/render/vertex_stream.h"

namespace prosector {

class TextPass {
 public:
  /// Compiles the shaders for texts. `shaders` is the folder with the GLSL files, empty for the embedded
  /// ones. The typesetter must outlive the pass.
  TextPass(const Gl& gl, const std::filesystem::path& shaders, Typesetter& typesetter);

  /// Draws the texts that are written on surfaces of the room, with a depth test and without lighting. The
  /// frame's alpha channel stays unchanged.
  void draw_on_surfaces(const DrawList& list, const DrawCamera& camera);
  /// Draws plates (filled rectangles of the overlay) and all texts that are not on surfaces over the finished
  /// frame. Backgrounds are drawn first, then glyphs, which FreeType rasterises at exactly their size.
  void draw_over(const DrawList& list, const DrawCamera& camera);

 private:
  /// Batch of glyphs whose images are on one sheet (texture), drawn by one shader program.
  struct Ink {
    GlyphTexture& texture;
    const ShaderProgram& program;
    std::vector<GlyphVertex> vertices = {};
  };

  void add_letters(Ink& ink, const PlacedText& placed, const Eigen::Vector2d& picture);
  void add_writing(Ink& ink, const DrawText& text, const Eigen::Matrix4d& clip_from_room);
  GlyphSpot spot(Ink& ink, const GlyphKey& key, const std::function<GlyphImage()>& make);
  void draw(Ink& ink);

  const Gl& gl_;
  Typesetter& typesetter_;
  ShaderProgram plate_program_, letter_program_, writing_program_;
  VertexStream plate_stream_, glyph_stream_;
  GlyphTexture letters_;  // coverage images, for each size
  GlyphTexture shapes_;   // distance fields, of one size
};

}  // namespace prosector
