// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Golden files with layers. They must be read as by an independent decoder, which was written from
// Documentation/format.md alone. See Testing/Python/make_golden.py.

#include "gatunFileReader.h"
#include "gatunGolden.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdio>
#include <sstream>

namespace gatun
{
namespace
{
/** Lines as in expected.json. */
std::string Describe(const FileReader& file, const std::string& name)
{
  const Layers& layers = file.GetLayers();
  std::ostringstream out;
  out << "= " << name << "\narray " << layers.Array << " component "
      << (layers.Component < 0 ? static_cast<int>(file.GetArrays()[layers.Array].Components)
                               : layers.Component)
      << " spacing " << static_cast<int>(layers.Spacing) << " layers " << layers.GetCount()
      << "\nbounds";
  for (const double bound : layers.Bounds)
  {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx",
      static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(bound)));
    out << " " << text.data();
  }
  out << "\nchunks";
  for (const LayerSpan& span : layers.Chunks)
  {
    out << " " << span.First << "-" << span.Last;
  }
  out << "\n";
  for (std::size_t i = 0; i < file.GetLevels().size(); ++i)
  {
    out << Describe(*file.OpenLevel(i), name + ", base mesh " + std::to_string(i + 1));
  }
  return out.str();
}

TEST(LayerGolden, FilesAreReadAsAnIndependentDecoderDoes)
{
  const auto expected = test::ReadExpectedLines("layers");
  EXPECT_GT(expected.size(), 3u);
  for (const auto& [name, lines] : expected)
  {
    const FileReader file((test::GetGoldenFolder() / name).string());
    EXPECT_TRUE(VerifyFile(file)) << name;
    EXPECT_EQ(Describe(file, name), lines);
  }
}
}
}
