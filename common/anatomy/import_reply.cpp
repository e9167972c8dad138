#include "common/anatomy/import_reply.h"

#include <algorithm>

#include "common/byte_stream.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::uint64_t magic = 0x31504d4950525350;  // "PSRPIMP1"
constexpr std::size_t max_refusal = 4096;

}  // namespace

std::vector<std::uint8_t> encode(const ImportReply& reply) {
  ByteWriter out;
  out.add(magic);
  out.add_all(reply.refusal.substr(0, max_refusal));
  out.add_all(reply.mesh.positions);
  out.add_all(reply.mesh.triangles);
  return out.take();
}

ImportReply decode_import_reply(std::span<const std::uint8_t> bytes) {
  ImportReply out;
  ByteReader in(bytes, "its reader's answer");
  in.require(in.bits<std::uint64_t>() == magic, "another beginning");
  in.read_all(out.refusal);
  in.read_all(out.mesh.positions);
  in.read_all(out.mesh.triangles);
  in.end();
  const std::size_t vertices = out.mesh.positions.size();
  for (const auto& t : out.mesh.triangles)
    if (std::ranges::any_of(t, [&](std::uint32_t v) { return v >= vertices; }))
      throw InputError("its reader named a vertex that isn't there");
  return out;
}

}  // namespace prosector
