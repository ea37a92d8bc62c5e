// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunContainer_h
#define gatunContainer_h

// Bytes on disk: the file's header, sections, directory and trailer. See Documentation/format.md.

#include "gatunBytes.h"
#include "gatunVersion.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace gatun
{
constexpr std::array<std::uint8_t, 8> FileMagic{ 0x89, 'G', 'T', 'N', '\r', '\n', 0x1a, '\n' };
constexpr std::array<std::uint8_t, 8> TrailerMagic{ 'G', 'T', 'N', 'E', 'N', 'D', '\r', '\n' };
constexpr std::size_t HeaderSize = 16;
constexpr std::size_t SectionHeaderSize = 24;
constexpr std::size_t TrailerSize = 32;

using FourCC = std::uint32_t;

constexpr FourCC MakeFourCC(const char (&name)[5])
{
  return static_cast<FourCC>(name[0]) | static_cast<FourCC>(name[1]) << 8 |
    static_cast<FourCC>(name[2]) << 16 | static_cast<FourCC>(name[3]) << 24;
}

constexpr FourCC SectionMeta = MakeFourCC("META");      // counts and arrays
constexpr FourCC SectionMesh = MakeFourCC("MESH");      // streams of blocks and chunks
constexpr FourCC SectionTable = MakeFourCC("TABL");     // where those streams are
constexpr FourCC SectionValues = MakeFourCC("VALS");    // streams of arrays, field data
constexpr FourCC SectionStep = MakeFourCC("STEP");      // where those streams are, for one step
constexpr FourCC SectionTree = MakeFourCC("TREE");      // how the mesh becomes simpler
constexpr FourCC SectionMerges = MakeFourCC("MERG");    // the stream of that
constexpr FourCC SectionTreeStep = MakeFourCC("TRNG");  // what values that leads to, for one step
constexpr FourCC SectionLevel = MakeFourCC("LEVL");     // a simpler mesh, a file in the file
constexpr FourCC SectionLayers = MakeFourCC("LAYR");    // by which values chunks were made
constexpr FourCC SectionDirectory = MakeFourCC("DIRY"); // where the sections are

constexpr FourCC SectionBlocks = MakeFourCC("BLKS"); // streams of blocks of a volume

/** What files of a kind begin and end with, and what may be in them. */
struct ContainerKind
{
  const char* Suffix;
  std::array<std::uint8_t, 8> FileMagic;
  std::array<std::uint8_t, 8> TrailerMagic;
  std::uint16_t Major; ///< version
  std::span<const FourCC> Sections;
};

inline constexpr std::array MeshSections{ SectionMeta, SectionMesh, SectionTable, SectionValues,
  SectionStep, SectionTree, SectionMerges, SectionTreeStep, SectionLevel, SectionLayers,
  SectionDirectory };
inline constexpr ContainerKind MeshContainer{ ".gtn", FileMagic, TrailerMagic,
  GATUN_FORMAT_VERSION_MAJOR, MeshSections };

inline constexpr std::array VolumeSections{ SectionMeta, SectionBlocks, SectionTable,
  SectionDirectory };
inline constexpr ContainerKind VolumeContainer{ ".ghv",
  { 0x89, 'G', 'H', 'V', '\r', '\n', 0x1a, '\n' }, { 'G', 'H', 'V', 'E', 'N', 'D', '\r', '\n' },
  GATUN_VOLUME_FORMAT_VERSION_MAJOR, VolumeSections };

constexpr std::uint16_t SectionVersion = 1;
constexpr std::uint16_t FlagMandatory = 1; // a reader that does not know the section must stop

// The minor version of files that have just what every reader knows, and of those with more.
constexpr std::uint16_t MinorVersionPlain = 0;
constexpr std::uint16_t MinorVersionWithTree = 1;
constexpr std::uint16_t MinorVersionWithLayers = 2;

/** Whether a regular file begins as those of a kind do. */
bool BeginsAs(const std::string& path, const ContainerKind& kind) noexcept;

std::uint64_t Checksum(std::span<const std::uint8_t> bytes);

/** zstd, with the length in front; decompression refuses more than limit bytes. */
Bytes Compress(std::span<const std::uint8_t> bytes);
Bytes Decompress(std::span<const std::uint8_t> bytes, std::uint64_t limit);

/** A part of the file that is read and checked as a whole. */
struct StreamRef
{
  std::uint64_t Offset = 0;
  std::uint64_t Length = 0;
  std::uint64_t Sum = 0;
};

struct SectionRef
{
  FourCC Name = 0;
  std::uint16_t Version = SectionVersion;
  std::uint16_t Flags = 0;
  StreamRef Payload; // Offset is that of the payload, behind the section's header
};

/**
 * A file that appears under its name only when it is complete. Until Commit it is a temporary file
 * in the same folder, which the destructor removes.
 */
class OutputFile
{
public:
  /** replaceReadOnly: also where an existing file may not be written. */
  OutputFile(const std::string& path, bool replaceReadOnly, std::uint16_t minorVersion,
    const ContainerKind& kind = MeshContainer);

  /** A file that becomes a section of another one; it never has a name. */
  OutputFile(const OutputFile& whole, std::uint16_t minorVersion);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /** Appends a section; returns the file offset of its payload. */
  std::uint64_t AddSection(
    FourCC name, std::span<const std::uint8_t> payload, std::uint16_t flags = FlagMandatory);

  /** Appends a section, which readers need not know, with all of another file, which is complete
   * with that. Returns how long it is. */
  std::uint64_t AddSection(FourCC name, OutputFile& part);

  /** Writes directory and trailer, and gives the file its name. Returns the file's size. */
  std::uint64_t Commit();

private:
  void Begin(std::uint16_t minorVersion);
  void WriteEnd();
  void Write(std::span<const std::uint8_t> bytes);
  [[noreturn]] void Fail(const std::string& what) const;

  const ContainerKind& Kind;
  std::string Path;      // as given, for messages
  std::string Target;    // where links lead
  std::string Temporary; // empty after Commit
  int Handle = -1;
  std::uint64_t Size = 0;
  Bytes Header;
  std::vector<SectionRef> Sections;
};

/** An open file with a checked header, trailer and directory. Thread safe. */
class InputFile
{
public:
  explicit InputFile(const std::string& path, const ContainerKind& kind = MeshContainer);

  /** A file that is a section of another one; name is what messages say of it. */
  InputFile(const InputFile& whole, const StreamRef& section, const std::string& name);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& GetPath() const { return this->Path; }
  std::uint64_t GetSize() const { return this->Size; }
  std::uint64_t GetBytesRead() const { return this->BytesRead; }
  const std::vector<SectionRef>& GetSections() const { return this->Sections; }
  std::uint16_t GetMajor() const { return this->Major; }
  std::uint16_t GetMinor() const { return this->Minor; }

  /** Reads a stream and checks its sum; what names it in messages. */
  Bytes Read(const StreamRef& stream, const std::string& what) const;

  /** Checks the sum of a stream of any length. */
  void CheckSum(const StreamRef& stream, const std::string& what) const;

  /** The payloads of the sections of a name, but for versions that are not known. */
  std::vector<StreamRef> FindSections(FourCC name) const;

  /** The payload of the only section of a name; throws unless there is exactly one. */
  StreamRef FindSection(FourCC name, const char* what) const;

  /** Checks the headers and sums of all sections, and that they fill the file without gaps. */
  void CheckSections(const std::function<bool(double)>& progress) const;

  /** Throws an error whose message begins with the file's name. */
  [[noreturn]] void Fail(ErrorCode code, const std::string& what) const;

private:
  void ReadAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const;
  bool IsReadable(const SectionRef& section) const;
  void ReadDirectory();
  void CheckInside(const StreamRef& stream, const std::string& what) const;
  [[noreturn]] void FailSum(const StreamRef& stream, const std::string& what) const;

  const ContainerKind& Kind;
  std::string Path;
  int Handle = -1;
  std::uint64_t Base = 0; // where it begins in the file that has a name
  std::uint64_t Size = 0;
  std::uint16_t Major = 0;
  std::uint16_t Minor = 0;
  std::vector<SectionRef> Sections;
  mutable std::atomic<std::uint64_t> BytesRead{ 0 };
};
}

#endif
