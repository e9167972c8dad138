#include "server/physics/organs/topology_op_io.h"

namespace prosector {
namespace {

enum class Kind : std::uint8_t { split_edge, slit_faces, part_node };
constexpr std::size_t most_listed = 1 << 24;

struct Write {
  ByteWriter& out;
  void operator()(const SplitEdge& op) const {
    out.add(Kind::split_edge);
    for (const std::uint32_t n : {op.a, op.b, op.node, op.first, op.count}) out.add(n);
    out.add(op.t);
  }
  void operator()(const SlitFaces& op) const {
    out.add(Kind::slit_faces);
    out.add(static_cast<std::uint64_t>(op.faces.size()));
    for (const auto& pair : op.faces)
      for (const TetId tet : pair) out.add(tet);
  }
  void operator()(const PartNode& op) const {
    out.add(Kind::part_node);
    out.add(op.node);
    out.add(static_cast<std::uint64_t>(op.copies.size()));
    for (const PartNode::Copy& copy : op.copies) {
      out.add(copy.node);
      out.add(static_cast<std::uint64_t>(copy.tets.size()));
      for (const TetId tet : copy.tets) out.add(tet);
    }
  }
};

}  // namespace

void add(ByteWriter& out, const TopologyOp& op) {
  std::visit(Write{out}, op);
}

TopologyOp read_op(ByteReader& in) {
  const auto kind = in.number<Kind>();
  if (kind == Kind::split_edge) {
    SplitEdge op;
    for (std::uint32_t* n : {&op.a, &op.b, &op.node, &op.first, &op.count}) *n = in.number<std::uint32_t>();
    op.t = in.number<double>();
    return op;
  }
  if (kind == Kind::slit_faces) {
    SlitFaces op;
    op.faces.resize(in.count(most_listed));
    for (auto& pair : op.faces)
      for (TetId& tet : pair) tet = in.number<TetId>();
    return op;
  }
  in.require(kind == Kind::part_node, "an unknown operation");
  PartNode op;
  op.node = in.number<NodeId>();
  op.copies.resize(in.count(most_listed));
  for (PartNode::Copy& copy : op.copies) {
    copy.node = in.number<NodeId>();
    copy.tets.resize(in.count(most_listed));
    for (TetId& tet : copy.tets) tet = in.number<TetId>();
  }
  return op;
}

void add(ByteWriter& out, const BladeStroke& stroke) {
  out.add(static_cast<std::uint64_t>(stroke.edge.size()));
  for (const BladeStroke::EdgePoint& p : stroke.edge) {
    out.add(p.at);
    out.add(p.room);
    out.add(p.tet);
    for (const double w : p.weight) out.add(w);
  }
  out.add(static_cast<std::uint8_t>(stroke.ended_inside));
  out.add(stroke.way);
  out.add(static_cast<std::uint64_t>(stroke.marks.size()));
  for (const BladeStroke::Mark& mark : stroke.marks) {
    out.add(mark.node);
    out.add(mark.point);
    out.add(mark.normal);
  }
}

BladeStroke read_stroke(ByteReader& in) {
  BladeStroke out;
  out.edge.resize(in.count(most_listed));
  for (BladeStroke::EdgePoint& p : out.edge) {
    p.at = in.number<double>();
    in.require(p.at >= (&p == out.edge.data() ? 0 : (&p)[-1].at) && p.at < most_listed, "a line in disorder");
    p.room = in.vector();
    p.tet = in.number<TetId>();
    for (double& w : p.weight) w = in.number<double>();
  }
  out.ended_inside = in.flag();
  out.way = in.vector();
  out.marks.resize(in.count(most_listed));
  for (BladeStroke::Mark& mark : out.marks) {
    mark.node = in.number<NodeId>();
    mark.point = in.vector();
    mark.normal = in.vector();
  }
  return out;
}

}  // namespace prosector
