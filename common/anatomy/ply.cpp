// PLY format: a text header that lists elements and their properties, then their values as text or binary.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "common/anatomy/surface_formats.h"
#include "common/anatomy/token_reader.h"
#include "common/error.h"

namespace prosector {
namespace {

/// A number type of the format, with its two names.
struct Scalar {
  std::array<std::string_view, 2> names;
  std::size_t bytes;
  double (*decode)(const char*, bool swap);
};

template <class T>
double decode(const char* p, bool swap) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), p, sizeof(T));
  if (swap) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

constexpr std::array<Scalar, 8> scalars = {{{{"char", "int8"}, 1, decode<std::int8_t>},
                                            {{"uchar", "uint8"}, 1, decode<std::uint8_t>},
                                            {{"short", "int16"}, 2, decode<std::int16_t>},
                                            {{"ushort", "uint16"}, 2, decode<std::uint16_t>},
                                            {{"int", "int32"}, 4, decode<std::int32_t>},
                                            {{"uint", "uint32"}, 4, decode<std::uint32_t>},
                                            {{"float", "float32"}, 4, decode<float>},
                                            {{"double", "float64"}, 8, decode<double>}}};

struct Property {
  std::string_view name;
  const Scalar* type = nullptr;   // of the value, or of a list's values
  const Scalar* count = nullptr;  // type of a list's length; null: not a list
};

