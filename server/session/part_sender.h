#pragma once
// PartState: what people made of each body and who holds it, whenever that changes.

#include <vector>

#include "server/physics/simulation.h"
#include "server/session/session.h"

namespace prosector {

class PartSender {
 public:
  /// Returns the states that differ from what was last taken; for bodies that nobody ever changed or held,
  /// none.
  std::vector<Outgoing> take(const Simulation& simulation);

 private:
  struct Told {
    Part part;
    std::vector<HandRef> holders;
    bool operator==(const Told&) const = default;
  };
  std::vector<Told> told_;  // by body; those who know nothing take a body to be as a Told{} has it
};

}  // namespace prosector
