// Legacy VTK file formats (VTK User's Guide, "VTK file formats"): text keywords, and arrays as text or as
// big-endian bytes. Up to version 4 cells are runs of (count, points…), since 5.0 offsets and connectivity.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "common/anatomy/mesh_cells.h"
#include "common/anatomy/tet_io.h"
#include "common/anatomy/token_reader.h"

namespace prosector {
namespace {

/// A number type of the format; integers decode exactly below 2^53.
struct Scalar {
  std::string_view name;
  std::size_t bytes;
  double (*decode)(const char*);
};

template <class T>
double decode(const char* p) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), p, sizeof(T));
  if constexpr (std::endian::native == std::endian::little) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

constexpr std::array<Scalar, 13> scalars = {{{"char", 1, decode<std::int8_t>},
                                             {"unsigned_char", 1, decode<std::uint8_t>},
                                             {"short", 2, decode<std::int16_t>},
                                             {"unsigned_short", 2, decode<std::uint16_t>},
                                             {"int", 4, decode<std::int32_t>},
                                             {"unsigned_int", 4, decode<std::uint32_t>},
                                             {"long", 8, decode<std::int64_t>},
                                             {"unsigned_long", 8, decode<std::uint64_t>},
                                             {"vtktypeint32", 4, decode<std::int32_t>},
                                             {"vtktypeint64", 8, decode<std::int64_t>},
                                             {"vtkIdType", 4, decode<std::int32_t>},
                                             {"float", 4, decode<float>},
                                             {"double", 8, decode<double>}}};
constexpr std::size_t int_row = 4;

class VtkReader {
 public:
  VtkReader(std::string_view text, const std::string& name) : in_(text, name) {}

  TetMesh read(const Progress& report) {
    header();
    for (std::string_view w = in_.word(); !w.empty(); w = in_.word()) {
      if (w == "CELL_DATA" || w == "POINT_DATA") break;
      if (w == "POINTS")
        points();
      else if (w == "CELLS")
        cells();
      else if (w == "CELL_TYPES")
        cell_types();
      else if (w == "FIELD")
        skip_field();
      else if (w == "METADATA")
        skip_metadata();
      else
        in_.fail(fmt::format("\"{}\" found; expected: POINTS, CELLS, CELL_TYPES, FIELD or METADATA",
                             w.substr(0, 32)));
    }
    cells_.report(report);
    return std::move(mesh_);
  }

 private:
  void header() {
    in_.expect("#");
    in_.expect("vtk");
    in_.expect("DataFile");
    in_.expect("Version");
    const double version = in_.number<double>("the version");
    constexpr double newest = 5.1;
    if (!(version >= 1 && version <= newest))
      in_.fail(fmt::format("version {}; allowed: 1.0 to {}", version, newest));
    has_offsets_ = version >= 5;
    in_.next_line();  // title
    const std::string_view coding = in_.word();
    if (coding != "ASCII" && coding != "BINARY")
      in_.fail(fmt::format("\"{}\"; allowed: ASCII or BINARY", coding.substr(0, 32)));
    binary_ = coding == "BINARY";
    in_.expect("DATASET");
    in_.expect("UNSTRUCTURED_GRID");
  }

  const Scalar& scalar() {
    const std::string_view w = in_.word();
    for (const Scalar& s : scalars)
      if (s.name == w) return s;
    in_.fail(fmt::format("\"{}\" found; expected: a type such as float, double, int or vtktypeint64",
                         w.substr(0, 32)));
  }

  /// Calls visit(value) for each of `count` numbers.
  template <class Visit>
  void numbers(std::uint64_t count, const Scalar& type, const char* what, Visit&& visit) {
    if (!binary_) {
      for (std::uint64_t i = 0; i < count; ++i) visit(in_.number<double>(what));
      return;
    }
    const std::string_view bytes = in_.raw(count * type.bytes, what);
    for (std::uint64_t i = 0; i < count; ++i) visit(type.decode(bytes.data() + i * type.bytes));
  }

  std::vector<std::uint64_t> integers(std::uint64_t count, const Scalar& type, const char* what) {
    std::vector<std::uint64_t> out;
    out.reserve(count);
    numbers(count, type, what, [&](double value) {
      constexpr double limit = 4294967296;  // point numbers have 32 bits
      if (!(value >= 0 && value < limit && value == std::floor(value)))
        in_.fail(fmt::format("the number {} occurs in {}; allowed: whole numbers from 0 to below {}", value,
                             what, limit));
      out.push_back(static_cast<std::uint64_t>(value));
    });
    return out;
  }

