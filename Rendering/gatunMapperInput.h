// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMapperInput_h
#define gatunMapperInput_h

#include "gatunErrorCodes.h"
#include "gatunPieceRaySource.h"
#include "gatunRayScene.h"

#include "vtkType.h"

#include <cstdint>
#include <string>

namespace gatun
{
struct PublishedFile;

/** The kinds of input that a mapper draws in different ways. */
enum class InputKind
{
  None,
  Grid,
  File,
  Pieces
};

/** The input of a mapper, and the pieces of it that are drawn. */
struct MapperConnection
{
  RayProducer Producer;
  PieceShare Pieces;
};

/** Makes the input of a mapper a scene: a grid, the file of a reader, or pieces. Methods throw
 * gatun::Error. */
class MapperInput
{
public:
  InputKind GetKind(const MapperConnection& input);

  /** The file to be drawn in place of the input, or null; it may have failed to open. */
  const PublishedFile* FindFile(const MapperConnection& input);

  /** The same where there is one, but throws if it failed to open. */
  const PublishedFile& GetFile(const MapperConnection& input);

  /** The time step of the file that is requested. */
  static std::size_t GetStep(const MapperConnection& input, const PublishedFile& file);

  /** Brings up to date what the mapper needs of the pipeline before an image. */
  void Pull(const MapperConnection& input);

  /** Sets the scene. Budget: of memory, in bytes. Simplifies: whether coarser meshes are to be
   * drawn, too. Returns whether there is something to draw. */
  bool SetScene(const MapperConnection& input, const RayArray& array, std::uint64_t budget,
    bool simplifies, const RaySource::Progress& progress);

  RayScene& GetScene() { return this->Scene; }
  const RayScene& GetScene() const { return this->Scene; }

  /** The bounds of the file. */
  Bounds GetFileBounds(const MapperConnection& input);

  /** A number for the file, the values and the step that are drawn: different ones have different
   * numbers. 0 without a file. */
  std::uint64_t Identify(const MapperConnection& input);

  /** The reason why coarser meshes that were wanted cannot be made; empty if there is none, or if
   * it was returned before. */
  std::string TakeReason();

  /** The cause of a failure: the same for all the damage in a file, as threads meet damaged blocks
   * in any order. */
  std::string GetCause(const MapperConnection& input, const VTKFailure& failure);

private:
  void UpdateInformation(const RayProducer& producer);

  RayScene Scene;
  std::string Reason; // that was returned

  // The input whose information could not be made, and when: it is not asked again before it has
  // changed, as it would report the same error.
  const void* FailedInput = nullptr;
  vtkMTimeType FailedTime = 0;
};
}

#endif
