#include "drivers/camera/printing/board_sheet.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <memory>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double points_per_metre = 72 / 0.0254;
constexpr double border = 0.005;               // m, unprintable margin
constexpr double ruler = 0.100, tick = 0.004;  // m
constexpr double text_height = 0.0035;         // m
constexpr double foot = 0.016;                 // m, height of the area below the board for ruler and text

struct Surface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* pen) const { cairo_destroy(pen); }
};
using SurfacePtr = std::unique_ptr<cairo_surface_t, Surface>;
using PenPtr = std::unique_ptr<cairo_t, Surface>;

/// Draws a tag. Lengths are in metres, from the sheet's upper left.
void draw_tag(cairo_t* pen, const BoardTag& tag, const Vec3& origin) {
  const double cell = tag.size / black_cells;
  const auto ink = tag_ink(tag.code);
  cairo_save(pen);
  cairo_translate(pen, origin.x() + tag.pose.p.x(), origin.y() - tag.pose.p.y());
  const Vec3 across = tag.pose.q * Vec3::UnitX();
  cairo_rotate(pen, -std::atan2(across.y(), across.x()));
  for (int y = 0; y < tag_cells; ++y)
    for (int x = 0; x < tag_cells; ++x)
      if (ink[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)])
        cairo_rectangle(pen, (x - tag_cells / 2.0) * cell, (y - tag_cells / 2.0) * cell, cell, cell);
  // One path for all cells avoids hairlines between neighbours.
  cairo_fill(pen);
  cairo_restore(pen);
}

void write_text(cairo_t* pen, double x, double y, const std::string& text) {
  cairo_move_to(pen, x, y);
  cairo_show_text(pen, text.c_str());
}

void draw_ruler(cairo_t* pen, double x, double y) {
  cairo_set_line_width(pen, 0.0002);
  cairo_move_to(pen, x, y);
  cairo_line_to(pen, x + ruler, y);
  for (int k = 0; k <= 10; ++k) {
    cairo_move_to(pen, x + k * ruler / 10, y);
    cairo_line_to(pen, x + k * ruler / 10, y - (k % 5 == 0 ? tick : tick / 2));
  }
  cairo_stroke(pen);
}

/// Draws an image centred at `origin`, in metres.
void draw_picture(cairo_t* pen, const PrintedImage& picture, const Vec3& origin) {
  const Image& image = picture.image;
  const SurfacePtr surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
  std::uint8_t* bytes = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* rgb = image.pixel(x, y);
      const auto packed =
          static_cast<std::uint32_t>(rgb[0]) << 16 | static_cast<std::uint32_t>(rgb[1]) << 8 | rgb[2];
      std::memcpy(bytes + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x), &packed, 4);
    }
  cairo_surface_mark_dirty(surface.get());
  cairo_save(pen);
  cairo_translate(pen, origin.x() - picture.width / 2, origin.y() - picture.height() / 2);
  cairo_scale(pen, picture.width / image.width, picture.width / image.width);
  cairo_set_source_surface(pen, surface.get(), 0, 0);
  cairo_pattern_set_extend(cairo_get_source(pen), CAIRO_EXTEND_PAD);
  cairo_rectangle(pen, 0, 0, image.width, image.height);
  cairo_fill(pen);
  cairo_restore(pen);
}

Eigen::AlignedBox2d box_of(const Board& board) {
  Eigen::AlignedBox2d box;
  if (board.picture) {
    const Eigen::Vector2d half(board.picture->width / 2, board.picture->height() / 2);
    box.extend(-half).extend(half);
  }
  for (const BoardTag& tag : board.tags) {
    const double reach = tag.size / 2 * tag_cells / black_cells;
    for (const double x : {-reach, reach})
      for (const double y : {-reach, reach}) box.extend((tag.pose * Vec3(x, y, 0)).head<2>());
  }
  return box;
}

/// Returns the text about a board's size that is printed on its sheet.
std::string words_of(const Board& board) {
  if (board.picture) return fmt::format("printed width of this image: {:.1f} mm", 1e3 * board.picture->width);
  return fmt::format("black squares of {:.1f} mm, codes {} to {}", 1e3 * board.tags.front().size,
                     board.tags.front().code, board.tags.back().code);
}

