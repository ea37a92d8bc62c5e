// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Damages what is inside of a file and makes the checksums right again: damageFile IN OUT SEED. The
// changes of tables and streams are those of fuzzSections.cxx.

#include "fuzzInput.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

namespace
{
std::minstd_rand Random;

std::size_t TakeBelow(std::size_t end)
{
  return end == 0 ? 0 : Random() % end;
}
}

/** In place of libFuzzer's: a bit, a byte, some bytes, or bytes that are copied, inserted or left
 * out.
 */
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most)
{
  const auto at = TakeBelow(size);
  const auto count = std::min(size - at, 1 + TakeBelow(16));
  switch (size == 0 ? 3 : TakeBelow(6))
  {
    case 0:
      data[at] ^= static_cast<std::uint8_t>(1u << TakeBelow(8));
      return size;
    case 1:
      std::generate_n(data + at, count, [] { return static_cast<std::uint8_t>(Random()); });
      return size;
    case 2:
      std::copy_n(std::vector(data + at, data + at + count).begin(), count,
        data + TakeBelow(size - count + 1));
      return size;
    case 3:
    {
      const auto room = std::min(most - size, 1 + TakeBelow(8));
      std::copy_backward(data + at, data + size, data + size + room);
      std::generate_n(data + at, room, [] { return static_cast<std::uint8_t>(Random()); });
      return size + room;
    }
    case 4:
      std::copy(data + at + count, data + size, data + at);
      return size - count;
    default:
      data[at] = TakeBelow(2) == 0 ? 0 : 255;
      return size;
  }
}

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: damageFile IN OUT SEED\n";
    return 2;
  }
  std::ifstream in(argv[1], std::ios::binary);
  std::vector<char> bytes{ std::istreambuf_iterator<char>(in), {} };
  if (bytes.empty())
  {
    std::cerr << "damageFile: " << argv[1] << ": cannot be read\n";
    return 1;
  }
  Random.seed(static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10)) + 1);
  auto size = bytes.size();
  bytes.resize(2 * size + 1024);
  for (auto changes = 1 + TakeBelow(3); changes > 0; --changes)
  {
    size = LLVMFuzzerCustomMutator(reinterpret_cast<std::uint8_t*>(bytes.data()), size,
      bytes.size(), static_cast<unsigned>(Random()));
  }
  std::ofstream out(argv[2], std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(size));
  out.close();
  return out ? 0 : 1;
}
