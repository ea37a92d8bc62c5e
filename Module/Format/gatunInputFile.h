// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunInputFile_h
#define gatunInputFile_h

#include "gatunByteSource.h"
#include "gatunContainer.h"
#include "gatunError.h"
#include "gatunExtents.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** Reads a container. The constructor checks header, trailer and directory. Thread safe. Safe on
 * hostile input: the memory used is bounded by the length of the file. */
class InputFile
{
public:
  /** path: the name of the source in messages. */
  InputFile(std::shared_ptr<const ByteSource> source, const std::string& path,
    const ContainerKind& kind = MeshContainer);

  /** A file on disk. */
  explicit InputFile(const std::string& path, const ContainerKind& kind = MeshContainer)
    : InputFile(OpenFile(path), path, kind)
  {
  }

  /** A file that is embedded in another one as a section. Messages add the name to the path. */
  InputFile(const InputFile& whole, const StreamRef& section, const std::string& name);

  const std::string& GetPath() const { return this->Path; }
  std::uint64_t GetSize() const { return this->Size; }
  std::uint32_t GetVersion() const { return this->Kind.Version; } ///< of the format
  std::uint64_t GetBytesRead() const { return this->BytesRead; }
  const std::vector<SectionRef>& GetSections() const { return this->Sections; }

  /** Reads a stream and checks its checksum. what: the name of the stream in messages. */
  Bytes Read(const StreamRef& stream, const std::string& what) const;

  /** Calls use(bytes) for consecutive parts of a stream of any length, and checks its checksum at
   * the end. */
  void ReadInParts(const StreamRef& stream, const std::string& what,
    const std::function<void(std::span<const std::uint8_t>)>& use) const;

  /** Checks the checksum of a stream of any length. */
  void CheckSum(const StreamRef& stream, const std::string& what) const;

  /** The place of a stream in the whole file, unless it is in several parts there. */
  std::optional<StreamRef> FindInWhole(const StreamRef& stream) const;

  /** That of the whole file. */
  const ByteSource& GetSource() const { return *this->Source; }

  /** Adds where a stream is in the whole file. */
  void AddRanges(const StreamRef& stream, std::vector<ByteRange>& ranges) const;

  /** Tells a remote source that streams will be read, so that few requests bring them. Streams
   * outside of the file count for nothing; reading them fails. */
  void Announce(const std::vector<StreamRef>& streams) const;

  /** Runs read, which reads streams. If the source does not have one of them, the error asks for
   * all that follow it closely. */
  template <typename Run>
  void ReadTogether(const std::vector<StreamRef>& streams, Run&& read) const
  {
    this->Announce(streams);
    try
    {
      read();
    }
    catch (const Error& error)
    {
      if (error.Code != ErrorCode::NotHere)
      {
        throw;
      }
      this->FailTogether(streams, error);
    }
  }

  /** Adds the bytes that tell what is in a container with a position here. */
  static void AddEnds(const StreamRef& container, std::vector<StreamRef>& streams);

  /** The payloads of the sections of a name. */
  std::vector<StreamRef> FindSections(FourCC name) const;

  /** The payload of the only section of a name; throws unless there is exactly one. */
  StreamRef FindSection(FourCC name, const char* what) const;

  /** Checks the headers and checksums of all sections, and that they fill the file without gaps. */
  void CheckSections(const std::function<bool(double)>& progress) const;

  /** Throws an error of this file. offset counts from the beginning of this container. The other
   * parts of the message: see ErrorDetails. */
  [[noreturn]] void Fail(ErrorCode code, const std::string& what,
    std::optional<std::uint64_t> offset = {}, const std::string& problem = {},
    int systemError = 0) const;

  /** Runs decode. Adds file, name and position of the stream to errors that lack them. */
  template <typename Decode>
  auto Guarded(const std::string& what, const StreamRef& where, Decode&& decode) const
  {
    try
    {
      return decode();
    }
    catch (const Error& error)
    {
      if (error.Code != ErrorCode::Corrupt || !error.Path.empty())
      {
        throw;
      }
      this->Fail(
        ErrorCode::Corrupt, what, where.Offset, std::string("is damaged: ") + error.what());
    }
  }

private:
  void ReadAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const;
  void ReadEnd(std::uint64_t offset, std::span<std::uint8_t> bytes) const;
  [[noreturn]] void FailNotHere(std::uint64_t offset, std::uint64_t length) const;
  [[noreturn]] void FailTogether(const std::vector<StreamRef>& streams, const Error& error) const;
  std::vector<ByteRange> FindRanges(const std::vector<StreamRef>& streams) const;
  ExtentMap::Place Locate(std::uint64_t offset) const;
  void ReadExtents(const InputFile& whole, const StreamRef& section, const std::string& name);
  void CheckVersion(const SectionRef& section) const;
  void ReadHeader(std::span<std::uint8_t, HeaderSize> header);
  StreamRef ReadTrailer(std::span<const std::uint8_t> header, Bytes& directory) const;
  void ReadSections(const Bytes& directory);
  void ReadDirectory();
  bool IsInside(const StreamRef& stream) const
  {
    return stream.Offset <= this->Size && stream.Length <= this->Size - stream.Offset;
  }
  void CheckInside(const StreamRef& stream, const std::string& what) const;
  [[noreturn]] void FailSum(const StreamRef& stream, const std::string& what) const;

  const ContainerKind& Kind;
  std::string Path;
  std::string Part;                         // the name of an embedded file
  std::shared_ptr<const ByteSource> Source; // of the whole file, for all files in it
  std::uint64_t Base = 0;                   // the position of an embedded file
  std::shared_ptr<const ExtentMap> Extents; // in which that is, if it is not in one piece
  std::uint64_t Size = 0;
  std::vector<SectionRef> Sections;
  mutable std::atomic<std::uint64_t> BytesRead{ 0 };
};
}

#endif
