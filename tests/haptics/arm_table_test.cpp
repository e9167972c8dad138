// The table of arms, and what is written about it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "common/error.h"
#include "drivers/device/arm.h"
#include "tests/folders.h"

namespace prosector {
namespace {

TEST(ArmTable, EachDriverIsInTheDocumentation) {
  std::stringstream page;
  page << std::ifstream(source_path("docs/do/arms.md")).rdbuf();
  for (const ArmRow& row : arm_drivers())
    EXPECT_NE(page.str().find("| `" + std::string(row.name) + ":"), std::string::npos) << row.name;
}

TEST(ArmTable, WhatItHelpsWithIsAnAddress) {
  for (const ArmRow& row : arm_drivers()) {
    const std::string help = row.help;
    const auto at = help.find(std::string(row.name) + ":");
    ASSERT_NE(at, std::string::npos) << help;
    EXPECT_EQ(parse_arm_address(help.substr(at)).driver, row.name);
  }
}

TEST(ArmTable, AnUnknownDriverIsToldWhichThereAre) {
  try {
    open_arm("phantom:0", {});
    FAIL();
  } catch (const InputError& error) {
    for (const ArmRow& row : arm_drivers())
      EXPECT_NE(std::string(error.what()).find(row.name), std::string::npos) << row.name;
  }
}

}  // namespace
}  // namespace prosector
