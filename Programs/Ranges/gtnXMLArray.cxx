// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnXMLArray.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include "vtkBase64InputStream.h"
#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkDataCompressor.h"
#include "vtkInputStream.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cstring>
#include <ios>
#include <type_traits>

namespace gtn
{
//------------------------------------------------------------------------------
XMLArray::XMLArray(XMLData& data, std::uint64_t offset, int type, const std::string& name)
  : Data(data)
  , Type(type)
  , Name(name)
  , WordSize(static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(type)))
{
  this->Input = data.IsBase64
    ? vtkSmartPointer<vtkInputStream>(vtkSmartPointer<vtkBase64InputStream>::New())
    : vtkSmartPointer<vtkInputStream>::New();
  this->Input->SetStream(&data.Stream);
  if (offset > data.FileSize || data.Begin > data.FileSize - offset)
  {
    this->Fail("begins behind the end of the file");
  }
  if (data.Compressor)
  {
    this->ReadBlockTable(data.Begin + offset);
  }
  else
  {
    this->ReadHeader(data.Begin + offset);
  }
  // In text, three bytes take four.
  if (!data.Compressor && this->Bytes > data.FileSize)
  {
    this->Fail("reaches behind the end of the file");
  }
}

//------------------------------------------------------------------------------
void XMLArray::Fail(const std::string& problem) const
{
  throw Failure(this->Data.File, "the array '" + MakePrintableLine(this->Name) + "' " + problem);
}

//------------------------------------------------------------------------------
void XMLArray::ReadHeader(std::uint64_t position)
{
  this->Bytes = this->ReadWords(position, 0, 1).front();
  this->Position = position;
  this->Skip = this->Data.HeaderWord;
}

//------------------------------------------------------------------------------
void XMLArray::ReadBlockTable(std::uint64_t position)
{
  const auto sizes = this->ReadWords(position, 0, 3);
  const std::uint64_t blocks = sizes[0];
  constexpr std::uint64_t largest = std::uint64_t{ 256 } << 20;
  if (blocks > this->Data.FileSize / this->Data.HeaderWord)
  {
    this->Fail("has more compressed blocks than the file can hold");
  }
  if ((sizes[1] == 0 && blocks > 0) || sizes[1] > largest || sizes[2] > sizes[1])
  {
    this->Fail("has compressed blocks of a wrong size");
  }
  this->BlockSize = static_cast<std::size_t>(sizes[1]);
  this->Bytes = blocks == 0 ? 0 : (blocks - (sizes[2] > 0)) * sizes[1] + sizes[2];
  const auto header = this->Data.HeaderWord;
  this->BlockEnds = this->ReadWords(position, 3 * header, static_cast<std::size_t>(blocks));
  std::uint64_t end = 0;
  for (std::uint64_t& size : this->BlockEnds)
  {
    if (size > this->Data.FileSize || end > this->Data.FileSize - size)
    {
      this->Fail("reaches behind the end of the file");
    }
    end += size;
    size = end;
  }
  // In base64, header and blocks are encoded separately.
  const std::uint64_t headerBytes = header * (3 + blocks);
  this->Position = position + (this->Data.IsBase64 ? (headerBytes + 2) / 3 * 4 : headerBytes);
  this->BlockNumber = this->BlockEnds.size();
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> XMLArray::ReadWords(
  std::uint64_t position, std::uint64_t skip, std::size_t n)
{
  const std::size_t size = this->Data.HeaderWord;
  std::vector<std::uint8_t> bytes(n * size);
  this->ReadStream(position, skip, bytes);
  if (this->Data.IsSwapped)
  {
    vtkByteSwap::SwapVoidRange(bytes.data(), n, size);
  }
  std::vector<std::uint64_t> words(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    std::memcpy(&words[i], bytes.data() + i * size, size); // the least byte comes first
  }
  return words;
}

//------------------------------------------------------------------------------
void XMLArray::ReadStream(std::uint64_t position, std::uint64_t skip, std::span<std::uint8_t> bytes)
{
  if (bytes.empty())
  {
    return;
  }
  this->Data.Stream.clear();
  this->Data.Stream.seekg(static_cast<std::streamoff>(position));
  this->Input->StartReading();
  const bool good = this->Input->Seek(static_cast<vtkTypeInt64>(skip)) != 0 &&
    this->Input->Read(bytes.data(), bytes.size()) == bytes.size();
  this->Input->EndReading();
  if (!good)
  {
    this->Fail("reaches behind the end of the file");
  }
}

//------------------------------------------------------------------------------
void XMLArray::ReadBlock(std::size_t block)
{
  if (block == this->BlockNumber)
  {
    return;
  }
  const std::uint64_t begin = block > 0 ? this->BlockEnds[block - 1] : 0;
  std::vector<std::uint8_t> compressed(static_cast<std::size_t>(this->BlockEnds[block] - begin));
  this->ReadStream(this->Position, begin, compressed);
  const std::uint64_t first = static_cast<std::uint64_t>(block) * this->BlockSize;
  this->Block.resize(
    static_cast<std::size_t>(std::min<std::uint64_t>(this->BlockSize, this->Bytes - first)));
  this->BlockNumber = this->BlockEnds.size();
  if (this->Data.Compressor->Uncompress(compressed.data(), compressed.size(), this->Block.data(),
        this->Block.size()) != this->Block.size())
  {
    this->Fail("cannot be decompressed");
  }
  this->BlockNumber = block;
}

//------------------------------------------------------------------------------
void XMLArray::ReadBytes(std::uint64_t begin, std::span<std::uint8_t> bytes)
{
  if (!this->Data.Compressor)
  {
    this->ReadStream(this->Position, this->Skip + begin, bytes);
    return;
  }
  while (!bytes.empty())
  {
    const auto place = static_cast<std::size_t>(begin % this->BlockSize);
    this->ReadBlock(static_cast<std::size_t>(begin / this->BlockSize));
    const std::size_t part = std::min(bytes.size(), this->Block.size() - place);
    std::copy_n(this->Block.begin() + static_cast<std::ptrdiff_t>(place), part, bytes.begin());
    bytes = bytes.subspan(part);
    begin += part;
  }
}

//------------------------------------------------------------------------------
void XMLArray::Read(std::uint64_t begin, std::size_t count, void* values)
{
  if (begin > this->GetSize() || count > this->GetSize() - begin)
  {
    this->Fail("has too few values");
  }
  this->ReadBytes(
    begin * this->WordSize, { static_cast<std::uint8_t*>(values), count * this->WordSize });
  if (this->Data.IsSwapped && this->WordSize > 1)
  {
    vtkByteSwap::SwapVoidRange(values, count, this->WordSize);
  }
}

//------------------------------------------------------------------------------
template <typename T>
void XMLArray::ReadAs(std::uint64_t begin, std::size_t count, std::vector<T>& values)
{
  values.resize(count);
  switch (this->Type)
  {
    vtkTemplateMacro(
      if constexpr (!std::is_integral_v<VTK_TT>) { this->Fail("should have integers"); } else {
        std::vector<VTK_TT> raw(count);
        this->Read(begin, count, raw.data());
        std::transform(raw.begin(), raw.end(), values.begin(),
          [](VTK_TT value) { return static_cast<T>(value); });
      });
    default:
      this->Fail("should have integers");
  }
}

template void XMLArray::ReadAs(std::uint64_t, std::size_t, std::vector<std::int64_t>&);
}