  void points() {
    const std::uint64_t count = in_.count("number of points", 6);
    const Scalar& type = scalar();
    std::vector<double> x;
    x.reserve(3 * count);
    numbers(3 * count, type, "coordinates", [&](double value) { x.push_back(value); });
    mesh_.positions.resize(count);
    for (std::size_t i = 0; i < count; ++i) mesh_.positions[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
  }

  void cells() {
    if (has_offsets_) {
      // One more offset than cells; cell i is connectivity[offsets[i], offsets[i + 1]).
      const std::uint64_t offsets = in_.count("number of offsets");
      const std::uint64_t size = in_.count("size of the connectivity");
      in_.expect("OFFSETS");
      starts_ = integers(offsets, scalar(), "offsets");
      in_.expect("CONNECTIVITY");
      connectivity_ = integers(size, scalar(), "the connectivity");
      return;
    }
    const std::uint64_t cells = in_.count("number of cells");
    const std::uint64_t size = in_.count("size of the cell list");
    const std::vector<std::uint64_t> list = integers(size, scalars[int_row], "the cell list");
    starts_ = {0};
    connectivity_.clear();
    for (std::size_t at = 0; starts_.size() <= cells;) {
      const std::uint64_t points = at < list.size() ? list[at] : 0;
      if (at >= list.size() || points > list.size() - at - 1)
        in_.fail(fmt::format("cell {} extends beyond the end of the cell list, which has {} numbers",
                             starts_.size() - 1, size));
      const auto first = list.begin() + static_cast<std::ptrdiff_t>(at + 1);
      connectivity_.insert(connectivity_.end(), first, first + static_cast<std::ptrdiff_t>(points));
      starts_.push_back(connectivity_.size());
      at += 1 + points;
    }
  }

  void cell_types() {
    const std::uint64_t cells = starts_.empty() ? 0 : starts_.size() - 1;
    const std::uint64_t count = in_.count("number of cell types");
    if (count != cells) in_.fail(fmt::format("{} cell types for {} cells", count, cells));
    const std::vector<std::uint64_t> types = integers(count, scalars[int_row], "cell types");
    for (std::size_t c = 0; c < types.size(); ++c) {
      constexpr std::uint64_t most = 255;
      const CellKind* kind = types[c] <= most ? vtk_cell(static_cast<int>(types[c])) : nullptr;
      if (kind == nullptr) in_.fail(unknown_cell(types[c]));
      if (kind->shape == CellShape::flat)
        cells_.skip(*kind);
      else
        add_cell(*kind, c);
    }
  }

  void add_cell(const CellKind& kind, std::size_t cell) {
    const std::uint64_t begin = starts_[cell], end = starts_[cell + 1];
    const std::size_t corners = corners_of(kind.shape);
    if (end > connectivity_.size() || begin > end || (kind.nodes > 0 && end - begin != kind.nodes) ||
        end - begin < corners)
      in_.fail(fmt::format("cell {}, one of the {}, does not have {} points", cell, kind.plural,
                           std::max(kind.nodes, corners)));
    corners_.clear();
    for (std::size_t k = 0; k < corners; ++k) {
      const std::uint64_t point = connectivity_[begin + k];
      if (point >= mesh_.positions.size())
        in_.fail(
            fmt::format("a cell uses point {}; allowed: points below {}", point, mesh_.positions.size()));
      corners_.push_back(static_cast<std::uint32_t>(point));
    }
    cells_.add(kind, corners_, mesh_);
  }

  /// Skips arrays of the whole file, such as its time.
  void skip_field() {
    in_.word();  // name
    const std::uint64_t arrays = in_.count("number of arrays");
    for (std::uint64_t a = 0; a < arrays; ++a) {
      in_.word();  // name
      const std::uint64_t components = in_.count("number of components", 1);
      const std::uint64_t tuples = in_.count("number of tuples", std::max<std::uint64_t>(components, 1));
      numbers(components * tuples, scalar(), "an array", [](double) {});
    }
  }

  /// Skips lines up to and including an empty one.
  void skip_metadata() {
    while (!in_.next_line().empty()) {
    }
  }

  TokenReader in_;
  TetMesh mesh_;
  CellCollector cells_;
  std::vector<std::uint32_t> corners_;  // of the current cell
  bool binary_ = false;
  bool has_offsets_ = false;
  std::vector<std::uint64_t> starts_, connectivity_;
};

}  // namespace

TetMesh parse_vtk(std::string_view text, const std::string& name, const Progress& report) {
  return VtkReader(text, name).read(report);
}

}  // namespace prosector
