#include "tests/bench/svg.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace prosector {
namespace {

std::string coordinates(const std::vector<std::pair<double, double>>& points) {
  std::string list;
  for (const auto& [x, y] : points) list += fmt::format("{:.1f},{:.1f} ", x, y);
  return list;
}

std::string attributes(const Stroke& stroke) {
  return fmt::format("stroke=\"{}\" stroke-width=\"{:.2f}\"{}", stroke.color, stroke.width,
                     stroke.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes));
}

}  // namespace

std::string xml_escaped(const std::string& words) {
  std::string out;
  for (const char c : words) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

Svg::Svg(double width, double height) : width_(width), height_(height) {
  rect(0, 0, width, height, "#ffffff");
}

void Svg::line(double x1, double y1, double x2, double y2, const Stroke& stroke) {
  body_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1, x2, y2,
                       attributes(stroke));
}

void Svg::path(const std::vector<std::pair<double, double>>& points, const Stroke& stroke) {
  body_ +=
      fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", coordinates(points), attributes(stroke));
}

void Svg::polygon(const std::vector<std::pair<double, double>>& points, const std::string& fill,
                  const std::string& stroke) {
  body_ +=
      fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", coordinates(points), fill, stroke);
}

void Svg::rect(double x, double y, double width, double height, const std::string& fill,
               const std::string& stroke) {
  body_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" stroke=\"{}\"/>\n", x,
      y, width, height, fill, stroke);
}

void Svg::circle(double x, double y, double radius, const std::string& fill, const std::string& stroke) {
  body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" stroke=\"{}\"/>\n", x, y,
                       radius, fill, stroke);
}

void Svg::text(double x, double y, const std::string& words, const TextStyle& style) {
  const std::string turned =
      style.turn == 0 ? "" : fmt::format(" transform=\"rotate({:.1f} {:.1f} {:.1f})\"", style.turn, x, y);
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}</text>\n",
      x, y, style.size, style.anchor, style.color, style.bold ? " font-weight=\"bold\"" : "", turned,
      xml_escaped(words));
}

std::string Svg::str() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n{2}</svg>\n",
      width_, height_, body_);
}

void Svg::write(const std::string& file) const {
  if (!(std::ofstream(file) << str())) throw std::runtime_error("cannot write " + file);
}

}  // namespace prosector
