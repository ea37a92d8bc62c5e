// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunSurfaceMapperInternals_h
#define vtkGatunSurfaceMapperInternals_h

#include "gatunPieceReader.h"
#include "gatunPublishedFile.h"
#include "gatunSurfaceView.h"
#include "vtkGatunChunkMapper.h"
#include "vtkGatunSurfaceMapper.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <exception>
#include <set>
#include <span>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPolyData;
class vtkWindow;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

/** The chunks of the file that a mapper draws. Methods throw gatun::Error. */
class vtkGatunSurfaceMapper::vtkInternals
{
public:
  std::set<std::string> Told; ///< messages since the last image without an error
  std::exception_ptr Failure; ///< the first one of the last image
  vtkIdType Drawn = 0;
  vtkIdType Culled = 0;
  vtkIdType Decoded = 0;

  ~vtkInternals();

  /** The file to draw in place of the input; null if there is none. The pipeline must be up to
   * date. */
  static const gatun::PublishedFile* FindFile(vtkGatunSurfaceMapper* mapper);

  /** The bounds of a file; unchanged if it has none. */
  static void GetBounds(const gatun::PublishedFile& file, double* bounds);

  /** Brings the input up to date. Returns false if it is no file. */
  bool Open(vtkGatunSurfaceMapper* mapper, vtkActor* actor);

  void Draw(vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor);

  /** The ids in the pixels of a selection, which are those of the chunks, become those of the
   * surface. */
  void ProcessSelection(
    vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop);

  void Release(vtkWindow* window);

  bool IsDrawingFile() const { return this->Source.File != nullptr; }
  std::uint64_t GetBytes() const { return this->Bytes; }

private:
  struct Chunk
  {
    vtkSmartPointer<vtkGatunChunkMapper> Mapper; ///< null if nothing is kept
    std::uint64_t Bytes = 0;
    std::uint64_t Frame = 0; ///< in which it was seen last
    gatun::NormalCone Cone;
  };

  /** What is drawn of the file. */
  struct Contents
  {
    std::vector<std::uint32_t> Arrays;
    std::string Scalars; ///< name of the array that gives colors
    std::size_t Step = 0;

    bool operator==(const Contents&) const = default;
  };

  /** A chunk that was decoded, or the reason why it was not. */
  struct Part
  {
    vtkSmartPointer<vtkPolyData> Mesh;
    gatun::NormalCone Cone;
    std::exception_ptr Failure;
  };

  static Contents FindContents(
    const gatun::PublishedFile& file, vtkGatunSurfaceMapper* mapper, vtkActor* actor);
  void Forget();
  std::vector<std::uint32_t> FindVisible(
    vtkGatunSurfaceMapper* mapper, const gatun::SurfaceView& view, bool isOpaque);
  std::vector<std::uint32_t> FindMissing(
    std::span<const std::uint32_t> chunks, vtkRenderer* renderer, vtkActor* actor) const;
  Part Decode(std::uint32_t chunk, bool withIds) const;
  std::vector<Part> DecodeAll(std::span<const std::uint32_t> chunks, bool withIds);
  void DrawChunk(vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor,
    std::uint32_t chunk, const Part* part);
  void Count(Chunk& chunk);
  void MakeRoom(std::uint64_t budget, Chunk* last);
  void Drop(Chunk& chunk);

  gatun::PublishedFile Source; // without a file if none is drawn
  Contents What;
  std::vector<Chunk> Chunks;
  std::uint64_t Bytes = 0; // of all chunks
  std::uint64_t Frame = 0;
  vtkWindow* Window = nullptr; // only compared
  bool IsSelecting = false;
};

#endif
