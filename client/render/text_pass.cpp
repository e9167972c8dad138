#include "client/render/text_pass.h"

#include <algorithm>
#include <cmath>

#include "client/render/projection.h"
#include "client/render/screen_quads.h"
#include "client/view/set_text.h"

namespace prosector {
namespace {

constexpr double leader_width = 1.2;             // points
constexpr double corner = 4, frame_width = 1.5;  // points, of text backgrounds
const Vec3 dark = Vec3::Constant(0.004);
constexpr double ground_opacity = 0.62;

Eigen::Vector4f with_opacity(const Vec3& color, double opacity) {
  return Eigen::Vector4d(color.x(), color.y(), color.z(), opacity).cast<float>();
}

void add_ground(std::vector<PlateVertex>& out, const PlacedText& placed, double scale,
                const Eigen::Vector2d& picture) {
  const DrawText& text = *placed.text;
  if (text.ground == TextGround::none || text.text.empty()) return;
  const bool framed = text.ground == TextGround::framed;
  const Eigen::Vector2d low =
      placed.origin - scale * Eigen::Vector2d(ground_beside, framed ? ground_beside : ground_above);
  const Eigen::Vector2d high = placed.origin + placed.size +
                               scale * Eigen::Vector2d(ground_beside, framed ? ground_beside : ground_above);
  const PlateLook look{with_opacity(dark, ground_opacity), with_opacity(text.color, 1), scale * corner,
                       framed ? scale * frame_width : 0};
  add_plate(out, {std::round(low.x()), std::round(low.y()), std::round(high.x()), std::round(high.y())}, look,
            picture);
}

void add_plate(std::vector<PlateVertex>& out, const DrawPlate& plate, double scale,
               const Eigen::Vector2d& picture) {
  const Eigen::Vector2d low = (scale * plate.low).array().round(),
                        high = (scale * plate.high).array().round();
  const Eigen::Vector4f fill = with_opacity(plate.color, plate.opacity);
  const PlateLook look{fill, plate.rim_width > 0 ? with_opacity(plate.rim_color, 1) : fill,
                       scale * plate.radius, scale * plate.rim_width};
  add_plate(out, {low.x(), low.y(), high.x(), high.y()}, look, picture);
}

/// Adds a line from a lifted text down to its point.
void add_leader(std::vector<PlateVertex>& out, const PlacedText& placed, double scale,
                const Eigen::Vector2d& picture) {
  if (placed.lift <= 0) return;
  const double x = placed.origin.x() + std::round(placed.size.x() / 2);
  const double top = std::round(placed.origin.y() + placed.size.y() + scale * ground_above);
  const double half = scale * leader_width / 2 + 1;
  const PlateLook look{with_opacity(placed.text->color, 1), with_opacity(dark, ground_opacity), 0, 1};
  add_plate(out, {x - half, top, x + half, top + placed.lift}, look, picture);
}

}  // namespace

TextPass::TextPass(const Gl& gl, const std::filesystem::path& shaders, Typesetter& typesetter)
    : gl_(gl),
      typesetter_(typesetter),
      plate_program_(gl, shaders, "plate"),
      letter_program_(gl, shaders, "text"),
      writing_program_(gl, shaders, "text", {"DISTANCES"}),
      plate_stream_(gl, PlateVertex::attributes()),
      glyph_stream_(gl, GlyphVertex::attributes()),
      letters_(gl),
      shapes_(gl) {}

void TextPass::draw_over(const DrawList& list, const DrawCamera& camera) {
  const Eigen::Vector2d picture(camera.width, camera.height);
  const std::vector<PlacedText> texts = place_texts(list, camera, typesetter_);
  if (texts.empty() && list.plates.empty()) return;
  std::vector<PlateVertex> plates;
  for (const DrawPlate& plate : list.plates) add_plate(plates, plate, list.scale, picture);
  Ink ink{letters_, letter_program_};
  for (const PlacedText& placed : texts) add_leader(plates, placed, list.scale, picture);
  for (const PlacedText& placed : texts) add_ground(plates, placed, list.scale, picture);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  plate_program_.use();
  plate_stream_.draw(plates);
  for (const PlacedText& placed : texts) add_letters(ink, placed, picture);
  draw(ink);
  gl_.Disable(GL_BLEND);
}

void TextPass::draw_on_surfaces(const DrawList& list, const DrawCamera& camera) {
  const Eigen::Matrix4d clip_from_room = view_projection_of(camera);
  Ink ink{shapes_, writing_program_};
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_FALSE);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (const DrawText& text : list.texts)
    if (text.surface) add_writing(ink, text, clip_from_room);
  draw(ink);
  gl_.Disable(GL_BLEND);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.DepthMask(GL_TRUE);
}

