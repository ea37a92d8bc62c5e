// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPlyFile_h
#define gtnPlyFile_h

// The header of a .ply file, and its values one after the other.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gtn
{
struct PlyProperty
{
  std::string Name;
  int Type = 0;      ///< a type of VTK
  int CountType = 0; ///< of a list; otherwise 0
};

struct PlyElement
{
  std::string Name;
  std::uint64_t Count = 0;
  std::vector<PlyProperty> Properties;
};

class PlyFile
{
public:
  /** Reads the header of a file, whose bytes must outlive the object. Throws Failure, as the other
   * functions do: also if the file is shorter than the header says. */
  explicit PlyFile(std::string_view bytes);

  const std::vector<PlyElement>& GetElements() const { return this->Elements; }
  bool IsText() const { return this->Text; }

  /** The next value. */
  double Take(int type);

  /** The number of values of the list that comes next, which the file has room for. */
  std::uint64_t TakeCount(const PlyProperty& list);

  /** The bytes behind the values that were taken. */
  std::string_view GetRest() const { return this->Rest; }

private:
  void ReadHeader();
  void AddProperty(std::string_view words);
  std::uint64_t GetRoom(int type) const;
  void CheckSize() const;

  bool Text = false;
  bool Swapped = false;
  std::string_view Rest;
  std::vector<PlyElement> Elements;
};
}

#endif
