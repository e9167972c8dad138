// STL format: text ("solid", "facet", "vertex x y z"), or binary: 80 bytes, a count, and 50 bytes per
// triangle.

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "common/anatomy/surface_formats.h"
#include "common/anatomy/token_reader.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t header_bytes = 80, head_bytes = 84, triangle_bytes = 50, normal_bytes = 12;

template <class T>
T little_endian(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

/// Returns the size in bytes of a binary file with this header; 0: the data is shorter than a header.
std::uint64_t stated_file_size(std::string_view bytes) {
  if (bytes.size() < head_bytes) return 0;
  return head_bytes + std::uint64_t{triangle_bytes} * little_endian<std::uint32_t>(bytes, header_bytes);
}

TriangleMesh parse_binary(std::string_view bytes) {
  TriangleMesh out;
  const auto count = little_endian<std::uint32_t>(bytes, header_bytes);
  out.positions.reserve(std::size_t{3} * count);
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::size_t corners = head_bytes + std::size_t{triangle_bytes} * t + normal_bytes;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 x;
      for (std::size_t c = 0; c < 3; ++c)
        x[static_cast<int>(c)] = static_cast<double>(little_endian<float>(bytes, corners + 12 * k + 4 * c));
      out.positions.push_back(x);
    }
    out.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return out;
}

bool is_word(std::string_view word, std::string_view wanted) {
  return std::ranges::equal(word, wanted,
                            [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

TriangleMesh parse_text(std::string_view bytes) {
  TriangleMesh out;
  TokenReader in(bytes, "");
  std::size_t corners = 0;
  for (std::string_view w = in.word(); !w.empty(); w = in.word()) {
    if (is_word(w, "solid") || is_word(w, "endsolid")) {
      in.rest();  // name
    } else if (is_word(w, "vertex")) {
      if (++corners > 3) in.fail("a facet has more than three vertices; allowed: triangles");
      Vec3 x;
      for (int k = 0; k < 3; ++k) x[k] = in.number<double>("a coordinate");
      out.positions.push_back(x);
    } else if (is_word(w, "endfacet")) {
      if (corners != 3) in.fail(fmt::format("a facet of {} vertices; allowed: 3", corners));
      corners = 0;
      const auto end = static_cast<std::uint32_t>(out.positions.size());
      out.triangles.push_back({end - 3, end - 2, end - 1});
    }
  }
  if (corners != 0) in.fail("the text ends within a facet: the file is truncated");
  return out;
}

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, std::vector<std::string>& notes) {
  const std::uint64_t claimed = stated_file_size(bytes);
  const bool whole = claimed != 0 && claimed <= bytes.size();
  const bool like_text = bytes.size() >= 5 && is_word(bytes.substr(0, 5), "solid");
  // Binary files may begin with "solid" too; they are recognised by their size.
  if (like_text && claimed != bytes.size()) {
    TriangleMesh mesh = parse_text(bytes);
    if (!mesh.triangles.empty() || !whole) return mesh;
  }
  if (!whole)
    throw InputError(
        claimed == 0
            ? fmt::format("the file has {} bytes: it is neither a text that begins with \"solid\" nor long "
                          "enough for a binary STL",
                          bytes.size())
            : fmt::format(
                  "its {} triangles need {} bytes, but it has {}: the file is truncated, or not an STL",
                  (claimed - head_bytes) / triangle_bytes, claimed, bytes.size()));
  if (claimed < bytes.size())
    notes.push_back(fmt::format("{} bytes after its last triangle are ignored", bytes.size() - claimed));
  return parse_binary(bytes);
}

}  // namespace prosector
