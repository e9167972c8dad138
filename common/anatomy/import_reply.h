#pragma once
// Output of prosector-import in serialised form: a mesh, or the reason why there is none.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

struct ImportReply {
  TriangleMesh mesh;    // in the file's units, node transforms applied; positions may be NaN or infinite
  std::string refusal;  // the reader's error message; empty: the mesh is complete
  std::vector<std::string> notes = {};  // one line each: content of the file that is not used
};

std::vector<std::uint8_t> encode(const ImportReply& reply);

/// Decodes the output of prosector-import, a mesh or the reason why there is none. Throws InputError if the
/// bytes are not exactly one reply or a triangle refers to a missing vertex.
ImportReply decode_import_reply(std::span<const std::uint8_t> bytes);

}  // namespace prosector
