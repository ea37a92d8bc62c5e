// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunOutputFile.h"

#include "gatunFileSource.h"

#include <algorithm>
#include <functional>

namespace gatun
{
namespace
{
// Streams that are shorter are not worth the entry in the list of runs.
constexpr std::uint64_t LeastShared = 64;

/** Calls use(bytes) for consecutive parts of some bytes of a file. */
template <typename Use>
void ReadInParts(const AtomicFile& file, std::uint64_t begin, std::uint64_t length, const Use& use)
{
  Bytes buffer(static_cast<std::size_t>(std::min(CopyBytes, length)));
  for (std::uint64_t at = 0; at < length; at += buffer.size())
  {
    const auto bytes = std::span(buffer).first(
      static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), length - at)));
    file.ReadAt(begin + at, bytes);
    use(std::span<const std::uint8_t>(bytes));
  }
}

const FileHandle& GetHandle(const InputFile& file)
{
  const auto* source = dynamic_cast<const FileSource*>(&file.GetSource());
  if (!source)
  {
    throw Error(ErrorCode::CannotWrite,
      { .Path = file.GetPath(), .What = "only a file on disk can be replaced" });
  }
  return source->GetHandle();
}
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& path, const ContainerKind& kind)
  : Kind(kind)
  , Data(path)
  , Header(MakeHeader(kind))
{
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const InputFile& before, FourCC outdated)
  : Kind(MeshContainer)
  , Data(before.GetPath(), GetHandle(before))
  , Header(MakeHeader(MeshContainer))
{
  for (SectionRef section : before.GetSections())
  {
    if (section.Name == outdated)
    {
      section.Name = SectionFree;
      section.Flags = 0;
    }
    this->WriteSectionHeader(section);
    if (this->Data.GetSize() != section.Payload.Offset)
    {
      before.Fail(
        ErrorCode::Corrupt, "a section does not follow the one before it", section.Payload.Offset);
    }
    before.ReadInParts(section.Payload, "a section",
      [this](std::span<const std::uint8_t> bytes) { this->Data.Write(bytes); });
    this->Sections.push_back(section);
  }
  this->AddPieces(before);
  for (const StreamRef& mesh : before.FindSections(SectionGrid))
  {
    this->AddPieces(InputFile(before, mesh, "a mesh"));
  }
}

