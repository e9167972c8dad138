// The page about sources of devices has a section for each driver.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "drivers/device/arm.h"
#include "drivers/device/driver_table.h"
#include "tests/folders.h"

namespace prosector {
namespace {

/// Returns the section whose heading names a driver; empty: there is none.
std::string section_of(const std::string& page, const std::string& driver) {
  std::istringstream lines(page);
  std::string out, line;
  bool inside = false;
  while (std::getline(lines, line)) {
    if (line.starts_with("## ")) inside = line.find("`" + driver + "`") != std::string::npos;
    if (inside) out += line + "\n";
  }
  return out;
}

TEST(DevicePage, SaysOfEachDriverWhereItIsFromAndWhatIsNotTried) {
  std::stringstream page;
  page << std::ifstream(source_path("docs/look-up/devices.md")).rdbuf();
  std::vector<std::string> names;
  for (const DriverRow& row : drivers()) names.emplace_back(row.name);
  for (const ArmRow& row : arm_drivers()) names.emplace_back(row.name);
  for (const std::string& name : names) {
    const std::string section = section_of(page.str(), name);
    for (const char* part : {"| Constant | Source |", "Compared with:", "Not tried on hardware:"})
      EXPECT_NE(section.find(part), std::string::npos) << name << " lacks: " << part;
  }
}

}  // namespace
}  // namespace prosector
