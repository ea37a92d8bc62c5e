// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVersion.h"

#include <gtest/gtest.h>

#include <string>

TEST(Version, LibraryAgreesWithItsHeaders)
{
  EXPECT_EQ(gatun::PackageVersion(),
    std::to_string(GATUN_VERSION_MAJOR) + "." + std::to_string(GATUN_VERSION_MINOR) + "." +
      std::to_string(GATUN_VERSION_PATCH));
  EXPECT_EQ(gatun::FormatVersion(), std::to_string(GATUN_FORMAT_VERSION));
}
