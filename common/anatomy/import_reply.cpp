#include "common/anatomy/import_reply.h"

#include <algorithm>

#include "common/byte_stream.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::uint64_t magic = 0x32504d4950525350;  // "PSRPIMP2"
constexpr std::size_t max_refusal = 4096, max_notes = 32, max_note = 1024;

}  // namespace

std::vector<std::uint8_t> encode(const ImportReply& reply) {
  ByteWriter out;
  out.add(magic);
  out.add_all(reply.refusal.substr(0, max_refusal));
  const std::size_t notes = std::min(reply.notes.size(), max_notes);
  out.add(static_cast<std::uint64_t>(notes));
  for (std::size_t i = 0; i < notes; ++i) out.add_all(reply.notes[i].substr(0, max_note));
  out.add_all(reply.mesh.positions);
  out.add_all(reply.mesh.triangles);
  return out.take();
}

ImportReply decode_import_reply(std::span<const std::uint8_t> bytes) {
  ImportReply out;
  ByteReader in(bytes, "its reader's answer");
  in.require(in.bits<std::uint64_t>() == magic, "unexpected first bytes");
  in.read_all(out.refusal);
  for (std::size_t notes = in.count(max_notes); notes > 0; --notes) in.read_all(out.notes.emplace_back());
  in.read_all(out.mesh.positions);
  in.read_all(out.mesh.triangles);
  in.end();
  const std::size_t vertices = out.mesh.positions.size();
  for (const auto& t : out.mesh.triangles)
    if (std::ranges::any_of(t, [&](std::uint32_t v) { return v >= vertices; }))
      throw InputError("the program that reads it returned a triangle with a vertex that does not exist");
  return out;
}

}  // namespace prosector
