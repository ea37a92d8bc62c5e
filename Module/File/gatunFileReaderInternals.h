// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileReaderInternals_h
#define gatunFileReaderInternals_h

#include "gatunContainer.h"
#include "gatunFileReader.h"
#include "gatunGeometry.h"
#include "gatunLayers.h"
#include "gatunTables.h"
#include "gatunTreeTable.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** What FileReader has read of its file; the decoders take their streams from here. */
class FileReader::Internals
{
public:
  explicit Internals(const std::string& path);

  /** A base mesh of a file. */
  Internals(const Internals& whole, std::size_t level);

  /** How the values of an array become keys at a step. */
  std::vector<Domain> MakeDomains(std::size_t array, std::size_t step) const;

  /** Runs decode and puts file, what and where in front of what it throws. */
  template <typename Decode>
  auto Guarded(const std::string& what, const StreamRef& where, Decode&& decode) const
  {
    try
    {
      return decode();
    }
    catch (const Error& error)
    {
      if (error.Code != ErrorCode::Corrupt || this->IsComplete(error))
      {
        throw;
      }
      this->File.Fail(ErrorCode::Corrupt,
        what + " at byte " + std::to_string(where.Offset) + " is damaged: " + error.what());
    }
  }

  /** The step from which steps up to this one are decoded. */
  std::size_t FindKeyStep(std::size_t step) const
  {
    while (step > 0 && !this->Steps[step].Key)
    {
      --step;
    }
    return step;
  }

  /** Whether streams of an array at a step may refer to the step before. */
  bool HasBefore(std::size_t array, std::size_t step) const
  {
    return step > 0 && !this->Steps[step].Key && !this->Steps[step].Arrays[array].HasPalette() &&
      !this->Steps[step - 1].Arrays[array].HasPalette();
  }

  /** Throws unless the chunks' values, at the first step, are in the layers that they should be. */
  void CheckLayers() const;

  /** The name of a base mesh in messages. */
  static std::string GetLevelName(std::size_t level)
  {
    return "base mesh " + std::to_string(level + 1);
  }

  InputFile File;
  MetaTable Meta;
  MeshTable Mesh;
  std::vector<StepTable> Steps;
  std::vector<double> Times;
  std::vector<ChunkInfo> Chunks;
  PointDomain Domains;
  bool LayersAreKnown = false;
  Layers LayersOfChunks;
  std::optional<TreeTable> Tree;
  std::vector<TreeStepTable> TreeSteps;
  std::vector<StreamRef> Levels;

private:
  std::uint64_t StepBytes = 0; // of the tables of all steps, unpacked

  void Read();
  void ReadLayers();
  void ReadTree();
  void CheckLevel(const Internals& whole, std::size_t level) const;
  void AddStepBytes(std::span<const std::uint8_t> packed);
  void CheckLastStep() const;
  bool IsComplete(const Error& error) const
  {
    return std::string(error.what())
             .compare(0, this->File.GetPath().size(), this->File.GetPath()) == 0;
  }
};

inline const FileReader::Internals& InternalsOf(const FileReader& file)
{
  return *file.Self;
}
}

#endif
