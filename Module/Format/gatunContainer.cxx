// SPDX-License-Identifier: BSD-3-Clause
#include "gatunContainer.h"

#include <xxhash.h>
#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <new>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gatun
{
namespace
{
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

std::string AtOffset(std::uint64_t offset)
{
  return " at byte " + std::to_string(offset);
}

void PutSectionHeader(ByteWriter& out, const SectionRef& section)
{
  out.Put(section.Name);
  out.Put(section.Version);
  out.Put(section.Flags);
  out.Put(section.Payload.Length);
  out.Put(section.Payload.Sum);
}

SectionRef GetSectionHeader(ByteReader& in)
{
  SectionRef section;
  section.Name = in.Get<FourCC>();
  section.Version = in.Get<std::uint16_t>();
  section.Flags = in.Get<std::uint16_t>();
  section.Payload.Length = in.Get<std::uint64_t>();
  section.Payload.Sum = in.Get<std::uint64_t>();
  return section;
}

Bytes MakeHeader(const ContainerKind& kind, std::uint16_t minorVersion)
{
  ByteWriter header;
  header.PutBytes(kind.FileMagic);
  header.Put(kind.Major);
  header.Put(minorVersion);
  header.Put(std::uint32_t{ 0 });
  return std::move(header.Data);
}

/** What the trailer vouches for: the file's header and its directory. */
std::uint64_t SumOfFrame(std::span<const std::uint8_t> header, const Bytes& directory)
{
  Bytes both(header.begin(), header.end());
  both.insert(both.end(), directory.begin(), directory.end());
  return Checksum(both);
}

/** Where a link leads that leads to nothing yet; other paths as they are. */
std::string FollowLinks(const std::string& path)
{
  namespace fs = std::filesystem;
  constexpr int most = 40;
  std::error_code error;
  fs::path target = path;
  for (int i = 0; i < most && fs::is_symlink(target, error); ++i)
  {
    // A relative link counts from the folder that it is in.
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  return target.string();
}

// What is copied or checked at once of parts of any length.
constexpr std::uint64_t CopyBytes = 4u << 20;

/** The checksum of what comes in parts. */
class RunningChecksum
{
public:
  RunningChecksum()
    : State(XXH3_createState(), &XXH3_freeState)
  {
    if (!this->State)
    {
      throw std::bad_alloc();
    }
    XXH3_64bits_reset(this->State.get());
  }

  void Add(std::span<const std::uint8_t> bytes)
  {
    XXH3_64bits_update(this->State.get(), bytes.data(), bytes.size());
  }

  std::uint64_t Get() const { return XXH3_64bits_digest(this->State.get()); }

private:
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> State;
};

/** Throws if a file is marked read-only, which binds root as well, or if it is not this user's. */
void CheckReplaceable(const std::string& path, ::mode_t mode)
{
  if ((mode & 0222) == 0)
  {
    throw Error(ErrorCode::CannotWrite, path + ": is read-only");
  }
  const int handle = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (handle < 0)
  {
    throw Error(ErrorCode::CannotWrite, path + ": cannot write: " + std::strerror(errno));
  }
  ::close(handle);
}
}

bool BeginsAs(const std::string& path, const ContainerKind& kind) noexcept
{
  try
  {
    if (!std::filesystem::is_regular_file(path))
    {
      return false; // opening a pipe would wait for its other end
    }
    std::ifstream in(path, std::ios::binary);
    std::array<char, FileMagic.size()> begin{};
    return in.read(begin.data(), begin.size()) &&
      std::equal(begin.begin(), begin.end(), kind.FileMagic.begin(),
        [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  }
  catch (...)
  {
    return false;
  }
}

std::uint64_t Checksum(std::span<const std::uint8_t> bytes)
{
  return XXH3_64bits(bytes.data(), bytes.size());
}

Bytes Compress(std::span<const std::uint8_t> bytes)
{
  ByteWriter out;
  out.PutVarint(bytes.size());
  const auto start = out.Data.size();
  out.Data.resize(start + ZSTD_compressBound(bytes.size()));
  const auto size =
    ZSTD_compress(out.Data.data() + start, out.Data.size() - start, bytes.data(), bytes.size(), 12);
  if (ZSTD_isError(size))
  {
    throw Error(ErrorCode::CannotWrite, "zstd: " + std::string(ZSTD_getErrorName(size)));
  }
  out.Data.resize(start + size);
  return std::move(out.Data);
}

Bytes Decompress(std::span<const std::uint8_t> bytes, std::uint64_t limit)
{
  ByteReader in(bytes);
  const auto size = in.GetVarint();
  const auto packed = in.GetBytes(in.GetRemaining());
  if (size > limit)
  {
    ThrowCorrupt("a compressed part claims to hold " + std::to_string(size) + " bytes");
  }
  // Grow as the data comes, so that memory follows what is really there.
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(
    ZSTD_createDCtx(), &ZSTD_freeDCtx);
  if (!context)
  {
    throw std::bad_alloc();
  }
  Bytes out;
  ZSTD_inBuffer source{ packed.data(), packed.size(), 0 };
  for (std::size_t state = 1; state != 0;)
  {
    const auto old = out.size();
    out.resize(std::min<std::uint64_t>(size, std::max<std::size_t>(2 * old, 1 << 16)));
    ZSTD_outBuffer target{ out.data(), out.size(), old };
    const auto before = source.pos;
    state = ZSTD_decompressStream(context.get(), &target, &source);
    if (ZSTD_getErrorCode(state) == ZSTD_error_memory_allocation)
    {
      throw std::bad_alloc();
    }
    if (ZSTD_isError(state) || (state != 0 && target.pos == old && source.pos == before))
    {
      ThrowCorrupt("a compressed part is damaged");
    }
    out.resize(target.pos);
  }
  if (out.size() != size || source.pos != source.size)
  {
    ThrowCorrupt("a compressed part has the wrong length");
  }
  return out;
}

//--------------------------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& path, bool replaceReadOnly, std::uint16_t minorVersion,
  const ContainerKind& kind)
  : Kind(kind)
  , Path(path)
  , Target(path)
{
  struct stat old
  {
  };
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (exists)
  {
    if (!S_ISREG(old.st_mode))
    {
      throw Error(ErrorCode::CannotWrite,
        path + (S_ISDIR(old.st_mode) ? ": is a directory" : ": is not a regular file"));
    }
    if (!replaceReadOnly)
    {
      CheckReplaceable(path, old.st_mode);
    }
    if (char* real = ::realpath(path.c_str(), nullptr))
    {
      this->Target = real;
      std::free(real);
    }
  }
  else
  {
    this->Target = FollowLinks(path);
  }
  this->Begin(minorVersion);
  const auto mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(this->Handle, exists ? old.st_mode & 07777 : 0666 & ~mask) != 0)
  {
    // Only the permissions of the new file differ then; the content is what matters.
  }
}

OutputFile::OutputFile(const OutputFile& whole, std::uint16_t minorVersion)
  : Kind(whole.Kind)
  , Path(whole.Path)
  , Target(whole.Target)
{
  this->Begin(minorVersion);
  ::unlink(this->Temporary.c_str());
  this->Temporary.clear();
}

/** Opens a temporary file and writes the header. */
void OutputFile::Begin(std::uint16_t minorVersion)
{
  std::string name = this->Target + ".part-XXXXXX";
  this->Handle = ::mkstemp(name.data());
  if (this->Handle < 0)
  {
    this->Fail(std::strerror(errno));
  }
  this->Temporary = name;
  this->Header = MakeHeader(this->Kind, minorVersion);
  try
  {
    this->Write(this->Header);
  }
  catch (...)
  {
    ::close(this->Handle);
    ::unlink(this->Temporary.c_str());
    throw;
  }
}

OutputFile::~OutputFile()
{
  if (this->Handle >= 0)
  {
    ::close(this->Handle);
  }
  if (!this->Temporary.empty())
  {
    ::unlink(this->Temporary.c_str());
  }
}

void OutputFile::Fail(const std::string& what) const
{
  throw Error(ErrorCode::CannotWrite, this->Path + ": cannot write: " + what);
}

void OutputFile::Write(std::span<const std::uint8_t> bytes)
{
  while (!bytes.empty())
  {
    const auto written = ::write(this->Handle, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      this->Fail(std::strerror(written < 0 ? errno : ENOSPC));
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    this->Size += static_cast<std::uint64_t>(written);
  }
}

std::uint64_t OutputFile::AddSection(
  FourCC name, std::span<const std::uint8_t> payload, std::uint16_t flags)
{
  SectionRef section;
  section.Name = name;
  section.Flags = flags;
  section.Payload.Length = payload.size();
  section.Payload.Sum = Checksum(payload);
  ByteWriter header;
  PutSectionHeader(header, section);
  this->Write(header.Data);
  section.Payload.Offset = this->Size;
  this->Write(payload);
  this->Sections.push_back(section);
  return section.Payload.Offset;
}

std::uint64_t OutputFile::AddSection(FourCC name, OutputFile& part)
{
  part.WriteEnd();
  // Twice, as the checksum stands in front.
  Bytes buffer(static_cast<std::size_t>(std::min(CopyBytes, part.Size)));
  const auto each = [&](auto&& use)
  {
    for (std::uint64_t at = 0; at < part.Size; at += buffer.size())
    {
      const auto bytes = std::span(buffer).first(
        static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), part.Size - at)));
      for (std::size_t got = 0; got < bytes.size();)
      {
        const auto now = ::pread(
          part.Handle, bytes.data() + got, bytes.size() - got, static_cast<::off_t>(at + got));
        if (now < 0 && errno == EINTR)
        {
          continue;
        }
        if (now <= 0)
        {
          this->Fail(now < 0 ? std::strerror(errno) : "a temporary file became shorter");
        }
        got += static_cast<std::size_t>(now);
      }
      use(bytes);
    }
  };
  RunningChecksum sum;
  each([&](std::span<const std::uint8_t> bytes) { sum.Add(bytes); });
  SectionRef section;
  section.Name = name;
  section.Payload.Length = part.Size;
  section.Payload.Sum = sum.Get();
  ByteWriter header;
  PutSectionHeader(header, section);
  this->Write(header.Data);
  section.Payload.Offset = this->Size;
  each([&](std::span<const std::uint8_t> bytes) { this->Write(bytes); });
  this->Sections.push_back(section);
  return part.Size;
}

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
  trailer.Put(SumOfFrame(this->Header, directory.Data));
  trailer.PutBytes(this->Kind.TrailerMagic);
  this->Write(trailer.Data);
}

