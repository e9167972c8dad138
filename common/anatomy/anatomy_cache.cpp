#include "common/anatomy/anatomy_cache.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "common/byte_stream.h"
#include "common/error.h"
#include "common/sealed_file.h"

namespace prosector {
namespace {

constexpr std::size_t max_remarks = 64;

std::filesystem::path file_of(const std::filesystem::path& dir, const ContentHash& key) {
  return dir / (to_hex(key) + ".anatomy");
}

/// Returns the key of the sealed file: the version of its layout and the hash of the mesh's source.
std::string seal_key(const ContentHash& key) {
  return "anatomy 4 " + to_hex(key);
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

/// Reads an anatomy. Returns false if the bytes are incomplete or invalid.
bool read(std::span<const std::uint8_t> bytes, CachedAnatomy& out) try {
  ByteReader in(bytes, "anatomy");
  Anatomy& a = out.anatomy;
  in.read_all(a.tets.positions);
  in.read_all(a.tets.tets);
  in.read_all(a.surface.positions);
  in.read_all(a.surface.triangles);
  in.read_all(a.embedding.rows);
  out.expected_volume = in.number<double>();
  for (std::size_t remarks = in.count(max_remarks); remarks > 0; --remarks)
    in.read_all(out.remarks.emplace_back());
  return in.done();
} catch (const InputError&) {
  return false;
}

}  // namespace

CachedAnatomyResult load_cached(const std::filesystem::path& dir, const ContentHash& key) {
  if (dir.empty()) return {};
  const SealedFileResult found = read_sealed_file(file_of(dir, key), seal_key(key));
  if (!found.bytes) return {std::nullopt, found.error};
  CachedAnatomy out;
  if (!read(*found.bytes, out) || !consistent(out.anatomy)) return {std::nullopt, "is damaged"};
  return {std::move(out), ""};
}

bool store_cached(const std::filesystem::path& dir, const ContentHash& key, const CachedAnatomy& made) {
  if (dir.empty()) return false;
  const Anatomy& a = made.anatomy;
  ByteWriter body;
  body.add_all(a.tets.positions);
  body.add_all(a.tets.tets);
  body.add_all(a.surface.positions);
  body.add_all(a.surface.triangles);
  body.add_all(a.embedding.rows);
  body.add(made.expected_volume);
  const std::size_t remarks = std::min(made.remarks.size(), max_remarks);
  body.add(static_cast<std::uint64_t>(remarks));
  for (std::size_t i = 0; i < remarks; ++i) body.add_all(made.remarks[i]);
  return write_sealed_file(file_of(dir, key), seal_key(key), body.bytes());
}

}  // namespace prosector
