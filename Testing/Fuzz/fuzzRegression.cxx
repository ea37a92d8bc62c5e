// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Runs a fuzz target over files and folders of files, with any compiler. A folder without a file
// is an error, so that a lost corpus does not look like a passed test.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char* argv[])
{
  namespace fs = std::filesystem;
  std::size_t total = 0;
  for (int i = 1; i < argc; ++i)
  {
    std::vector<fs::path> files;
    if (fs::is_directory(argv[i]))
    {
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(argv[i]))
      {
        if (entry.is_regular_file())
        {
          files.push_back(entry.path());
        }
      }
    }
    else
    {
      files.emplace_back(argv[i]);
    }
    if (files.empty())
    {
      std::cerr << argv[i] << ": no files\n";
      return 1;
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
    {
      std::ifstream stream(file, std::ios::binary);
      if (!stream)
      {
        std::cerr << file << ": cannot be read\n";
        return 1;
      }
      const std::vector<char> bytes{ std::istreambuf_iterator<char>(stream), {} };
      // A copy of the exact size lets AddressSanitizer see every read beyond the end.
      const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
      std::cout << file.string() << std::endl;
      LLVMFuzzerTestOneInput(exact.data(), exact.size());
      ++total;
    }
  }
  std::cout << total << " inputs\n";
  return total > 0 ? 0 : 1;
}