std::uint64_t OutputFile::Commit()
{
  this->WriteEnd();
  if (::fsync(this->Handle) != 0)
  {
    this->Fail(std::strerror(errno));
  }
  const int handle = this->Handle;
  this->Handle = -1;
  if (::close(handle) != 0 || ::rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
  {
    this->Fail(std::strerror(errno));
  }
  this->Temporary.clear();
  return this->Size;
}

//--------------------------------------------------------------------------------------------------
InputFile::InputFile(const std::string& path, const ContainerKind& kind)
  : Kind(kind)
  , Path(path)
{
  // Without O_NONBLOCK, opening a pipe would wait for its other end.
  this->Handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (this->Handle < 0)
  {
    this->Fail(ErrorCode::CannotOpen, std::string("cannot open: ") + std::strerror(errno));
  }
  try
  {
    struct stat status
    {
    };
    if (::fstat(this->Handle, &status) != 0 || !S_ISREG(status.st_mode))
    {
      this->Fail(ErrorCode::CannotOpen,
        S_ISDIR(status.st_mode) ? "cannot open: is a directory"
                                : "cannot open: is not a regular file");
    }
    this->Size = static_cast<std::uint64_t>(status.st_size);
    this->ReadDirectory();
  }
  catch (...)
  {
    ::close(this->Handle);
    throw;
  }
}

InputFile::InputFile(const InputFile& whole, const StreamRef& section, const std::string& name)
  : Kind(whole.Kind)
  , Path(whole.Path + ", " + name)
  , Base(whole.Base + section.Offset)
  , Size(section.Length)
{
  whole.CheckInside(section, name);
  this->Handle = ::fcntl(whole.Handle, F_DUPFD_CLOEXEC, 0);
  if (this->Handle < 0)
  {
    this->Fail(ErrorCode::CannotOpen, std::string("cannot open: ") + std::strerror(errno));
  }
  try
  {
    this->ReadDirectory();
  }
  catch (...)
  {
    ::close(this->Handle);
    throw;
  }
}

InputFile::~InputFile()
{
  ::close(this->Handle);
}

void InputFile::Fail(ErrorCode code, const std::string& what) const
{
  throw Error(code, this->Path + ": " + what);
}

void InputFile::ReadAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const
{
  this->BytesRead += bytes.size();
  while (!bytes.empty())
  {
    const auto got =
      ::pread(this->Handle, bytes.data(), bytes.size(), static_cast<::off_t>(this->Base + offset));
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got < 0)
    {
      this->Fail(ErrorCode::CannotOpen,
        std::string("cannot read: ") + std::strerror(errno) + AtOffset(offset));
    }
    if (got == 0)
    {
      this->Fail(ErrorCode::Truncated, "the file became shorter" + AtOffset(offset));
    }
    offset += static_cast<std::uint64_t>(got);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

void InputFile::CheckInside(const StreamRef& stream, const std::string& what) const
{
  if (stream.Offset > this->Size || stream.Length > this->Size - stream.Offset)
  {
    this->Fail(ErrorCode::Truncated,
      what + AtOffset(stream.Offset) + " reaches past the end of the file (" +
        std::to_string(this->Size) + " bytes)");
  }
}

void InputFile::FailSum(const StreamRef& stream, const std::string& what) const
{
  this->Fail(ErrorCode::Corrupt,
    what + AtOffset(stream.Offset) + " (" + std::to_string(stream.Length) +
      " bytes) is damaged: its checksum is wrong");
}

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

void InputFile::CheckSum(const StreamRef& stream, const std::string& what) const
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
  }
  if (sum.Get() != stream.Sum)
  {
    this->FailSum(stream, what);
  }
}