//------------------------------------------------------------------------------
/** Lets the sections of a file that this one begins with, or of one in it, be shared. */
void OutputFile::AddPieces(const InputFile& before)
{
  for (const SectionRef& section : before.GetSections())
  {
    if (const auto piece = before.FindInWhole(section.Payload);
        piece && section.Name != SectionGrid)
    {
      this->Pieces.push_back(*piece);
    }
  }
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(Embedded, const OutputFile& whole)
  : Kind(whole.Kind)
  , Data(AtomicFile::MakeScratch(whole.Data))
  , Header(MakeHeader(whole.Kind))
{
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& folder)
  : Kind(MeshContainer)
  , Data(AtomicFile::MakeScratch(folder))
  , Header(MakeHeader(MeshContainer))
{
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(Common, const std::string& path)
  : Kind(MeshContainer)
  , Data(AtomicFile::MakeCommon(path))
  , Header(MakeHeader(MeshContainer))
{
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
  FourCC name, std::span<const std::uint8_t> payload, std::uint16_t flags)
{
  SectionRef section;
  section.Name = name;
  section.Flags = flags;
  section.Payload.Length = payload.size();
  section.Payload.Sum = Checksum(payload);
  this->WriteSectionHeader(section);
  section.Payload.Offset = this->Data.GetSize();
  this->Data.Write(payload);
  this->Sections.push_back(section);
  this->Pieces.push_back(section.Payload);
  return section.Payload.Offset;
}

//------------------------------------------------------------------------------
void OutputFile::DivideLast(std::span<const StreamRef* const> streams)
{
  this->Pieces.pop_back();
  for (const StreamRef* stream : streams)
  {
    if (stream->Length >= LeastShared)
    {
      this->Pieces.push_back(*stream);
    }
  }
}

//------------------------------------------------------------------------------
std::uint64_t OutputFile::AddSection(FourCC name, OutputFile& part)
{
  part.WriteEnd();
  SectionRef section;
  section.Name = name;
  this->AddPart(section, part, {}, {});
  return part.Data.GetSize();
}

//------------------------------------------------------------------------------
std::uint64_t OutputFile::AddShared(FourCC name, OutputFile& part)
{
  part.WriteEnd();
  auto extents = this->FindExtents(part);
  if (extents.size() == 1)
  {
    extents.clear(); // there is nothing in common
  }
  SectionRef section;
  section.Name = name;
  section.Flags = FlagMandatory;
  const auto before = this->Data.GetSize();
  this->AddPart(section, part, WriteExtents(extents), extents);
  return this->Data.GetSize() - before - SectionHeaderSize;
}

//------------------------------------------------------------------------------
/** Adds a section with a complete file. list: the bytes before it; extents: which bytes are
 * elsewhere; empty if none are. */
void OutputFile::AddPart(
  SectionRef section, const OutputFile& part, const Bytes& list, std::span<const Extent> extents)
{
  const std::vector<Extent> whole{ { part.Data.GetSize(), 0 } };
  const auto all = extents.empty() ? std::span<const Extent>(whole) : extents;
  const auto each = [&](const std::function<void(std::span<const std::uint8_t>)>& use)
  {
    use(list);
    std::uint64_t at = 0;
    for (const Extent& extent : all)
    {
      if (extent.Source == 0)
      {
        ReadInParts(part.Data, at, extent.Length, use);
      }
      at += extent.Length;
    }
  };
  // The part is read twice, because the checksum precedes it.
  RunningChecksum sum;
  each(
    [&](std::span<const std::uint8_t> bytes)
    {
      sum.Add(bytes);
      section.Payload.Length += bytes.size();
    });
  section.Payload.Sum = sum.Get();
  this->WriteSectionHeader(section);
  section.Payload.Offset = this->Data.GetSize();
  each([&](std::span<const std::uint8_t> bytes) { this->Data.Write(bytes); });
  this->Sections.push_back(section);

  // What has been written can be shared, too.
  auto piece = part.Pieces.begin();
  std::uint64_t at = 0;
  auto to = section.Payload.Offset + list.size();
  for (const Extent& extent : all)
  {
    const auto end = at + extent.Length;
    for (; piece != part.Pieces.end() && piece->Offset < end; ++piece)
    {
      if (extent.Source == 0 && piece->Offset + piece->Length <= end)
      {
        this->Pieces.push_back({ piece->Offset - at + to, piece->Length, piece->Sum });
      }
    }
    to += extent.Source == 0 ? extent.Length : 0;
    at = end;
  }
}

//------------------------------------------------------------------------------
/** Whether bytes of this file are those at a place in a part. */
bool OutputFile::IsEqual(
  std::uint64_t offset, const OutputFile& part, std::uint64_t place, std::uint64_t length) const
{
  Bytes mine;
  Bytes others;
  for (std::uint64_t at = 0; at < length; at += mine.size())
  {
    mine.resize(static_cast<std::size_t>(std::min(CopyBytes, length - at)));
    others.resize(mine.size());
    this->Data.ReadAt(offset + at, mine);
    part.Data.ReadAt(place + at, others);
    if (mine != others)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/** What may be in another file, too: sections, and the streams in them. Ascending, and whole
 * sections come before their streams. */
std::vector<StreamRef> OutputFile::ListCandidates() const
{
  std::vector<StreamRef> list;
  for (const SectionRef& section : this->Sections)
  {
    list.push_back(section.Payload);
  }
  list.insert(list.end(), this->Pieces.begin(), this->Pieces.end());
  std::sort(list.begin(), list.end(),
    [](const StreamRef& a, const StreamRef& b)
    { return a.Offset != b.Offset ? a.Offset < b.Offset : a.Length > b.Length; });
  return list;
}

//------------------------------------------------------------------------------
/** Which bytes of a part are in this file already. Exact: checksums only tell what to compare. */
std::vector<Extent> OutputFile::FindExtents(const OutputFile& part)
{
  for (; this->Indexed < this->Pieces.size(); ++this->Indexed)
  {
    const StreamRef& piece = this->Pieces[this->Indexed];
    this->Index.try_emplace(piece.Sum, piece);
  }
  std::vector<Extent> extents;
  auto most = this->GetSize(); // of what readers accept
  std::uint64_t at = 0;
  const auto keep = [&](std::uint64_t end)
  {
    if (end > at)
    {
      extents.push_back({ end - at, 0 });
    }
    at = end;
  };
  for (const StreamRef& piece : part.ListCandidates())
  {
    const auto found = this->Index.find(piece.Sum);
    if (found == this->Index.end() || found->second.Length != piece.Length ||
      piece.Length < LeastShared || piece.Offset < at || piece.Offset + piece.Length - at > most ||
      !this->IsEqual(found->second.Offset, part, piece.Offset, piece.Length))
    {
      continue;
    }
    const auto source = found->second.Offset;
    const auto gap = piece.Offset - at; // such as headers of sections
    const bool follows = !extents.empty() && gap <= LeastShared && source >= gap &&
      extents.back().Source + extents.back().Length == source - gap &&
      this->IsEqual(source - gap, part, at, gap);
    const auto length = piece.Length + (follows ? gap : 0);
    most -= length;
    if (follows)
    {
      extents.back().Length += length;
    }
    else
    {
      keep(piece.Offset);
      extents.push_back({ length, source });
    }
    at = piece.Offset + piece.Length;
  }
  keep(part.Data.GetSize());
  return extents;
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
