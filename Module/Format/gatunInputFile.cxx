// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunInputFile.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gatun
{
namespace
{
// Tables are at the end of a file. Of a small file, these are all.
constexpr std::uint64_t EndBytes = 64u << 10;

std::string ToText(FourCC name)
{
  std::string text;
  for (unsigned i = 0; i < 4; ++i)
  {
    const char c = static_cast<char>((name >> (8 * i)) & 0xff);
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  return text;
}
}

//------------------------------------------------------------------------------
InputFile::InputFile(
  std::shared_ptr<const ByteSource> source, const std::string& path, const ContainerKind& kind)
  : Kind(kind)
  , Path(path)
  , Source(std::move(source))
  , Size(this->Source->GetSize())
{
  this->ReadDirectory();
}

//------------------------------------------------------------------------------
InputFile::InputFile(const InputFile& whole, const StreamRef& section, const std::string& name)
  : Kind(whole.Kind)
  , Path(whole.Path)
  , Part(name)
  , Source(whole.Source)
  , Base(whole.Base + section.Offset)
  , Extents(whole.Extents)
  , Size(section.Length)
{
  whole.CheckInside(section, name);
  const auto isMesh = [&](const SectionRef& other)
  { return other.Name == SectionGrid && other.Payload.Offset == section.Offset; };
  if (std::any_of(whole.Sections.begin(), whole.Sections.end(), isMesh))
  {
    this->ReadExtents(whole, section, name);
  }
  this->ReadDirectory();
}

//------------------------------------------------------------------------------
/** Reads where the parts of a mesh of a series are, which may share some with what is before it. */
void InputFile::ReadExtents(
  const InputFile& whole, const StreamRef& section, const std::string& name)
{
  if (!whole.Part.empty())
  {
    whole.Fail(ErrorCode::Corrupt, name, section.Offset, "is a mesh of a part of a file");
  }
  Bytes head(static_cast<std::size_t>(std::min<std::uint64_t>(ExtentMap::HeadBytes, this->Size)));
  this->ReadAt(0, head);
  constexpr const char* what = "the list of its parts";
  const auto list = this->Guarded(what, {}, [&] { return ExtentMap::FindList(head, section); });
  const auto begin = list.Offset - section.Offset;
  if (list.Length == 0)
  {
    this->Base += begin;
    this->Size -= begin;
    return;
  }
  this->Extents = this->Guarded(what, {},
    [&]
    {
      const StreamRef here{ begin, list.Length, list.Sum };
      return std::make_shared<const ExtentMap>(this->Read(here, what), list, section);
    });
  this->Base = 0;
  this->Size = this->Extents->GetSize();
}

//------------------------------------------------------------------------------
/** The place of a byte of this container in the whole file, and how many follow there. */
ExtentMap::Place InputFile::Locate(std::uint64_t offset) const
{
  return this->Extents ? this->Extents->Find(this->Base + offset)
                       : ExtentMap::Place{ this->Base + offset, ~std::uint64_t{ 0 } };
}

//------------------------------------------------------------------------------
void InputFile::Fail(ErrorCode code, const std::string& what, std::optional<std::uint64_t> offset,
  const std::string& problem, int systemError) const
{
  if (offset)
  {
    *offset = this->Locate(*offset).Offset;
  }
  throw Error(code, { this->Path, this->Part, what, offset, problem, systemError });
}

//------------------------------------------------------------------------------
void InputFile::FailNotHere(std::uint64_t offset, std::uint64_t length) const
{
  throw Error(ErrorCode::NotHere,
    { .Path = this->Path,
      .Part = this->Part,
      .What = std::to_string(length) + " bytes that are needed are not here yet",
      .Offset = this->Locate(offset).Offset,
      .Length = length });
}

//------------------------------------------------------------------------------
void InputFile::ReadAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const
{
  this->BytesRead += bytes.size();
  while (!bytes.empty())
  {
    const auto place = this->Locate(offset);
    const auto length =
      static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), place.Length));
    auto rest = bytes.first(length);
    const int error = this->Source->ReadAt(place.Offset, rest);
    const auto reached = offset + (length - rest.size());
    if (error == ByteSource::NotHere)
    {
      this->FailNotHere(reached, rest.size());
    }
    if (error != 0)
    {
      this->Fail(ErrorCode::CannotOpen, "cannot read", reached, {}, error);
    }
    if (!rest.empty() || length == 0)
    {
      this->Fail(ErrorCode::Truncated, "the file became shorter", reached);
    }
    bytes = bytes.subspan(length);
    offset += length;
  }
}

