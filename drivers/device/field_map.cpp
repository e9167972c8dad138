#include "drivers/device/field_map.h"

#include <fmt/format.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "common/error.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/regular_file.h"
#include "common/toml_nesting.h"

namespace prosector {
namespace {

constexpr double most_number = 1e6;

/// Reads the keys of a field map file; all of them are required.
class MapReader {
 public:
  MapReader(const toml::table& table, const std::string& file) : table_(table), file_(file) {}

  double number(std::string_view key, double least, double most) const {
    const auto v = at(key).is_number() ? at(key).value<double>() : std::nullopt;
    if (!v || !(*v >= least && *v <= most))
      fail(key, fmt::format("must be a number from {} to {}", least, most));
    return *v;
  }

  Vec3 vector(std::string_view key, double least, double most) const {
    Vec3 out;
    if (!read_row(at(key), std::span(out.data(), 3)) || out.minCoeff() < least || out.maxCoeff() > most)
      fail(key, fmt::format("must be three numbers from {} to {}", least, most));
    return out;
  }

  template <std::size_t N>
  std::vector<std::array<double, N>> rows(std::string_view key, std::size_t most_rows) const {
    const toml::array* array = at(key).as_array();
    if (array == nullptr || array->size() > most_rows)
      fail(key, fmt::format("must be at most {} rows of {} numbers", most_rows, N));
    std::vector<std::array<double, N>> out(array->size());
    for (std::size_t i = 0; i < out.size(); ++i)
      if (!read_row((*array)[i], out[i])) fail(key, fmt::format("row {} must be {} numbers", i + 1, N));
    return out;
  }

  [[noreturn]] void fail(std::string_view key, const std::string& what) const {
    const toml::node* node = table_.get(key);
    throw InputError(fmt::format("{}:{}: {}: {}", file_,
                                 node == nullptr ? table_.source().begin.line : node->source().begin.line,
                                 key, what));
  }

  void reject_unknown_keys(std::initializer_list<std::string_view> known) const {
    for (const auto& [key, node] : table_)
      if (std::find(known.begin(), known.end(), key.str()) == known.end())
        fail(key.str(), "unknown key of a field map: remove it");
  }

 private:
  const toml::node& at(std::string_view key) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) fail(key, "is missing");
    return *node;
  }

  static bool read_row(const toml::node& node, std::span<double> out) {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != out.size()) return false;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const auto v = (*array)[i].is_number() ? (*array)[i].value<double>() : std::nullopt;
      if (!v || !(std::abs(*v) <= most_number)) return false;
      out[i] = *v;
    }
    return true;
  }

  const toml::table& table_;
  const std::string& file_;
};

FieldTerms to_terms(const std::vector<std::array<double, 7>>& rows) {
  FieldTerms out(static_cast<Eigen::Index>(rows.size()), 7);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < 7; ++k)
      out(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = rows[i][k];
  return out;
}

std::string to_text(const FieldTerms& terms) {
  std::string out = "[\n";
  for (Eigen::Index i = 0; i < terms.rows(); ++i) {
    out += "  [";
    for (Eigen::Index k = 0; k < 7; ++k) out += fmt::format("{}{}", k == 0 ? "" : ", ", terms(i, k));
    out += "],\n";
  }
  return out + "]\n";
}

