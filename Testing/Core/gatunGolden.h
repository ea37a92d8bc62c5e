// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunGolden_h
#define gatunGolden_h

// Golden files, and the lines of their expected.json, which tell in a form of their own what the
// description of arrays does not: merges, layers and volumes.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace gatun::test
{
inline std::filesystem::path GetGoldenFolder()
{
  return std::filesystem::path(GATUN_TEST_DATA) / "Golden";
}

/** The lines of a kind, "merges", "layers" or "volumes", by names of files. Python writes each list
 * and each text as a line. */
inline std::map<std::string, std::string> ReadExpectedLines(const std::string& kind)
{
  std::ifstream in(GetGoldenFolder() / "expected.json");
  std::map<std::string, std::string> all;
  std::string line;
  while (std::getline(in, line) && line != " \"" + kind + "\": {")
  {
  }
  std::string name;
  while (std::getline(in, line) && line[1] != '}')
  {
    const auto first = line.find('"');
    if (first == std::string::npos)
    {
      continue; // the end of a list
    }
    const auto text = line.substr(first + 1, line.rfind('"') - first - 1);
    if (line.back() == '[')
    {
      name = text;
    }
    else
    {
      all[name] += text + "\n";
    }
  }
  return all;
}
}

#endif
