#include <cmath>
#include <unordered_map>

#include "common/anatomy/mesh_cells.h"
#include "common/anatomy/tet_io.h"
#include "common/anatomy/token_reader.h"

namespace prosector {
namespace {

class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& name) : in_(text, name) {}

  TetMesh read(const Progress& report) {
    std::string_view first = in_.word();
    while (!first.empty() && first != "$MeshFormat" && first != "$NOD") first = in_.word();
    if (first.empty())
      in_.fail("the file has neither $MeshFormat nor $NOD; allowed: Gmsh 1, 2.2 or 4.1 ASCII");
    first == "$NOD" ? read_1() : read_2_or_4();
    cells_.report(report);
    return std::move(mesh_);
  }

 private:
  /// Reads format 1, after `$NOD`.
  void read_1() {
    nodes_2();
    if (!in_.skip_to("$ELM")) in_.fail("no $ELM");
    elements_1();
  }
  /// Reads formats 2.2 and 4.1, after `$MeshFormat`.
  void read_2_or_4() {
    const auto version = in_.number<double>("format version");
    const bool old = version == 2.2;
    if (!old && version != 4.1) in_.fail(fmt::format("format version {}; allowed: 2.2 or 4.1", version));
    if (in_.number<int>("file type") != 0) in_.fail("binary file; allowed: ASCII");
    for (std::string_view w = in_.word(); !w.empty(); w = in_.word()) {
      if (w == "$Nodes") old ? nodes_2() : nodes_4();
      if (w == "$Elements") old ? elements_2() : elements_4();
    }
  }
  void add_node(std::uint64_t tag) {
    Vec3 x;
    for (int k = 0; k < 3; ++k) x[k] = in_.number<double>("a coordinate");
    numbers_[tag] = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(x);
  }
  const CellKind& kind(int type) const {
    const CellKind* kind = gmsh_cell(type);
    if (kind == nullptr) in_.fail(unknown_cell(static_cast<std::uint64_t>(type)));
    return *kind;
  }
  /// Reads an element's nodes and adds it; a cell of fewer dimensions is skipped.
  void add_cell(const CellKind& kind) {
    if (kind.shape == CellShape::flat) {
      in_.rest();
      cells_.skip(kind);
      return;
    }
    corners_.clear();
    for (std::size_t left = corners_of(kind.shape); left > 0; --left) {
      const auto tag = in_.number<std::uint64_t>("a node number");
      const auto it = numbers_.find(tag);
      if (it == numbers_.end())
        in_.fail(fmt::format("an element uses node {}, which does not exist in the file", tag));
      corners_.push_back(it->second);
    }
    for (std::size_t k = corners_.size(); k < kind.nodes; ++k) in_.number<std::uint64_t>("a node number");
    cells_.add(kind, corners_, mesh_);
  }
  void nodes_2() {
    for (auto n = in_.count("number of nodes"); n > 0; --n)
      add_node(in_.number<std::uint64_t>("a node number"));
  }
  void elements_1() {
    for (auto n = in_.count("number of elements"); n > 0; --n) {
      in_.number<std::uint64_t>("an element number");
      const CellKind& type = kind(in_.number<int>("an element type"));
      for (int k = 0; k < 2; ++k) in_.number<std::int64_t>("a region");
      const auto nodes = in_.count("number of nodes");
      if (type.shape != CellShape::flat && nodes != type.nodes)
        in_.fail(fmt::format("{} nodes; allowed: {}", nodes, type.nodes));
      add_cell(type);
    }
  }
  void elements_2() {
    for (auto n = in_.count("number of elements"); n > 0; --n) {
      in_.number<std::uint64_t>("an element number");
      const CellKind& type = kind(in_.number<int>("an element type"));
      for (auto tags = in_.count("number of tags"); tags > 0; --tags) in_.number<std::int64_t>("a tag");
      add_cell(type);
    }
  }
  void nodes_4() {
    auto blocks = in_.count("number of node blocks");
    for (int k = 0; k < 3; ++k) in_.number<std::uint64_t>("a node count");
    for (; blocks > 0; --blocks) {
      for (int k = 0; k < 2; ++k) in_.number<int>("an entity");
      if (in_.number<int>("parametric flag") != 0)
        in_.fail("the file has parametric nodes; allowed: nodes without parameters");
      std::vector<std::uint64_t> tags(in_.count("number of nodes"));
      for (auto& tag : tags) tag = in_.number<std::uint64_t>("a node number");
      for (const auto tag : tags) add_node(tag);
    }
  }
  void elements_4() {
    auto blocks = in_.count("number of element blocks");
    for (int k = 0; k < 3; ++k) in_.number<std::uint64_t>("an element count");
    for (; blocks > 0; --blocks) {
      for (int k = 0; k < 2; ++k) in_.number<int>("an entity");
      const CellKind& type = kind(in_.number<int>("an element type"));
      for (auto n = in_.count("number of elements"); n > 0; --n) {
        in_.number<std::uint64_t>("an element number");
        add_cell(type);
      }
    }
  }

  TokenReader in_;
  TetMesh mesh_;
  CellCollector cells_;
  std::vector<std::uint32_t> corners_;  // of the current element
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

}  // namespace

TetMesh parse_gmsh(std::string_view text, const std::string& name, const Progress& report) {
  return GmshReader(text, name).read(report);
}

}  // namespace prosector
