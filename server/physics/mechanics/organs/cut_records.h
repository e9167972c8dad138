#pragma once
// Saved records of cuts (base/record.h): topology operations, logs, pieces and strokes of blades.

#include <type_traits>
#include <variant>

#include "server/physics/base/record.h"
#include "server/physics/mechanics/cutting/blade_stroke.h"
#include "server/physics/mechanics/organs/organ_log.h"
#include "server/physics/mechanics/organs/organ_pieces.h"

namespace prosector::organs {

inline constexpr std::size_t most_listed = 1 << 24;       // entries of one operation or stroke
inline constexpr std::size_t most_ops = 10'000'000;       // operations of one change
inline constexpr std::size_t most_changes = 10'000'000;   // changes of one log
inline constexpr std::size_t most_soft_bodies = 1 << 20;  // pieces included

template <class Io>
void entry(Io& io, typename Io::template Entry<cutting::SplitEdge>& op) {
  auto& [a, b, node, t, first, count] = op;
  io.number(a, "first end");
  io.number(b, "second end");
  io.number(node, "node");
  io.number(first, "first tetrahedron");
  io.number(count, "tetrahedra");
  io.number(t, "position along the edge");
}

template <class Io>
void entry(Io& io, typename Io::template Entry<cutting::SlitFaces>& op) {
  auto& [faces] = op;
  io.list(faces, most_listed, "face", [&](auto& pair) {
    for (auto& tet : pair) io.number(tet, "tetrahedron");
  });
}

template <class Io>
void entry(Io& io, typename Io::template Entry<cutting::PartNode>& op) {
  auto& [node, copies] = op;
  io.number(node, "node");
  io.list(copies, most_listed, "copy", [&](auto& copy) {
    auto& [new_node, tets] = copy;
    io.number(new_node, "node");
    io.list(tets, most_listed, "tetrahedron", [&](auto& tet) { io.number(tet, "id"); });
  });
}

template <class Io>
void entry(Io& io, typename Io::template Entry<cutting::TopologyOp>& op) {
  enum class Kind : std::uint8_t { split_edge, slit_faces, part_node };
  static_assert(std::variant_size_v<cutting::TopologyOp> == 3,
                "each operation has its Kind, in the variant's order");
  auto kind = static_cast<Kind>(op.index());
  io.number(kind, "operation");
  if constexpr (Io::reads) {
    if (kind == Kind::split_edge) op = cutting::SplitEdge();
    if (kind == Kind::slit_faces) op = cutting::SlitFaces();
    if (kind == Kind::part_node) op = cutting::PartNode();
    io.require(kind <= Kind::part_node, "an unknown operation");
  }
  std::visit([&](auto& known) { entry(io, known); }, op);
}

template <class Io>
void entry(Io& io, typename Io::template Entry<OrganLog>& log) {
  io.list(log, most_changes, "change", [&](auto& change) {
    // `touched` and `taken_back` are derived from the other members.
    auto& [cause, author, stroke, ops, touched, taken_back] = change;
    io.number(cause, "cause");
    io.number(author, "author");
    io.number(stroke, "stroke");
    io.list(ops, most_ops, "operation", [&](auto& op) { entry(io, op); });
  });
}

template <class Io>
void entry(Io& io, typename Io::template Entry<PieceMarks>& marks) {
  io.list(marks, most_soft_bodies, "piece", [&](auto& piece) {
    auto& [body, first] = piece;
    io.number(body, "body");
    io.optional(first, "has tetrahedra");
    if (first) io.number(*first, "first tetrahedron");
  });
}

template <class Io>
void entry(Io& io, typename Io::template Entry<cutting::BladeStroke>& stroke) {
  auto& [edge, marks, ended_inside, way] = stroke;
  double before = 0;
  io.list(edge, most_listed, "point", [&](auto& point) {
    auto& [at, room, tet, weight] = point;
    io.number(at, "position along the edge");
    io.require(at >= before && at < static_cast<double>(most_listed), "an inconsistent line");
    before = at;
    io.vector(room, "position");
    io.number(tet, "tetrahedron");
    for (auto& w : weight) io.number(w, "weight");
  });
  io.flag(ended_inside, "ended inside");
  io.vector(way, "last motion");
  io.list(marks, most_listed, "mark", [&](auto& mark) {
    auto& [node, point, normal] = mark;
    io.number(node, "node");
    io.vector(point, "position");
    io.vector(normal, "normal");
  });
}

}  // namespace prosector::organs
