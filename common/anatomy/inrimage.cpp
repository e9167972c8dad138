// INRIMAGE-4 format: a text header of KEY=value lines padded to a multiple of 256 bytes, then the voxels, x
// fastest.

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "common/anatomy/voxels.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::string_view magic = "#INRIMAGE-4#{";

template <class T>
T number(const std::map<std::string, std::string, std::less<>>& fields, const std::string& key, T fallback,
         const std::string& name) {
  const auto it = fields.find(key);
  if (it == fields.end()) return fallback;
  T value{};
  const auto [end, error] = std::from_chars(it->second.data(), it->second.data() + it->second.size(), value);
  if (error != std::errc{} || end == it->second.data())
    throw InputError(fmt::format("{}: header: {}=\"{}\" is not a number", name, key, it->second));
  return value;
}

}  // namespace

bool is_inrimage(std::span<const std::uint8_t> head) {
  return head.size() >= magic.size() &&
         std::string_view(reinterpret_cast<const char*>(head.data()), magic.size()) == magic;
}

VolumeHeader parse_inrimage_header(std::span<const std::uint8_t> head, const std::string& name) {
  const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
  const std::size_t end = text.find("##}\n");
  if (end == std::string_view::npos)
    throw InputError(fmt::format("{}: header: no closing \"##}}\" in the first {} bytes", name, head.size()));
  std::map<std::string, std::string, std::less<>> fields;
  for (std::size_t at = magic.size(); at < end;) {
    const std::size_t stop = std::min(text.find('\n', at), end);
    const std::string_view line = text.substr(at, stop - at);
    if (const auto equals = line.find('='); equals != std::string_view::npos)
      fields[std::string(line.substr(0, equals))] = std::string(line.substr(equals + 1));
    at = stop + 1;
  }

  VolumeHeader h;
  h.offset = (end + 4 + 255) / 256 * 256;
  const std::array<const char*, 3> dims = {"XDIM", "YDIM", "ZDIM"}, sizes = {"VX", "VY", "VZ"};
  for (std::size_t k = 0; k < 3; ++k) {
    h.dims[k] = number<std::int64_t>(fields, dims[k], 0, name);
    constexpr double millimetre = 1e-3;
    h.voxel_size[static_cast<int>(k)] = millimetre * number<double>(fields, sizes[k], 1.0, name);
  }
  if (number<int>(fields, "VDIM", 1, name) != 1)
    throw InputError(
        fmt::format("{}: header: VDIM={}; allowed: 1 (one value per voxel)", name, fields["VDIM"]));
  const int bits = number<int>(fields, "PIXSIZE", 8, name);
  const std::string type = fields.contains("TYPE") ? fields["TYPE"] : "unsigned fixed";
  const std::map<std::pair<std::string, int>, VoxelType> types = {
      {{"unsigned fixed", 8}, VoxelType::uint8},   {{"signed fixed", 8}, VoxelType::int8},
      {{"unsigned fixed", 16}, VoxelType::uint16}, {{"signed fixed", 16}, VoxelType::int16},
      {{"unsigned fixed", 32}, VoxelType::uint32}, {{"signed fixed", 32}, VoxelType::int32},
      {{"unsigned fixed", 64}, VoxelType::uint64}, {{"signed fixed", 64}, VoxelType::int64},
      {{"float", 32}, VoxelType::float32},         {{"float", 64}, VoxelType::float64}};
  const auto it = types.find({type, bits});
  if (it == types.end())
    throw InputError(fmt::format(
        "{}: header: TYPE={}, PIXSIZE={} bits; allowed: unsigned fixed or signed fixed of 8, 16, 32 or 64, "
        "float of 32 or 64 bits",
        name, type, bits));
  h.type = it->second;
  const std::string cpu = fields.contains("CPU") ? fields["CPU"] : "decm";
  h.big_endian = cpu == "sun" || cpu == "sgi";
  if (!h.big_endian && cpu != "decm" && cpu != "pc" && cpu != "alpha")
    throw InputError(fmt::format(
        "{}: header: CPU={}; allowed: decm, pc, alpha (little endian), sun, sgi (big endian)", name, cpu));
  return h;
}

}  // namespace prosector
