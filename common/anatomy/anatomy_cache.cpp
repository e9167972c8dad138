#include "common/anatomy/anatomy_cache.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "common/anatomy/counted_bytes.h"
#include "common/sealed_file.h"

namespace prosector {
namespace {

std::filesystem::path file_of(const std::filesystem::path& dir, const ContentHash& key) {
  return dir / (to_hex(key) + ".anatomy");
}

/// Returns what the file is sealed under: its layout, and what the mesh was made from.
std::string seal_key(const ContentHash& key) {
  return "anatomy 3 " + to_hex(key);
}

bool consistent(const Anatomy& a) {
  const auto in_range = [](const auto& cells, std::size_t count) {
    return std::all_of(cells.begin(), cells.end(), [&](const auto& cell) {
      return std::all_of(cell.begin(), cell.end(), [&](std::uint32_t v) { return v < count; });
    });
  };
  return in_range(a.tets.tets, a.tets.positions.size()) &&
         in_range(a.surface.triangles, a.surface.positions.size()) &&
         (a.embedding.rows.empty() || a.embedding.rows.size() == a.surface.positions.size()) &&
         std::all_of(a.embedding.rows.begin(), a.embedding.rows.end(), [&](const SparseMap::Row& row) {
           return std::all_of(row.node.begin(), row.node.end(),
                              [&](std::uint32_t n) { return n < a.tets.positions.size(); });
         });
}

}  // namespace

FoundAnatomy load_cached(const std::filesystem::path& dir, const ContentHash& key) {
  if (dir.empty()) return {};
  const FoundFile found = read_sealed(file_of(dir, key), seal_key(key));
  if (!found.bytes) return {std::nullopt, found.trouble};
  std::span<const std::uint8_t> body(*found.bytes);
  CachedAnatomy out;
  Anatomy& a = out.anatomy;
  const bool whole = get(body, a.tets.positions) && get(body, a.tets.tets) &&
                     get(body, a.surface.positions) && get(body, a.surface.triangles) &&
                     get(body, a.embedding.rows) && get(body, out.warning) && body.empty();
  if (!whole || !consistent(a)) return {std::nullopt, "is damaged"};
  return {std::move(out), ""};
}

bool store_cached(const std::filesystem::path& dir, const ContentHash& key, const CachedAnatomy& made) {
  if (dir.empty()) return false;
  const Anatomy& a = made.anatomy;
  std::vector<std::uint8_t> body;
  put(body, a.tets.positions);
  put(body, a.tets.tets);
  put(body, a.surface.positions);
  put(body, a.surface.triangles);
  put(body, a.embedding.rows);
  put(body, made.warning);
  return write_sealed(file_of(dir, key), seal_key(key), body);
}

}  // namespace prosector
