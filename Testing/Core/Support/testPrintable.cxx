// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunError.h"
#include "gatunPrintable.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
using gatun::MakePrintable;

TEST(Printable, KeepsText)
{
  for (const std::string text : { "", "von Mises stress [MPa]", "a\tb\nc", "\xc3\xa9t\xc3\xa9",
         "\xe6\x98\x93\xe7\xbb\x8f", "\xf0\x9f\x8c\x8d", "\xf4\x8f\xbf\xbf", "\xed\x9f\xbf" })
  {
    EXPECT_EQ(MakePrintable(text), text);
  }
}

TEST(Printable, ShowsOtherBytes)
{
  EXPECT_EQ(MakePrintable("w\xe1ve"), "w\\xe1ve");
  EXPECT_EQ(MakePrintable("\x1b[31mred\x7f"), "\\x1b[31mred\\x7f");
  EXPECT_EQ(MakePrintable("\xc2\x9b"), "\\xc2\\x9b");          // a control character, too
  EXPECT_EQ(MakePrintable("\xc0\xaf"), "\\xc0\\xaf");          // longer than need be
  EXPECT_EQ(MakePrintable("\xe0\x9f\xbf"), "\\xe0\\x9f\\xbf"); // the same
  EXPECT_EQ(MakePrintable("\xed\xa0\x80"), "\\xed\\xa0\\x80"); // a surrogate
  EXPECT_EQ(MakePrintable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(MakePrintable("\xe6\x98"), "\\xe6\\x98"); // ends too early
  EXPECT_EQ(MakePrintable("\xc3x"), "\\xc3x");
  EXPECT_EQ(MakePrintable(std::string("\0\xff", 2)), "\\x00\\xff");
}

TEST(Printable, MessagesOfErrorsAre)
{
  const std::string name = "w\xe1ve\x1b[2J";
  const gatun::Error one(gatun::ErrorCode::Corrupt, name);
  EXPECT_STREQ(one.what(), "w\\xe1ve\\x1b[2J");
  const gatun::Error other(
    gatun::ErrorCode::Corrupt, { .Path = name, .What = name, .Problem = "is damaged" });
  EXPECT_STREQ(other.what(), "w\\xe1ve\\x1b[2J: w\\xe1ve\\x1b[2J is damaged");
  EXPECT_EQ(other.Path, name);
}
}