struct Element {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, std::vector<std::string>& notes) : in_(bytes, ""), notes_(notes) {}

  TriangleMesh read() {
    header();
    bool vertices = false, faces = false;
    for (const Element& element : elements_) {
      if (element.name == "vertex" && !vertices) {
        vertices = true;
        read_vertices(element);
      } else if (element.name == "face" && !faces) {
        faces = true;
        read_faces(element);
      } else {
        if (element.count > 0)
          notes_.push_back(
              fmt::format("{} elements \"{}\" are not used", element.count, element.name.substr(0, 32)));
        for (std::uint64_t i = 0; i < element.count; ++i) read_row(element, [](std::size_t, double) {});
      }
    }
    if (!vertices || !faces)
      throw InputError("the file has no elements \"vertex\" and \"face\", so it is not a polygon surface");
    check_corners();
    if (unlike_polygons_ > 0)
      notes_.push_back(fmt::format("{} faces of fewer than three vertices are not used", unlike_polygons_));
    return std::move(mesh_);
  }

 private:
  void header() {
    in_.expect("ply");
    for (std::string_view w = in_.word(); w != "end_header"; w = in_.word()) {
      if (w.empty()) in_.fail("ends within the header");
      if (w == "comment" || w == "obj_info")
        in_.rest();
      else if (w == "format")
        format();
      else if (w == "element")
        elements_.push_back({in_.word(), in_.number<std::uint64_t>("a number of elements"), {}});
      else if (w == "property")
        property();
      else
        in_.fail(fmt::format("\"{}\" found; expected: element, property or end_header", w.substr(0, 32)));
    }
    in_.end_line();
    if (!encoded_)
      in_.fail("the header has no format; allowed: ascii, binary_little_endian, binary_big_endian");
    for (const Element& element : elements_) check_size(element);
  }

  void format() {
    const std::string_view w = in_.word();
    if (w != "ascii" && w != "binary_little_endian" && w != "binary_big_endian")
      in_.fail(
          fmt::format("the header has format \"{}\"; allowed: ascii, binary_little_endian, binary_big_endian",
                      w.substr(0, 32)));
    encoded_ = true;
    binary_ = w != "ascii";
    swap_ = (w == "binary_big_endian") != (std::endian::native == std::endian::big);
    in_.rest();  // format version
  }

  void property() {
    if (elements_.empty()) in_.fail("a property before any element");
    Property out;
    std::string_view w = in_.word();
    if (w == "list") {
      out.count = &scalar(in_.word());
      w = in_.word();
    }
    out.type = &scalar(w);
    out.name = in_.word();
    elements_.back().properties.push_back(out);
  }

  const Scalar& scalar(std::string_view name) const {
    for (const Scalar& s : scalars)
      if (std::ranges::find(s.names, name) != s.names.end()) return s;
    in_.fail(fmt::format("unknown type \"{}\" of a property; allowed: e.g. float, double, uchar, int",
                         name.substr(0, 32)));
  }

  /// Throws InputError if the rest of the file can't hold the number of elements.
  void check_size(const Element& element) const {
    std::size_t least = 0;  // minimum bytes of one element
    for (const Property& p : element.properties)
      least += !binary_ ? 2 : p.count != nullptr ? p.count->bytes : p.type->bytes;
    constexpr std::uint64_t most = std::uint64_t{1} << 20;
    if (element.count > (least == 0 ? most : in_.left() / least + 1))
      in_.fail(fmt::format("{} elements \"{}\" exceed the file", element.count, element.name.substr(0, 32)));
  }

  double next(const Scalar& type, const char* what) {
    if (!binary_) return in_.number<double>(what);
    return type.decode(in_.bytes(type.bytes, what).data(), swap_);
  }

  std::uint64_t length(const Property& list) {
    const double n = next(*list.count, "a list's length");
    const std::size_t least = binary_ ? list.type->bytes : 2;
    if (!(n >= 0 && n == std::floor(n) && n <= static_cast<double>(in_.left() / least + 1)))
      in_.fail(fmt::format("a list should have {} values, which exceeds the rest of the file", n));
    return static_cast<std::uint64_t>(n);
  }

  /// Calls visit(property index, value) for all values of one element.
  template <class Visit>
  void read_row(const Element& element, Visit&& visit) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Property& p = element.properties[k];
      const std::uint64_t values = p.count != nullptr ? length(p) : 1;
      for (std::uint64_t v = 0; v < values; ++v) visit(k, next(*p.type, "a value"));
    }
  }

  static std::optional<std::size_t> find(const Element& element,
                                         std::initializer_list<std::string_view> names) {
    for (std::size_t k = 0; k < element.properties.size(); ++k)
      if (std::ranges::find(names, element.properties[k].name) != names.end()) return k;
    return std::nullopt;
  }

  void read_vertices(const Element& element) {
    const std::array axes = {find(element, {"x"}), find(element, {"y"}), find(element, {"z"})};
    for (const auto& axis : axes)
      if (!axis || element.properties[*axis].count != nullptr)
        throw InputError("its element \"vertex\" has no properties x, y and z");
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Vec3 x = Vec3::Zero();
      read_row(element, [&](std::size_t k, double value) {
        for (int axis = 0; axis < 3; ++axis)
          if (axes[static_cast<std::size_t>(axis)] == k) x[axis] = value;
      });
      mesh_.positions.push_back(x);
    }
  }

  void read_faces(const Element& element) {
    const auto corners = find(element, {"vertex_indices", "vertex_index"});
    if (!corners || element.properties[*corners].count == nullptr)
      throw InputError("its element \"face\" has no list vertex_indices");
    std::vector<std::uint32_t> polygon;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      polygon.clear();
      read_row(element, [&](std::size_t k, double value) {
        if (k != corners) return;
        constexpr double most = 4294967295;
        if (!(value >= 0 && value <= most && value == std::floor(value)))
          in_.fail(fmt::format("face {} refers to vertex {}", i, value));
        polygon.push_back(static_cast<std::uint32_t>(value));
      });
      if (polygon.size() < 3) ++unlike_polygons_;
      polygons_.push_back(polygon);
    }
  }

  /// Triangulates the polygons after all vertices are read, since faces may precede vertices in the file.
  void check_corners() {
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      for (const std::uint32_t v : polygons_[i])
        if (v >= mesh_.positions.size())
          throw InputError(fmt::format("face {} refers to vertex {}; allowed: vertices below {}", i, v,
                                       mesh_.positions.size()));
      add_fan(polygons_[i]);
    }
  }

  /// Adds the polygon as a triangle fan from a corner for which all triangles have the same orientation, if
  /// one exists.
  void add_fan(const std::vector<std::uint32_t>& polygon) {
    const std::size_t n = polygon.size();
    if (n < 3) return;
    const auto area = [&](std::size_t root, std::size_t k) -> Vec3 {
      const Vec3& a = mesh_.positions[polygon[root]];
      return (mesh_.positions[polygon[(root + k) % n]] - a)
          .cross(mesh_.positions[polygon[(root + k + 1) % n]] - a);
    };
    Vec3 whole = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < n; ++k) whole += area(0, k);
    constexpr std::size_t tried = 64;
    std::size_t root = 0;
    for (std::size_t r = 0; n > 3 && r < std::min(n, tried); ++r) {
      bool alike = true;
      for (std::size_t k = 1; k + 1 < n && alike; ++k) alike = area(r, k).dot(whole) >= 0;
      if (!alike) continue;
      root = r;
      break;
    }
    for (std::size_t k = 1; k + 1 < n; ++k)
      mesh_.triangles.push_back({polygon[root], polygon[(root + k) % n], polygon[(root + k + 1) % n]});
  }

  TokenReader in_;
  std::vector<std::string>& notes_;
  std::vector<Element> elements_;
  std::vector<std::vector<std::uint32_t>> polygons_;
  std::size_t unlike_polygons_ = 0;
  bool encoded_ = false, binary_ = false, swap_ = false;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh parse_ply(std::string_view bytes, std::vector<std::string>& notes) {
  return PlyReader(bytes, notes).read();
}

}  // namespace prosector
