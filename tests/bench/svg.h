#pragma once
// Writes SVG plots. Coordinates are in pixels, y down.

#include <string>
#include <vector>

namespace prosector {

struct Stroke {
  std::string color = "#333333";
  double width = 1;
  std::string dashes;  // as SVG's stroke-dasharray; empty: solid
};

struct TextStyle {
  double size = 13;
  std::string anchor = "start";  // start | middle | end
  std::string color = "#222222";
  bool bold = false;
  double turn = 0;  // rotation in degrees, clockwise about the given point
};

class Svg {
 public:
  /// Creates a white image of this size, pixels.
  Svg(double width, double height);
  void line(double x1, double y1, double x2, double y2, const Stroke& stroke = {});
  void path(const std::vector<std::pair<double, double>>& points, const Stroke& stroke = {});
  void polygon(const std::vector<std::pair<double, double>>& points, const std::string& fill,
               const std::string& stroke = "none");
  void rect(double x, double y, double width, double height, const std::string& fill,
            const std::string& stroke = "none");
  void circle(double x, double y, double radius, const std::string& fill, const std::string& stroke = "none");
  void text(double x, double y, const std::string& words, const TextStyle& style = {});
  std::string str() const;
  /// Throws std::runtime_error when the file can't be written.
  void write(const std::string& file) const;

 private:
  double width_, height_;
  std::string body_;
};

/// Escapes < > & " for XML.
std::string xml_escaped(const std::string& words);

/// Colours distinguishable with colour blindness (Okabe and Ito 2008).
inline const std::vector<std::string> palette = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00",
                                                 "#56B4E9", "#7F6000", "#000000", "#8C564B", "#7F7F7F"};

}  // namespace prosector
