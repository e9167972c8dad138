#pragma once
// What is offered to other software: where tracked hands, heads and held tools are.

#include <string>
#include <vector>

#include "client/replica/replica.h"

namespace prosector {

inline constexpr std::size_t longest_offered_name = 20;  // bytes: as OpenIGTLink has room for

struct Offered {
  std::string name;  // "Ann.right", "Ann.left", "Ann.head", "scalpel"; each once
  Pose pose;         // room, m: a wrist's, the eyes', a body's
};

/// Returns what is tracked or held at that tick: of all participants, as everybody sees it.
std::vector<Offered> offered(const Replica& replica, double tick);

/// Gives each a name that other software bears: letters, digits, '-', '_' and '.', at most so long, and no
/// other's. What follows the last '.' is kept.
void make_names_plain(std::vector<Offered>& all);

}  // namespace prosector
