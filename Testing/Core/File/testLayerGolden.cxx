// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Golden files with layers. They must be read as by an independent decoder, which was written from
// Documentation/format.md alone. See Testing/Python/make_golden_layers.py.

#include "gatunFileReader.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace gatun
{
namespace
{
/** Lines as in layers.txt. */
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
  const auto folder = std::filesystem::path(GATUN_TEST_DATA) / "Golden" / "v1.2";
  std::ifstream in(folder / "layers.txt");
  std::ostringstream expected;
  expected << in.rdbuf();
  ASSERT_GT(expected.str().size(), 500u);
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == ".gtn")
    {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::string all;
  for (const auto& path : paths)
  {
    const FileReader file(path.string());
    EXPECT_TRUE(VerifyFile(file)) << path;
    EXPECT_EQ(file.GetFormatVersion(), (std::pair{ 1, 2 })) << path;
    all += Describe(file, path.filename().string());
  }
  EXPECT_EQ(all, expected.str());
}
}
}