void draw(cairo_t* pen, const Board& board, const Paper& paper) {
  cairo_set_source_rgb(pen, 1, 1, 1);
  cairo_paint(pen);
  cairo_set_source_rgb(pen, 0, 0, 0);
  const Eigen::AlignedBox2d box = box_of(board);
  const double free = (paper.height - foot - box.sizes().y()) / 2;
  const Vec3 origin(paper.width / 2 - box.center().x(), free + box.max().y(), 0);
  if (board.picture) draw_picture(pen, *board.picture, origin);
  for (const BoardTag& tag : board.tags) draw_tag(pen, tag, origin);
  cairo_set_line_width(pen, 0.0001);
  cairo_set_source_rgb(pen, 0.6, 0.6, 0.6);
  cairo_rectangle(pen, origin.x() + box.min().x(), origin.y() - box.max().y(), box.sizes().x(),
                  box.sizes().y());
  cairo_stroke(pen);
  cairo_set_source_rgb(pen, 0, 0, 0);
  cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(pen, text_height);
  const double base = paper.height - border - text_height;
  draw_ruler(pen, border + text_height, base);
  write_text(pen, border + 2 * text_height + ruler, base,
             "100 mm: check with a ruler. Print at 100 %, not \"fit to page\"; glue it onto a flat surface.");
  write_text(pen, border + 2 * text_height + ruler, base - 1.4 * text_height,
             fmt::format("Prosector board \"{}\": {}. This side up.", board.name, words_of(board)));
}

void check(cairo_t* pen, cairo_surface_t* surface, const std::filesystem::path& file) {
  cairo_show_page(pen);
  cairo_surface_finish(surface);
  for (const cairo_status_t status : {cairo_status(pen), cairo_surface_status(surface)})
    if (status != CAIRO_STATUS_SUCCESS)
      throw InputError(
          fmt::format("{}: cannot be written: {}", file.string(), cairo_status_to_string(status)));
}

}  // namespace

Paper paper_named(const std::string& name) {
  if (name == "a3") return {0.420, 0.297};
  if (name == "a4") return {0.297, 0.210};
  if (name == "letter") return {0.2794, 0.2159};
  throw InputError(fmt::format("paper \"{}\": must be a3, a4 or letter", name));
}

void write_sheet(const Board& board, const SheetSettings& settings, const std::filesystem::path& file) {
  if (!board.is_flat())
    throw InputError(fmt::format(
        "board {}: the board is not flat; print a separate sheet for each of its faces", board.name));
  const Eigen::Vector2d size = box_of(board).sizes();
  const Paper& paper = settings.paper;
  if (size.x() > paper.width - 2 * border || size.y() > paper.height - 2 * border - foot)
    throw InputError(fmt::format("board {}: {:.0f} × {:.0f} mm, too large for paper of {:.0f} × {:.0f} mm",
                                 board.name, 1e3 * size.x(), 1e3 * size.y(), 1e3 * paper.width,
                                 1e3 * paper.height));
  const std::string kind = file.extension().string();
  const double width = paper.width * points_per_metre, height = paper.height * points_per_metre;
  double scale = points_per_metre;
  SurfacePtr surface;
  if (kind == ".pdf") {
    surface.reset(cairo_pdf_surface_create(file.c_str(), width, height));
  } else if (kind == ".svg") {
    surface.reset(cairo_svg_surface_create(file.c_str(), width, height));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PT);
  } else if (kind == ".png") {
    scale = settings.dots_per_inch / 0.0254;
    surface.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                             static_cast<int>(std::lround(paper.width * scale)),
                                             static_cast<int>(std::lround(paper.height * scale))));
  } else {
    throw InputError(fmt::format("{}: must end with .pdf, .svg or .png", file.string()));
  }
  const PenPtr pen(cairo_create(surface.get()));
  cairo_scale(pen.get(), scale, scale);
  draw(pen.get(), board, paper);
  if (kind == ".png") {
    const cairo_status_t status = cairo_surface_write_to_png(surface.get(), file.c_str());
    if (status != CAIRO_STATUS_SUCCESS)
      throw InputError(
          fmt::format("{}: cannot be written: {}", file.string(), cairo_status_to_string(status)));
    return;
  }
  check(pen.get(), surface.get(), file);
}

}  // namespace prosector
