#pragma once
// What prosector-import says to whoever started it: a mesh, or why there is none, as bytes.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

struct ImportReply {
  TriangleMesh mesh;    // in the file's units, nodes' transforms applied; positions may be no finite numbers
  std::string refusal;  // the reader's words; empty: the mesh is what the file holds
  std::vector<std::string> notes = {};  // one line each: what of the file is not used
};

std::vector<std::uint8_t> encode(const ImportReply& reply);

/// Trusts nothing: throws InputError when the bytes are no whole reply or a triangle names no vertex.
ImportReply decode_import_reply(std::span<const std::uint8_t> bytes);

}  // namespace prosector
