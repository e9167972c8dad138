#include "server/physics/mechanics/organs/organ.h"

#include <utility>

#include "common/assert.h"
#include "common/error.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/cutting/touched.h"

namespace prosector::organs {
namespace {

// Fraction of the tetrahedra. If more are split, a full update of the skin costs little more than an
// incremental one, and runs in parallel.
constexpr double much_share = 0.1;

}  // namespace

Organ::Organ(std::size_t body, const Anatomy& anatomy, double density, std::vector<std::uint8_t> held)
    : whole_(without_edge_nodes(anatomy)),
      held_(std::move(held)),
      complex_(uncut(density)),
      skin_(complex_, std::make_shared<const cutting::OuterShape>(complex_, whole_.surface)),
      tree_(complex_),
      grouping_(complex_, body) {}

cutting::TetComplex Organ::uncut(double density) const {
  return whole_.quads.empty() ? cutting::TetComplex(whole_.tets, density)
                              : cutting::TetComplex::of_sheet(whole_, density, held_);
}

cutting::CutResult Organ::cut(std::span<const Vec3> positions, std::span<const Vec3> edge,
                              cutting::BladeStroke& blade, ParticipantId author, std::uint64_t stroke) {
  cutting::CutResult result = prosector::cutting::cut(complex_, tree_, positions, edge, blade);
  if (result.ops.empty()) return result;
  OrganChange& change = log_.emplace_back();
  change.author = author;
  change.stroke = stroke;
  change.ops = result.ops;
  const bool much =
      much_share * static_cast<double>(complex_.tets()) < static_cast<double>(result.split_tets);
  cutting::Skin::Change skin;
  parallel_both([&] { change.touched = cutting::touched_by(complex_, change.ops); },
                [&] {
                  if (much) skin = skin_.update(complex_);
                });
  grouping_.note_touched(complex_, change.touched);
  if (!much) skin = skin_.follow(complex_, change.touched);
  PROSECTOR_ASSERT(is_ascending(change.touched));
  grouping_.note_skin(skin);
  return result;
}

Refusal Organ::undo(ParticipantId author) {
  const std::vector<OrganChange*> stroke = stroke_of(log_, author);
  if (stroke.empty()) return "you have no cut to undo";
  if (Refusal why = why_not_undone(log_, stroke)) return why;
  const cutting::TetComplex before = complex_;
  try {
    take_back(stroke);
  } catch (const InputError& error) {  // a dependency that touched_by() does not cover: nothing is undone
    complex_ = before;
    for (OrganChange* change : stroke) change->taken_back = false;
    grouping_.note_from(log_.size());
    return error.what();
  }
  OrganChange entry;
  entry.cause = TopologyCause::undo;
  entry.author = author;
  entry.stroke = stroke.front()->stroke;
  std::vector<cutting::TetId> touched;
  for (const OrganChange* change : stroke)
    touched.insert(touched.end(), change->touched.begin(), change->touched.end());
  grouping_.note_skin(skin_.follow(complex_, touched));
  log_.push_back(std::move(entry));
  return {};
}

void Organ::take_back(const std::vector<OrganChange*>& newest_first) {
  for (OrganChange* change : newest_first) {
    PROSECTOR_ASSERT(change != nullptr && change->cause == TopologyCause::cut && !change->taken_back);
    for (auto op = change->ops.rbegin(); op != change->ops.rend(); ++op) {
      complex_.take_back(*op);
      if (const auto* split = std::get_if<cutting::SplitEdge>(&*op)) grouping_.note_joined(complex_, *split);
    }
    change->taken_back = true;
    grouping_.note_touched(complex_, change->touched);
  }
}

Regrouped Organ::regroup(std::size_t next_body) {
  return grouping_.regroup(complex_, next_body, log_.size());
}

void Organ::follow(const PieceEdit& edit) {
  PROSECTOR_ASSERT(grouping_.has(edit.body));
  grouping_.follow(complex_, edit, log_.size());
}

}  // namespace prosector::organs
