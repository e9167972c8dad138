#pragma once
// Operations of topology as bytes.

#include "common/byte_stream.h"
#include "server/physics/cutting/blade_stroke.h"
#include "server/physics/cutting/topology_op.h"

namespace prosector {

void add(ByteWriter& out, const TopologyOp& op);
TopologyOp read_op(ByteReader& in);

void add(ByteWriter& out, const BladeStroke& stroke);
BladeStroke read_stroke(ByteReader& in);

}  // namespace prosector
