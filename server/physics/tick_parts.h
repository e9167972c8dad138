#pragma once
// A tick in parts, where something kinematic is so fast that it would pass what it should press.
//
// Contacts are linear in a tick: normals are those of its start. A plate that goes farther in it than a
// surface cell is beyond the tissue, or deep inside it, before a contact could say where out is. So the tick
// is taken in equal parts, each with contacts of its own, for everything: what hangs together stays in step.

#include <span>
#include <utility>
#include <vector>

#include "server/physics/contact/colliders.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

class TickParts {
 public:
  /// Decides how many parts the tick has. They keep what is kinematic from going farther in one than tissue
  /// in its way can follow; 1 where nothing goes as far as a surface cell. Refreshes `colliders` where it has
  /// to look.
  TickParts(State& state, Colliders& colliders);

  int count() const { return count_; }
  double h() const { return h_; }  // s, of each
  /// Sets targets of kinematic bodies and hands for part k.
  void aim(int k);
  /// Sets them to what they are after the tick, and joins the rows that its parts left in the report.
  void finish(StepReport& report);

 private:
  struct Kinematic {
    std::size_t slot;
    Pose from, to;
  };
  void restart();

  State& state_;
  int count_;
  double h_;
  std::vector<Kinematic> kinematic_;
  std::vector<std::pair<Pose, Pose>> targets_;  // of hands, before and after
};

}  // namespace prosector