//------------------------------------------------------------------------------
void InputFile::CheckInside(const StreamRef& stream, const std::string& what) const
{
  if (!this->IsInside(stream))
  {
    this->Fail(ErrorCode::Truncated, what, stream.Offset,
      "reaches past the end of the file (" + std::to_string(this->Size) + " bytes)");
  }
}

//------------------------------------------------------------------------------
void InputFile::FailSum(const StreamRef& stream, const std::string& what) const
{
  this->Fail(ErrorCode::Corrupt, what, stream.Offset,
    "(" + std::to_string(stream.Length) + " bytes) is damaged: its checksum is wrong");
}

//------------------------------------------------------------------------------
Bytes InputFile::Read(const StreamRef& stream, const std::string& what) const
{
  this->CheckInside(stream, what);
  Bytes bytes(static_cast<std::size_t>(stream.Length));
  this->ReadAt(stream.Offset, bytes);
  if (Checksum(bytes) != stream.Sum)
  {
    this->FailSum(stream, what);
  }
  return bytes;
}

//------------------------------------------------------------------------------
void InputFile::ReadInParts(const StreamRef& stream, const std::string& what,
  const std::function<void(std::span<const std::uint8_t>)>& use) const
{
  this->CheckInside(stream, what);
  RunningChecksum sum;
  Bytes buffer(static_cast<std::size_t>(std::min(CopyBytes, stream.Length)));
  for (std::uint64_t at = 0; at < stream.Length; at += buffer.size())
  {
    const auto bytes = std::span(buffer).first(
      static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), stream.Length - at)));
    this->ReadAt(stream.Offset + at, bytes);
    sum.Add(bytes);
    use(bytes);
  }
  if (sum.Get() != stream.Sum)
  {
    this->FailSum(stream, what);
  }
}

//------------------------------------------------------------------------------
void InputFile::CheckSum(const StreamRef& stream, const std::string& what) const
{
  this->ReadInParts(stream, what, [](std::span<const std::uint8_t>) {});
}

//------------------------------------------------------------------------------
std::optional<StreamRef> InputFile::FindInWhole(const StreamRef& stream) const
{
  this->CheckInside(stream, "a stream");
  const auto place = this->Locate(stream.Offset);
  return place.Length < stream.Length
    ? std::nullopt
    : std::optional(StreamRef{ place.Offset, stream.Length, stream.Sum });
}

//------------------------------------------------------------------------------
void InputFile::AddRanges(const StreamRef& stream, std::vector<ByteRange>& ranges) const
{
  this->CheckInside(stream, "a stream");
  for (std::uint64_t done = 0; done < stream.Length;)
  {
    const auto place = this->Locate(stream.Offset + done);
    const auto length = std::min(stream.Length - done, place.Length);
    ranges.push_back({ place.Offset, length });
    if (length == 0)
    {
      return;
    }
    done += length;
  }
}

//------------------------------------------------------------------------------
std::vector<ByteRange> InputFile::FindRanges(const std::vector<StreamRef>& streams) const
{
  std::vector<ByteRange> ranges;
  for (const StreamRef& stream : streams)
  {
    if (this->IsInside(stream))
    {
      this->AddRanges(stream, ranges);
    }
  }
  return ranges;
}

//------------------------------------------------------------------------------
void InputFile::Announce(const std::vector<StreamRef>& streams) const
{
  if (this->Source->IsRemote())
  {
    this->Source->Fetch(JoinRanges(this->FindRanges(streams), 0));
  }
}

//------------------------------------------------------------------------------
void InputFile::FailTogether(const std::vector<StreamRef>& streams, const Error& error) const
{
  constexpr std::uint64_t closely = 64u << 10;
  const auto offset = error.Offset.value_or(0);
  auto end = offset + error.Length;
  for (const auto& range : JoinRanges(this->FindRanges(streams), closely))
  {
    if (range.Offset <= offset && offset < range.Offset + range.Length)
    {
      end = std::max(end, range.Offset + range.Length);
    }
  }
  Error wider = error;
  wider.Length = end - offset;
  throw wider;
}

