// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunPortFile_h
#define gatunPortFile_h

// Hashes, and files of which there are only hashes.

#include "gatunByteSource.h"
#include "gatunContainer.h"
#include "gatunError.h"

#include <array>
#include <cstdio>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gatun::port
{
/** The hash of all that was added. */
class Hash
{
public:
  void Add(std::span<const std::uint8_t> bytes)
  {
    const std::array<std::uint64_t, 2> both{ this->Sum, Checksum(bytes) };
    std::array<std::uint8_t, 16> joined{};
    for (std::size_t i = 0; i < joined.size(); ++i)
    {
      joined[i] = static_cast<std::uint8_t>(both[i / 8] >> (8 * (i % 8)));
    }
    this->Sum = Checksum(joined);
  }

  template <typename T>
  void Add(const std::vector<T>& values)
  {
    this->Add(
      std::span(reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)));
  }

  std::string GetText() const
  {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(this->Sum));
    return text.data();
  }

private:
  std::uint64_t Sum = 0;
};

/** What is printed of a file. */
struct Line
{
  Hash Decoded;
  std::map<std::string, Hash> Encoded; // by ways to write

  std::string GetText() const
  {
    std::string text = " decoded " + this->Decoded.GetText();
    for (const auto& [way, hash] : this->Encoded)
    {
      text += " " + way + " " + hash.GetText();
    }
    return text;
  }
};

/** Writes a file, adds its bytes to a hash, uses it, and removes it. */
inline void AddBytesOf(Hash& hash, const std::function<void(const std::string&)>& write,
  const std::function<void(const std::string&)>& use = {})
{
  static int depth = 0;
  const std::string path = "portHashes" + std::to_string(depth++) + ".tmp";
  write(path);
  {
    const auto source = OpenFile(path);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(source->GetSize()));
    std::span<std::uint8_t> rest(bytes);
    if (source->ReadAt(0, rest) != 0 || !rest.empty())
    {
      throw Error(ErrorCode::CannotOpen, { .Path = path, .What = "cannot read" });
    }
    hash.Add(bytes);
  }
  if (use)
  {
    use(path);
  }
  std::remove(path.c_str());
  --depth;
}
}

#endif