void TextPass::add_letters(Ink& ink, const PlacedText& placed, const Eigen::Vector2d& picture) {
  const double em = placed.set.size, drawn_em = std::min(em, largest_image);
  const int size = static_cast<int>(std::lround(64 * drawn_em));
  const double enlarged = em > largest_image ? em / drawn_em : 1;
  for (const TextLine& line : placed.set.block->lines)
    for (const PlacedGlyph& glyph : line.glyphs) {
      // Rounds the pen vertically to a whole pixel, horizontally to a phase of a pixel, so that the
      // rasterised glyph aligns with the pixels.
      const double x = placed.origin.x() + em * (line.left + glyph.x);
      const double y = std::round(placed.origin.y() + em * (line.baseline - glyph.y));
      const long phases = std::lround(pen_phases * x);
      const int phase = static_cast<int>((phases % pen_phases + pen_phases) % pen_phases);
      const GlyphSpot at = spot(ink, {glyph.font, glyph.glyph, size, phase}, [&] {
        return typesetter_.font(glyph.font).coverage(glyph.glyph, size, phase);
      });
      if (at.width == 0) continue;
      const double left = static_cast<double>(phases - phase) / pen_phases + enlarged * at.left;
      const double top = y - enlarged * at.top;
      const double right = left + enlarged * at.width, bottom = top + enlarged * at.height;
      add_glyph(ink.vertices,
                {clip_of({left, top}, picture), clip_of({right, top}, picture),
                 clip_of({right, bottom}, picture), clip_of({left, bottom}, picture)},
                at, placed.text->color);
    }
}

void TextPass::add_writing(Ink& ink, const DrawText& text, const Eigen::Matrix4d& clip_from_room) {
  const SetText set = set_text(typesetter_, text, 1);
  const double em = set.size, pixel = em / distance_em;  // m
  const Eigen::Vector2d origin =
      text.centred ? Eigen::Vector2d(-set.width() / 2, -set.height() / 2) : Eigen::Vector2d(0, 0);
  const auto place = [&](double x, double down) -> Eigen::Vector4d {
    const Vec3 at = *text.surface * Vec3(origin.x() + x, -(origin.y() + down), 0);
    return in_front(clip_from_room * at.homogeneous());
  };
  for (const TextLine& line : set.block->lines)
    for (const PlacedGlyph& glyph : line.glyphs) {
      const GlyphSpot at = spot(ink, {glyph.font, glyph.glyph, 0, 0},
                                [&] { return typesetter_.font(glyph.font).distances(glyph.glyph); });
      if (at.width == 0) continue;
      const double left = em * (line.left + glyph.x) + pixel * at.left;
      const double top = em * (line.baseline - glyph.y) - pixel * at.top;
      const double right = left + pixel * at.width, bottom = top + pixel * at.height;
      add_glyph(ink.vertices,
                {place(left, top), place(right, top), place(right, bottom), place(left, bottom)}, at,
                text.color);
    }
}

/// Returns the glyph's position on its sheet. If the sheet is full, draws the waiting glyphs and clears it.
GlyphSpot TextPass::spot(Ink& ink, const GlyphKey& key, const std::function<GlyphImage()>& make) {
  if (const auto found = ink.texture.sheet().spot(key, make)) return *found;
  draw(ink);
  ink.texture.sheet().clear();
  return ink.texture.sheet().spot(key, make).value_or(GlyphSpot{});
}

void TextPass::draw(Ink& ink) {
  if (ink.vertices.empty()) return;
  ink.texture.bind();
  ink.program.use();
  ink.program.set("sheet", 0);
  ink.program.set("distance_reach", static_cast<double>(distance_reach));
  glyph_stream_.draw(ink.vertices);
  ink.vertices.clear();
}

}  // namespace prosector