//------------------------------------------------------------------------------
void InputFile::AddEnds(const StreamRef& container, std::vector<StreamRef>& streams)
{
  const auto head = std::min<std::uint64_t>(container.Length, HeaderSize);
  const auto end = std::min(container.Length, EndBytes);
  streams.push_back({ container.Offset, head, 0 });
  streams.push_back({ container.Offset + container.Length - end, end, 0 });
}

//------------------------------------------------------------------------------
/** Refuses sections of another version, and unknown ones that are mandatory. */
void InputFile::CheckVersion(const SectionRef& section) const
{
  const auto& known = this->Kind.Sections;
  const bool isKnown = std::find(known.begin(), known.end(), section.Name) != known.end();
  if (isKnown && section.Version != SectionVersion)
  {
    this->Fail(ErrorCode::UnsupportedVersion,
      "section '" + ToText(section.Name) + "' has version " + std::to_string(section.Version) +
        "; this program reads version " + std::to_string(SectionVersion) + " only");
  }
  if (!isKnown && (section.Flags & FlagMandatory))
  {
    this->Fail(ErrorCode::UnsupportedVersion,
      "the file has a section '" + ToText(section.Name) + "' (version " +
        std::to_string(section.Version) + ") that only another version of Gatun can read");
  }
}

//------------------------------------------------------------------------------
/** Reads and checks signature and version. */
void InputFile::ReadHeader(std::span<std::uint8_t, HeaderSize> header)
{
  const auto beginning =
    header.first(static_cast<std::size_t>(std::min<std::uint64_t>(HeaderSize, this->Size)));
  this->ReadAt(0, beginning);
  const auto& magic = this->Kind.FileMagic;
  if (this->Size < magic.size() || !std::equal(magic.begin(), magic.end(), header.begin()))
  {
    // The file that contains an embedded file has been recognized, so it is damaged.
    this->Fail(this->Part.empty() ? ErrorCode::NotGatun : ErrorCode::Corrupt,
      this->Size == 0
        ? "the file is empty"
        : "this is not a " + std::string(this->Kind.Suffix) + " file (its first bytes differ)");
  }
  if (this->Size < HeaderSize + TrailerSize)
  {
    this->Fail(ErrorCode::Truncated,
      "the file is truncated: " + std::to_string(this->Size) + " bytes are too few");
  }
  ByteReader in(std::span<const std::uint8_t>(header).subspan(magic.size()));
  const auto version = in.Get<std::uint32_t>();
  if (version != this->Kind.Version)
  {
    this->Fail(ErrorCode::UnsupportedVersion,
      "the file has version " + std::to_string(version) + " of the " + this->Kind.Suffix +
        " format; this program reads version " + std::to_string(this->Kind.Version) + " only");
  }
  const auto reserved = HeaderSize - sizeof(std::uint32_t);
  if (in.Get<std::uint32_t>() != 0)
  {
    this->Fail(ErrorCode::Corrupt, "the file's header is damaged", reserved);
  }
}

//------------------------------------------------------------------------------
/** Reads the last bytes. If they are not here yet, asks for more than is needed now, because tables
 * are at the end of a file. */
void InputFile::ReadEnd(std::uint64_t offset, std::span<std::uint8_t> bytes) const
{
  try
  {
    this->ReadAt(offset, bytes);
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::NotHere || this->Extents)
    {
      throw;
    }
    const auto length = std::min(this->Size, 2 * EndBytes);
    this->FailNotHere(this->Size - length, length);
  }
}

//------------------------------------------------------------------------------
/** Reads the directory by means of the trailer. Returns the position of the directory. */
StreamRef InputFile::ReadTrailer(std::span<const std::uint8_t> header, Bytes& directory) const
{
  std::array<std::uint8_t, TrailerSize> trailer{};
  const auto start = this->Size - TrailerSize;
  this->ReadEnd(start, trailer);
  ByteReader end(trailer);
  StreamRef where;
  where.Offset = end.Get<std::uint64_t>();
  where.Length = end.Get<std::uint64_t>();
  where.Sum = end.Get<std::uint64_t>();
  const auto& magic = this->Kind.TrailerMagic;
  const auto last = end.GetBytes(magic.size());
  if (!std::equal(magic.begin(), magic.end(), last.begin()))
  {
    this->Fail(ErrorCode::Truncated,
      "the file does not end as it should; it is truncated, or damaged in its last bytes (size " +
        std::to_string(this->Size) + ")");
  }
  if (where.Offset < HeaderSize + SectionHeaderSize || where.Offset > start ||
    where.Length != start - where.Offset)
  {
    this->Fail(ErrorCode::Corrupt, "the trailer", start, "is damaged: it points to no directory");
  }
  directory.resize(static_cast<std::size_t>(where.Length));
  this->ReadAt(where.Offset, directory);
  if (GetFrameChecksum(header, directory) != where.Sum)
  {
    this->Fail(ErrorCode::Corrupt, "the directory", where.Offset,
      "or the file's header is damaged: their checksum is wrong");
  }
  return where;
}