bool InputFile::IsReadable(const SectionRef& section) const
{
  const auto& known = this->Kind.Sections;
  return std::find(known.begin(), known.end(), section.Name) != known.end() &&
    section.Version == SectionVersion;
}

void InputFile::ReadDirectory()
{
  std::array<std::uint8_t, HeaderSize> header{};
  const auto beginning = std::span(header).first(
    static_cast<std::size_t>(std::min<std::uint64_t>(HeaderSize, this->Size)));
  this->ReadAt(0, beginning);
  const auto& magic = this->Kind.FileMagic;
  if (this->Size < magic.size() || !std::equal(magic.begin(), magic.end(), header.begin()))
  {
    // A base mesh stands in a file that is one, which is damaged then.
    this->Fail(this->Base == 0 ? ErrorCode::NotGatun : ErrorCode::Corrupt,
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
  this->Major = in.Get<std::uint16_t>();
  this->Minor = in.Get<std::uint16_t>();
  if (this->Major != this->Kind.Major)
  {
    this->Fail(ErrorCode::UnsupportedVersion,
      "version " + std::to_string(this->Major) + "." + std::to_string(this->Minor) +
        " of the format is not supported, only " + std::to_string(this->Kind.Major) +
        ".x; a newer version of Gatun may read it");
  }
  if (in.Get<std::uint32_t>() != 0)
  {
    this->Fail(ErrorCode::Corrupt, "the file's header is damaged at byte 12");
  }

  std::array<std::uint8_t, TrailerSize> trailer{};
  this->ReadAt(this->Size - TrailerSize, trailer);
  ByteReader end(trailer);
  SectionRef directory;
  directory.Payload.Offset = end.Get<std::uint64_t>();
  directory.Payload.Length = end.Get<std::uint64_t>();
  const auto sum = end.Get<std::uint64_t>();
  const auto& endMagic = this->Kind.TrailerMagic;
  const auto last = end.GetBytes(endMagic.size());
  if (!std::equal(endMagic.begin(), endMagic.end(), last.begin()))
  {
    this->Fail(ErrorCode::Truncated,
      "the file does not end as it should; it is truncated, or damaged in its last bytes (size " +
        std::to_string(this->Size) + ")");
  }
  if (directory.Payload.Offset < HeaderSize + SectionHeaderSize ||
    directory.Payload.Offset > this->Size - TrailerSize ||
    directory.Payload.Length != this->Size - TrailerSize - directory.Payload.Offset)
  {
    this->Fail(ErrorCode::Corrupt,
      "the trailer is damaged" + AtOffset(this->Size - TrailerSize) +
        ": it points to no directory");
  }
  Bytes bytes(static_cast<std::size_t>(directory.Payload.Length));
  this->ReadAt(directory.Payload.Offset, bytes);
  if (SumOfFrame(header, bytes) != sum)
  {
    this->Fail(ErrorCode::Corrupt,
      "the directory" + AtOffset(directory.Payload.Offset) +
        " or the file's header is damaged: their checksum is wrong");
  }
  try
  {
    ByteReader list(bytes);
    const auto count = list.GetCount(SectionHeaderSize + 8);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      auto section = GetSectionHeader(list);
      section.Payload.Offset = list.Get<std::uint64_t>();
      if (!this->IsReadable(section) && (section.Flags & FlagMandatory))
      {
        this->Fail(ErrorCode::UnsupportedVersion,
          "the file has a section '" + ToText(section.Name) + "' (version " +
            std::to_string(section.Version) + ") that only a newer version of Gatun can read");
      }
      this->Sections.push_back(section);
    }
    if (list.GetRemaining() != 0)
    {
      ThrowCorrupt("there are bytes behind its end");
    }
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::Corrupt)
    {
      throw;
    }
    this->Fail(ErrorCode::Corrupt,
      "the directory" + AtOffset(directory.Payload.Offset) + " is damaged: " + error.what());
  }
}

