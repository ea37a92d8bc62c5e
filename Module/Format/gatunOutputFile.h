// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunOutputFile_h
#define gatunOutputFile_h

#include "gatunAtomicFile.h"
#include "gatunContainer.h"
#include "gatunExtents.h"
#include "gatunInputFile.h"

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace gatun
{
/**
 * Writes a container section by section. The file appears at its path with Commit; without it, the
 * destructor discards the file. Methods throw Error(CannotWrite).
 */
class OutputFile
{
public:
  OutputFile(const std::string& path, const ContainerKind& kind);

  /** A file that begins with the sections of another one, which it replaces. Those of the outdated
   * name become free. AddShared finds whole sections of it, and of meshes in it. Commit fails if
   * the other file has changed. */
  OutputFile(const InputFile& before, FourCC outdated);

  /** Tells a constructor that the file will be embedded in another one as a section. */
  struct Embedded
  {
  };

  /** Such a file, which never has a name. */
  OutputFile(Embedded, const OutputFile& whole);

  /** The sections of one of several processes that write a file together, in a scratch file in a
   * folder. */
  explicit OutputFile(const std::string& folder);

  /** Tells a constructor that several processes write the file. */
  struct Common
  {
  };

  /** The file that such processes write together. Its temporary file has a name. */
  OutputFile(Common, const std::string& path);

  /** Appends a section. Returns the offset of its payload. */
  std::uint64_t AddSection(
    FourCC name, std::span<const std::uint8_t> payload, std::uint16_t flags = FlagMandatory);

  /** Completes another file and embeds it as a section that is not mandatory. Returns the size of
   * that file. */
  std::uint64_t AddSection(FourCC name, OutputFile& part);

  /** The same, but stores sections and streams that are equal to earlier ones of this file, byte by
   * byte, only once. Returns the bytes that were added. */
  std::uint64_t AddShared(FourCC name, OutputFile& part);

  /** Tells the streams of the section that was added last, in ascending order, so that AddShared
   * compares them one by one. */
  void DivideLast(std::span<const StreamRef* const> streams);

  /** The number of bytes so far, with the header of the file. */
  std::uint64_t GetSize() const;

  const std::vector<SectionRef>& GetSections() const { return this->Sections; }
  const std::string& GetTemporary() const { return this->Data.GetTemporary(); }

  /** Takes sections that another process writes, which are bytes begin to end there. Returns their
   * offset here. */
  std::uint64_t AddSections(
    const std::vector<SectionRef>& sections, std::uint64_t begin, std::uint64_t end);

  /** Copies bytes of sections into the temporary file of another process. */
  void CopyTo(
    const std::string& temporary, std::uint64_t from, std::uint64_t to, std::uint64_t bytes) const
  {
    this->Data.CopyTo(temporary, from, to, bytes);
  }

  /** Writes directory and trailer and moves the file to its path. Returns the file's size. */
  std::uint64_t Commit();

private:
  void WriteHeader();
  void WriteSectionHeader(const SectionRef& section);
  void WriteEnd();
  void AddPart(
    SectionRef section, const OutputFile& part, const Bytes& list, std::span<const Extent> extents);
  std::vector<Extent> FindExtents(const OutputFile& part);
  std::vector<StreamRef> ListCandidates() const;
  void AddPieces(const InputFile& before);
  bool IsEqual(
    std::uint64_t offset, const OutputFile& part, std::uint64_t place, std::uint64_t length) const;

  const ContainerKind& Kind;
  AtomicFile Data;
  Bytes Header;
  std::vector<SectionRef> Sections;
  std::vector<StreamRef> Pieces;                      // that other files may share, ascending
  std::size_t Indexed = 0;                            // of the pieces
  std::unordered_map<std::uint64_t, StreamRef> Index; // of the pieces, by their checksums
};
}

#endif
