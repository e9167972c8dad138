#include "common/anatomy/import_reply.h"

#include <algorithm>
#include <cstring>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::uint64_t magic = 0x31504d4950525350;  // "PSRPIMP1"
constexpr std::size_t max_refusal = 4096;

template <class Values>
void put(std::vector<std::uint8_t>& out, const Values& values) {
  const std::uint64_t count = values.size();
  const auto* c = reinterpret_cast<const std::uint8_t*>(&count);
  out.insert(out.end(), c, c + sizeof(count));
  const auto* p = reinterpret_cast<const std::uint8_t*>(values.data());
  out.insert(out.end(), p, p + count * sizeof(typename Values::value_type));
}

/// Takes what is next off `in`; false: it isn't whole.
template <class Values>
bool get(std::span<const std::uint8_t>& in, Values& values) {
  using T = typename Values::value_type;
  std::uint64_t count = 0;
  if (in.size() < sizeof(count)) return false;
  std::memcpy(&count, in.data(), sizeof(count));
  in = in.subspan(sizeof(count));
  if (count > in.size() / sizeof(T)) return false;
  values.resize(count);
  // memcpy must not be given the null pointer of an empty vector.
  if (count > 0) std::memcpy(static_cast<void*>(values.data()), in.data(), count * sizeof(T));
  in = in.subspan(count * sizeof(T));
  return true;
}

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