std::vector<StreamRef> InputFile::FindSections(FourCC name) const
{
  std::vector<StreamRef> found;
  for (const auto& section : this->Sections)
  {
    if (section.Name == name && this->IsReadable(section))
    {
      found.push_back(section.Payload);
    }
  }
  return found;
}

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

void InputFile::CheckSections(const std::function<bool(double)>& progress) const
{
  std::uint64_t next = HeaderSize;
  for (std::size_t i = 0; i < this->Sections.size(); ++i)
  {
    const auto& section = this->Sections[i];
    const std::string what = "section '" + ToText(section.Name) + "'";
    if (section.Payload.Offset != next + SectionHeaderSize)
    {
      this->Fail(ErrorCode::Corrupt, what + " does not follow the one before it" + AtOffset(next));
    }
    std::array<std::uint8_t, SectionHeaderSize> bytes{};
    this->ReadAt(next, bytes);
    ByteWriter expected;
    PutSectionHeader(expected, section);
    if (!std::equal(bytes.begin(), bytes.end(), expected.Data.begin()))
    {
      this->Fail(ErrorCode::Corrupt, "the header of " + what + AtOffset(next) + " is damaged");
    }
    this->CheckSum(section.Payload, what);
    next = section.Payload.Offset + section.Payload.Length;
    if (progress &&
      !progress(static_cast<double>(i + 1) / static_cast<double>(this->Sections.size())))
    {
      throw Error(ErrorCode::Aborted, this->Path + ": aborted");
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
    this->Fail(ErrorCode::Corrupt, "the header of the directory" + AtOffset(next) + " is damaged");
  }
  this->CheckSum(
    { next + SectionHeaderSize, directory.Payload.Length, directory.Payload.Sum }, "the directory");
}
}
