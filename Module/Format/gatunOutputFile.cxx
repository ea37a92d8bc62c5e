// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunOutputFile.h"

#include <algorithm>

namespace gatun
{
namespace
{
/** Calls use(bytes) for consecutive parts of a file. */
template <typename Use>
void ReadInParts(const AtomicFile& file, Use&& use)
{
  Bytes buffer(static_cast<std::size_t>(std::min(CopyBytes, file.GetSize())));
  for (std::uint64_t at = 0; at < file.GetSize(); at += buffer.size())
  {
    const auto bytes = std::span(buffer).first(
      static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), file.GetSize() - at)));
    file.ReadAt(at, bytes);
    use(bytes);
  }
}
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& path, bool replaceReadOnly, std::uint16_t minorVersion,
  const ContainerKind& kind)
  : Kind(kind)
  , Data(path, replaceReadOnly)
  , Header(MakeHeader(kind, minorVersion))
{
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const OutputFile& whole, std::uint16_t minorVersion)
  : Kind(whole.Kind)
  , Data(AtomicFile::MakeScratch(whole.Data))
  , Header(MakeHeader(whole.Kind, minorVersion))
{
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& folder, std::uint16_t minorVersion)
  : Kind(MeshContainer)
  , Data(AtomicFile::MakeScratch(folder))
  , Header(MakeHeader(MeshContainer, minorVersion))
{
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(
  Common, const std::string& path, bool replaceReadOnly, std::uint16_t minorVersion)
  : Kind(MeshContainer)
  , Data(AtomicFile::MakeCommon(path, replaceReadOnly))
  , Header(MakeHeader(MeshContainer, minorVersion))
{
}

//------------------------------------------------------------------------------
void OutputFile::SetMinorVersion(std::uint16_t version)
{
  this->Header = MakeHeader(this->Kind, version);
}

//------------------------------------------------------------------------------
/** Writes the header of the file before the first section. */
void OutputFile::WriteHeader()
{
  if (this->Data.GetSize() == 0)
  {
    this->Data.Write(this->Header);
  }
}

//------------------------------------------------------------------------------
std::uint64_t OutputFile::GetSize() const
{
  return std::max<std::uint64_t>(this->Data.GetSize(), this->Header.size());
}

//------------------------------------------------------------------------------
std::uint64_t OutputFile::AddSections(
  const std::vector<SectionRef>& sections, std::uint64_t begin, std::uint64_t end)
{
  this->WriteHeader();
  const auto offset = this->Data.Skip(end - begin);
  for (const auto& section : sections)
  {
    // Positions are those of payloads, which follow headers.
    if (section.Payload.Offset > begin && section.Payload.Offset <= end)
    {
      auto& added = this->Sections.emplace_back(section);
      added.Payload.Offset = section.Payload.Offset - begin + offset;
    }
  }
  return offset;
}

//------------------------------------------------------------------------------
void OutputFile::WriteSectionHeader(const SectionRef& section)
{
  this->WriteHeader();
  ByteWriter header;
  PutSectionHeader(header, section);
  this->Data.Write(header.Data);
}

//------------------------------------------------------------------------------
std::uint64_t OutputFile::AddSection(
  FourCC name, std::span<const std::uint8_t> payload, std::uint16_t flags, std::uint16_t version)
{
  SectionRef section;
  section.Name = name;
  section.Version = version;
  section.Flags = flags;
  section.Payload.Length = payload.size();
  section.Payload.Sum = Checksum(payload);
  this->WriteSectionHeader(section);
  section.Payload.Offset = this->Data.GetSize();
  this->Data.Write(payload);
  this->Sections.push_back(section);
  return section.Payload.Offset;
}

//------------------------------------------------------------------------------
std::uint64_t OutputFile::AddSection(FourCC name, OutputFile& part)
{
  part.WriteEnd();
  // The part is read twice, because the checksum precedes it.
  RunningChecksum sum;
  ReadInParts(part.Data, [&](std::span<const std::uint8_t> bytes) { sum.Add(bytes); });
  SectionRef section;
  section.Name = name;
  section.Payload.Length = part.Data.GetSize();
  section.Payload.Sum = sum.Get();
  this->WriteSectionHeader(section);
  section.Payload.Offset = this->Data.GetSize();
  ReadInParts(part.Data, [&](std::span<const std::uint8_t> bytes) { this->Data.Write(bytes); });
  this->Sections.push_back(section);
  return part.Data.GetSize();
}

//------------------------------------------------------------------------------
void OutputFile::WriteEnd()
{
  ByteWriter directory;
  directory.PutVarint(this->Sections.size());
  for (const auto& section : this->Sections)
  {
    PutSectionHeader(directory, section);
    directory.Put(section.Payload.Offset);
  }
  ByteWriter trailer;
  trailer.Put(this->AddSection(SectionDirectory, directory.Data));
  trailer.Put(static_cast<std::uint64_t>(directory.Data.size()));
  trailer.Put(GetFrameChecksum(this->Header, directory.Data));
  trailer.PutBytes(this->Kind.TrailerMagic);
  this->Data.Write(trailer.Data);
}

//------------------------------------------------------------------------------
std::uint64_t OutputFile::Commit()
{
  this->WriteEnd();
  this->Data.Commit();
  return this->Data.GetSize();
}
}
