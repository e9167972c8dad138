#pragma once
// How far around things contacts are looked for.

namespace prosector {

inline constexpr double contact_margin = 0.002;  // m: gaps up to it may close within the tick
inline constexpr double wake_margin = 0.003;     // m
inline constexpr double most_reach = 0.05;       // m a tick: faster things are met late

}  // namespace prosector
