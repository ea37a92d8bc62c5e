// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunOutputFile_h
#define gatunOutputFile_h

#include "gatunAtomicFile.h"
#include "gatunContainer.h"

#include <cstdint>
#include <span>
#include <string>
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
  /** replaceReadOnly: whether to replace an existing file that this user may not write. */
  OutputFile(const std::string& path, bool replaceReadOnly, std::uint16_t minorVersion,
    const ContainerKind& kind = MeshContainer);

  /** A file that will be embedded in another one as a section. It never has a name. */
  OutputFile(const OutputFile& whole, std::uint16_t minorVersion);

  /** Changes the version. To be called before the first section is added. */
  void SetMinorVersion(std::uint16_t version);

  /** Appends a section. Returns the offset of its payload. */
  std::uint64_t AddSection(FourCC name, std::span<const std::uint8_t> payload,
    std::uint16_t flags = FlagMandatory, std::uint16_t version = SectionVersion);

  /** Completes another file and embeds it as a section that is not mandatory. Returns the size of
   * that file. */
  std::uint64_t AddSection(FourCC name, OutputFile& part);

  /** Writes directory and trailer and moves the file to its path. Returns the file's size. */
  std::uint64_t Commit();

private:
  void WriteSectionHeader(const SectionRef& section);
  void WriteEnd();

  const ContainerKind& Kind;
  AtomicFile Data;
  Bytes Header;
  std::vector<SectionRef> Sections;
};
}

#endif