//------------------------------------------------------------------------------
void InputFile::ReadSections(const Bytes& directory)
{
  ByteReader list(directory);
  const auto count = list.GetCount(SectionHeaderSize + sizeof(std::uint64_t));
  for (std::uint64_t i = 0; i < count; ++i)
  {
    auto section = GetSectionHeader(list);
    section.Payload.Offset = list.Get<std::uint64_t>();
    this->CheckVersion(section);
    this->Sections.push_back(section);
  }
  if (list.GetRemaining() != 0)
  {
    ThrowCorrupt("there are bytes behind its end");
  }
}

//------------------------------------------------------------------------------
void InputFile::ReadDirectory()
{
  std::vector<StreamRef> ends;
  AddEnds({ 0, this->Size, 0 }, ends);
  this->Announce(ends);
  std::array<std::uint8_t, HeaderSize> header{};
  this->ReadHeader(header);
  Bytes directory;
  const auto where = this->ReadTrailer(header, directory);
  try
  {
    this->ReadSections(directory);
  }
  catch (const Error& error)
  {
    if (!error.Path.empty())
    {
      throw;
    }
    this->Fail(ErrorCode::Corrupt, "the directory", where.Offset,
      std::string("is damaged: ") + error.what());
  }
}

//------------------------------------------------------------------------------
std::vector<StreamRef> InputFile::FindSections(FourCC name) const
{
  std::vector<StreamRef> found;
  for (const auto& section : this->Sections)
  {
    if (section.Name == name)
    {
      found.push_back(section.Payload);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
StreamRef InputFile::FindSection(FourCC name, const char* what) const
{
  const auto found = this->FindSections(name);
  if (found.size() != 1)
  {
    this->Fail(ErrorCode::Corrupt,
      (found.empty() ? "the file has no section for " : "the file has several sections for ") +
        std::string(what));
  }
  return found.front();
}

//------------------------------------------------------------------------------
void InputFile::CheckSections(const std::function<bool(double)>& progress) const
{
  std::uint64_t next = HeaderSize;
  for (std::size_t i = 0; i < this->Sections.size(); ++i)
  {
    const auto& section = this->Sections[i];
    const std::string what = "section '" + ToText(section.Name) + "'";
    if (section.Payload.Offset != next + SectionHeaderSize)
    {
      this->Fail(ErrorCode::Corrupt, what + " does not follow the one before it", next);
    }
    std::array<std::uint8_t, SectionHeaderSize> bytes{};
    this->ReadAt(next, bytes);
    ByteWriter expected;
    PutSectionHeader(expected, section);
    if (!std::equal(bytes.begin(), bytes.end(), expected.Data.begin()))
    {
      this->Fail(ErrorCode::Corrupt, "the header of " + what, next, "is damaged");
    }
    this->CheckSum(section.Payload, what);
    next = section.Payload.Offset + section.Payload.Length;
    if (progress &&
      !progress(static_cast<double>(i + 1) / static_cast<double>(this->Sections.size())))
    {
      this->Fail(ErrorCode::Aborted, "aborted");
    }
  }
  std::array<std::uint8_t, SectionHeaderSize> last{};
  this->ReadAt(next, last);
  ByteReader in(last);
  const auto directory = GetSectionHeader(in);
  if (directory.Name != SectionDirectory || directory.Version != SectionVersion ||
    directory.Flags != FlagMandatory ||
    directory.Payload.Length != this->Size - TrailerSize - next - SectionHeaderSize)
  {
    this->Fail(ErrorCode::Corrupt, "the header of the directory", next, "is damaged");
  }
  this->CheckSum(
    { next + SectionHeaderSize, directory.Payload.Length, directory.Payload.Sum }, "the directory");
}
}
