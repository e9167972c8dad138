#pragma once
// Sends PartState, what users made of each body and which hands hold it, whenever that changes.

#include <vector>

#include "server/physics/simulation.h"
#include "server/session/people/session.h"

namespace prosector {

class PartSender {
 public:
  /// Returns messages for the bodies whose part state (changes by participants, and hands that hold the body)
  /// differs from the last call. A body that was never changed or held has no message.
  std::vector<Outgoing> take(const Simulation& simulation);

 private:
  struct PublishedPart {
    Part part;
    std::vector<HandRef> holders;
    bool operator==(const PublishedPart&) const = default;
  };
  std::vector<PublishedPart> published_;  // by body; clients without a PartState assume `PublishedPart{}`
};

}  // namespace prosector
