#pragma once
// Which DDS domains each area's tests have: tests run side by side, and a server's index is taken once a
// domain. A test adds a number of its own in its area. Scripts under e2e have 60 to 99; above 100, ports
// are those that the system gives away.

#include <cstdint>

namespace prosector::test::dds_domain {

inline constexpr std::uint32_t cyclone_bus = 10, cdr_fuzz = 22, network_log = 24, clock_jump = 26, peer = 28,
                               forgery = 30, process = 36, survival = 44, overload = 50, set_up = 54;

}  // namespace prosector::test::dds_domain
