// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBessel.h"
#include "gatunNumberText.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{
using namespace gatun;

TEST(Numbers, TextsComeBack)
{
  for (const double number : { 0.0, 1.0, -0.1, 1.0 / 3, 1e-5, 6.02214076e23,
         std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min() })
  {
    double same = -1;
    EXPECT_TRUE(ParseNumber(FormatNumber(number), same));
    EXPECT_EQ(same, number);
  }
  EXPECT_EQ(FormatNumber(0.1), "0.1");
}

TEST(Numbers, OtherTextsAreRefused)
{
  double number = 0;
  for (const std::string text : { "", "x", "1x", " 1", "1 ", "+1", "1,5", "1e", "--1" })
  {
    EXPECT_FALSE(ParseNumber(text, number)) << text;
  }
}

#if defined(__cpp_lib_math_special_functions)
TEST(Numbers, BesselFunctionIsThatOfTheStandard)
{
  for (double x = 0; x < 40; x += 0.25)
  {
    const double expected = std::cyl_bessel_i(0, x);
    EXPECT_NEAR(GetBessel(x), expected, 1e-13 * expected) << x;
  }
}
#endif
}
