#include "common/anatomy/import_reply.h"

#include <algorithm>
#include <cstring>

#include "common/anatomy/counted_bytes.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::uint64_t magic = 0x31504d4950525350;  // "PSRPIMP1"
constexpr std::size_t max_refusal = 4096;

}  // namespace

std::vector<std::uint8_t> encode(const ImportReply& reply) {
  const auto* head = reinterpret_cast<const std::uint8_t*>(&magic);
  std::vector<std::uint8_t> out(head, head + sizeof(magic));
  put(out, reply.refusal.substr(0, max_refusal));
  put(out, reply.mesh.positions);
  put(out, reply.mesh.triangles);
  return out;
}

ImportReply decode_import_reply(std::span<const std::uint8_t> bytes) {
  ImportReply out;
  const bool ours = bytes.size() >= sizeof(magic) && std::memcmp(bytes.data(), &magic, sizeof(magic)) == 0;
  std::span<const std::uint8_t> body = ours ? bytes.subspan(sizeof(magic)) : bytes;
  if (!ours || !get(body, out.refusal) || !get(body, out.mesh.positions) || !get(body, out.mesh.triangles) ||
      !body.empty())
    throw InputError("its reader's answer is not whole");
  const std::size_t vertices = out.mesh.positions.size();
  for (const auto& t : out.mesh.triangles)
    if (std::ranges::any_of(t, [&](std::uint32_t v) { return v >= vertices; }))
      throw InputError("its reader named a vertex that isn't there");
  return out;
}

}  // namespace prosector
