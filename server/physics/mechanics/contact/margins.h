#pragma once
// Search distances of contact detection.

namespace prosector::contact {

inline constexpr double contact_margin = 0.002;  // m: gaps up to this may close within the tick
inline constexpr double wake_margin = 0.003;     // m
inline constexpr double most_reach = 0.05;       // m per tick: contacts of faster bodies are found late

}  // namespace prosector::contact
