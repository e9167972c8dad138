#pragma once
// Poses offered to other software: tracked hands, heads and held tools.

#include <string>
#include <vector>

#include "client/replica/replica.h"

namespace prosector {

inline constexpr std::size_t longest_offered_name = 20;  // bytes: limit of OpenIGTLink

struct Offered {
  std::string name;  // unique name: "Ann.right", "Ann.left", "Ann.head", "scalpel"
  Pose pose;         // room frame, m: of a wrist, of the eyes, or of a body
};

/// Returns the poses to publish to other software at a tick (simulation step, may be fractional): tracked
/// heads and hands of all participants, and rigid bodies that they hold.
std::vector<Offered> offered(const Replica& replica, double tick);

/// Makes the objects' names valid for other software: letters, digits, '-', '_' and '.', at most
/// longest_offered_name bytes, unique. A short suffix from the last '.' is preserved.
void make_names_valid(std::vector<Offered>& all);

}  // namespace prosector
