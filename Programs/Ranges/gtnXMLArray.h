// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnXMLArray_h
#define gtnXMLArray_h

// An array in the appended data of one of VTK's XML files.

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

class vtkDataCompressor;
class vtkInputStream;

namespace gtn
{
/** The appended data of a file. */
struct XMLData
{
  std::string File;
  std::ifstream Stream;
  std::uint64_t FileSize = 0;
  std::uint64_t Begin = 0; ///< of the appended data
  unsigned HeaderWord = 4; ///< bytes of a number in the headers of arrays
  bool IsBase64 = false;
  bool IsSwapped = false;                        ///< in the other byte order
  vtkSmartPointer<vtkDataCompressor> Compressor; ///< null: not compressed
};

/** Reads ranges of the values of an array. vtkXMLDataParser can do so, too, but it reads the table
 * of all compressed blocks for each range, and relies on what it says. */
class XMLArray
{
public:
  /** data: lives longer. offset: within the appended data. type: of the values, such as VTK_FLOAT.
   * name: for messages. Throws Failure. */
  XMLArray(XMLData& data, std::uint64_t offset, int type, const std::string& name);

  int GetType() const { return this->Type; }

  /** The number of values. */
  std::uint64_t GetSize() const { return this->Bytes / this->WordSize; }

  /** Reads values of the type that they have. Throws Failure, also if there are not as many. */
  void Read(std::uint64_t begin, std::size_t count, void* values);

  /** Reads integers. */
  template <typename T>
  void ReadAs(std::uint64_t begin, std::size_t count, std::vector<T>& values);

private:
  void ReadHeader(std::uint64_t position);
  void ReadBlockTable(std::uint64_t position);
  void ReadBytes(std::uint64_t begin, std::span<std::uint8_t> bytes);
  void ReadStream(std::uint64_t position, std::uint64_t skip, std::span<std::uint8_t> bytes);
  void ReadBlock(std::size_t block);
  std::vector<std::uint64_t> ReadWords(std::uint64_t position, std::uint64_t skip, std::size_t n);
  [[noreturn]] void Fail(const std::string& problem) const;

  XMLData& Data;
  const int Type;
  const std::string Name;
  std::size_t WordSize = 1;
  vtkSmartPointer<vtkInputStream> Input;
  std::uint64_t Bytes = 0;
  std::uint64_t Position = 0; // where the stream with the values begins
  std::uint64_t Skip = 0;     // what comes before them in it

  // If the values are compressed.
  std::size_t BlockSize = 0;
  std::vector<std::uint64_t> BlockEnds;
  std::vector<std::uint8_t> Block; // the one that was read last
  std::size_t BlockNumber = 0;
};
}

#endif