std::string to_text(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

FieldMap read_map(const MapReader& reader) {
  reader.reject_unknown_keys(
      {"version", "centre", "half", "before", "after", "degree", "polynomial", "nodes", "weights"});
  (void)reader.number("version", 1, 1);
  FieldMap map;
  map.centre = reader.vector("centre", -max_coordinate, max_coordinate);
  map.half = reader.vector("half", 1e-3, max_coordinate);
  map.before = reader.number("before", 0, max_coordinate);
  map.after = reader.number("after", 0, max_coordinate);
  const double degree = reader.number("degree", 0, most_field_degree);
  if (degree != std::floor(degree)) reader.fail("degree", "must be a whole number");
  map.degree = static_cast<int>(degree);
  const std::size_t count = field_term_count(map.degree);
  map.polynomial = to_terms(reader.rows<7>("polynomial", count));
  if (static_cast<std::size_t>(map.polynomial.rows()) != count)
    reader.fail("polynomial",
                fmt::format("must have {} rows at degree {}, one for each term of the polynomial", count,
                            map.degree));
  for (const auto& row : reader.rows<3>("nodes", most_field_nodes)) map.nodes.emplace_back(row.data());
  map.weights = to_terms(reader.rows<7>("weights", most_field_nodes));
  if (static_cast<std::size_t>(map.weights.rows()) != map.nodes.size())
    reader.fail("weights", fmt::format("must have a row for each of the {} nodes", map.nodes.size()));
  return map;
}

}  // namespace

Vec3 FieldMap::scaled(const Vec3& place) const {
  return ((place - centre).cwiseQuotient(half)).cwiseMax(-1).cwiseMin(1);
}

Pose FieldMap::apply(const Pose& reported) const {
  const Vec3 x = scaled(reported.p);
  Eigen::Matrix<double, 1, 7> y = field_terms(x, degree).transpose() * polynomial;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    y += (x - nodes[i]).norm() * weights.row(static_cast<Eigen::Index>(i));
  const Quat turn(y[3], y[4], y[5], y[6]);
  constexpr double least_norm = 0.5;  // a quaternion with a smaller norm counts as the identity
  const Quat unit = turn.norm() < least_norm ? Quat::Identity() : turn.normalized();
  return {reported.p + y.head<3>().transpose(), (unit * reported.q).normalized()};
}

std::size_t field_term_count(int degree) {
  const auto n = static_cast<std::size_t>(degree);
  return (n + 1) * (n + 2) * (n + 3) / 6;
}

VecX field_terms(const Vec3& x, int degree) {
  std::array<std::array<double, most_field_degree + 1>, 3> t{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double u = x[static_cast<Eigen::Index>(axis)];
    t[axis][0] = 1;
    t[axis][1] = u;
    for (std::size_t k = 2; k <= most_field_degree; ++k) t[axis][k] = 2 * u * t[axis][k - 1] - t[axis][k - 2];
  }
  VecX out(static_cast<Eigen::Index>(field_term_count(degree)));
  Eigen::Index at = 0;
  const auto n = static_cast<std::size_t>(degree);
  for (std::size_t a = 0; a <= n; ++a)
    for (std::size_t b = 0; a + b <= n; ++b)
      for (std::size_t c = 0; a + b + c <= n; ++c) out[at++] = t[0][a] * t[1][b] * t[2][c];
  return out;
}

FieldMap parse_field_map(const std::string& toml, const std::string& file) {
  check_nesting(toml, file);
  try {
    const toml::table table = toml::parse(toml, file);
    return read_map({table, file});
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}:{}: {}", file, e.source().begin.line, e.description()));
  }
}

FieldMap load_field_map(const std::filesystem::path& file) {
  constexpr std::size_t max_bytes = 1 << 22;
  return parse_field_map(read_regular_file(file, max_bytes), file.string());
}

std::string write_field_map(const FieldMap& map) {
  std::string out =
      "# Correction of a tracker's poses for field distortion, written by `prosector-client calibrate "
      "field`.\n";
  out += "version = 1\n";
  out +=
      fmt::format("before = {}  # m RMS at the sampled points\nafter = {}  # m RMS to expect between them\n",
                  map.before, map.after);
  out += fmt::format("centre = {}  # m, device frame, of the sampled box\nhalf = {}\n", to_text(map.centre),
                     to_text(map.half));
  out += fmt::format("degree = {}\n# Rows: x y z (m), quaternion w x y z.\npolynomial = {}", map.degree,
                     to_text(map.polynomial));
  out += "nodes = [\n";
  for (const Vec3& node : map.nodes) out += fmt::format("  {},\n", to_text(node));
  return out + "]\nweights = " + to_text(map.weights);
}

}  // namespace prosector
