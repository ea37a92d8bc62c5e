// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunSurfaceMapperInternals_h
#define vtkGatunSurfaceMapperInternals_h

#include "gatunDetailSettings.h"
#include "gatunOwned.h"
#include "gatunPublishedFile.h"
#include "gatunStatistics.h"
#include "gatunSurfaceCutter.h"
#include "gatunSurfaceLevel.h"
#include "gatunSurfacePreparer.h"
#include "gatunSurfaceTimes.h"
#include "gatunSurfaceView.h"
#include "vtkGatunChunkMapper.h"
#include "vtkGatunSurfaceMapper.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
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
  /** Levels of detail of an image in motion, both -1 at rest. */
  struct LevelChoice
  {
    int Wanted = -1;
    int Shown = -1; ///< until that is ready
  };

  std::optional<LevelChoice> Shared; ///< what several processes have agreed on

  std::set<std::string> Reported; ///< messages since the last image without an error
  std::exception_ptr Failure;     ///< the first one of the last image
  std::uint64_t Drawn = 0;
  std::uint64_t Culled = 0;
  std::uint64_t Decoded = 0;
  gatun::Owned<vtkGatunDetailPolicy> Policy;
  gatun::Statistics Statistics;

  ~vtkInternals();

  /** The file to draw in place of the input; null if there is none. The pipeline must be up to
   * date. */
  static const gatun::PublishedFile* FindFile(vtkGatunSurfaceMapper* mapper);

  /** The bounds of a file; unchanged if it has none. */
  static void GetBounds(const gatun::PublishedFile& file, vtkInformation* info, double* bounds);

  /** Brings the input up to date. Returns false if it is no file. */
  bool Open(vtkGatunSurfaceMapper* mapper, vtkActor* actor);

  void Draw(vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor);

  /** What this process would choose for the next image. */
  LevelChoice Propose(vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor);

  /** The ids in the pixels of a selection, which are those of the chunks, become those of the
   * surface. */
  void ProcessSelection(
    vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop);

  void Release(vtkWindow* window);

  bool IsDrawingFile() const { return this->Source.File != nullptr; }
  std::uint64_t GetBytes() const { return this->Bytes; }

  /** Waits for the background thread. */
  void Wait();

  /** Points of the last image; 0 if it was not simplified. */
  std::uint64_t GetDrawnPoints() const;

private:
  struct Chunk
  {
    vtkSmartPointer<vtkGatunChunkMapper> Mapper; ///< null if nothing is kept
    std::uint64_t Bytes = 0;
    std::uint64_t Frame = 0; ///< in which it was seen last
    gatun::NormalCone Cone;
    bool IsTransferred = false; ///< whether there are buffers
  };

  /** The surface, or one of its levels of detail. */
  struct Level
  {
    std::shared_ptr<const gatun::SurfaceMesh> Mesh;
    std::vector<Chunk> Chunks;
  };

  /** A surface for the view. */
  struct CutLevel
  {
    Level Chunks;
    std::shared_ptr<const gatun::SurfaceCut> Cut; // its mesh; null for none
  };

  /** The chunks of a level that can be seen, in the order in which they are drawn. */
  struct View
  {
    std::vector<std::uint32_t> Chunks;
    std::uint64_t Cells = 0; // of these
    std::uint64_t Culled = 0;
  };

  /** An image. */
  struct Image
  {
    vtkGatunSurfaceMapper* Mapper;
    vtkRenderer* Renderer;
    vtkActor* Actor;
    gatun::DetailSettings Detail;
    gatun::SurfaceView Camera;
    bool IsOpaque;
    std::uint64_t MemoryLimit; // for buffers, in bytes
  };

  using Part = gatun::SurfacePart;

  static gatun::SurfaceContents FindContents(
    const gatun::PublishedFile& file, vtkGatunSurfaceMapper* mapper, vtkActor* actor);
  static std::size_t CountMerges(const gatun::PublishedFile& file, double ratio);
  Image MakeImage(vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor) const;
  static double GetBudget(const Image& image);
  void Forget();
  template <typename Use>
  void EachChunk(const Use& use);
  void ChangeMerges(const gatun::PublishedFile& file, std::size_t merges);
  View FindVisible(const Image& image, Level& level) const;
  std::vector<std::uint32_t> FindMissing(
    const Image& image, const Level& level, std::span<const std::uint32_t> chunks) const;
  std::vector<Part> DecodeAll(
    const Level& level, std::span<const std::uint32_t> chunks, bool withIds);
  void DrawLevel(const Image& image, Level& level, const View& view);
  void DrawChunk(const Image& image, Level& level, std::uint32_t chunk, const Part* part);
  void Adopt(const Image& image, Level& level, std::uint32_t chunk, const Part& part);
  void Keep(const Image& image, Chunk& chunk);
  void MakeRoom(std::uint64_t budget, Chunk* last);
  void Drop(Chunk& chunk);

  // Levels of detail while somebody interacts.
  void FindLevels();
  bool IsReady(const Image& image, const Level& level, const View& view) const;
  void Prepare(const Image& image, Level& level, const std::vector<std::uint32_t>& chunks);
  std::vector<std::uint32_t> ListLikely(const Level& level, const View& view) const;
  std::vector<View> FindAllVisible(const Image& image);
  std::size_t FindReady(const Image& image, const std::vector<View>& views, std::size_t from) const;
  double Transfer(const Image& image, Level& level, const View& view, double seconds);
  void DrawInMotion(const Image& image, double budget);
  void DrawTimed(const Image& image, std::size_t shown, const View& view);
  void DrawShared(const Image& image);
  void PrepareMotion(const Image& image, const View& view, double seconds);

  // Surfaces for the view.
  bool HasCuts(const Image& image) const;
  std::optional<gatun::SurfaceCutOrder> MakeOrder(const Image& image) const;
  std::uint64_t CountPoints(double budget);
  void OrderCut(const Image& image, double budget);
  void TakeCut();
  std::vector<std::uint32_t> ListNew() const;
  void AdvanceCut(const Image& image, double seconds);
  void AdoptCut();
  bool DrawCut(const Image& image, double budget, double otherwise, bool isLevelReady);
  bool DrawPreciseCut(const Image& image);
  void ForgetCuts();

  gatun::PublishedFile Source; // without a file if none is drawn
  gatun::SurfaceContents What;
  std::shared_ptr<const gatun::SurfaceLevel> Whole; // the mesh of the first level
  std::vector<Level> Levels; // the surface, then those in motion from fine to coarse
  bool HasLevels = false;    // whether the levels in motion are known
  gatun::SurfaceTimes Times;
  std::size_t Present = 0;   // level of the last image
  std::size_t Merges = 0;    // of the last image
  double MotionBudget = 0.1; // of the last image in motion
  int Waiting = 0;           // images in motion since a chunk was transferred
  std::uint64_t Bytes = 0;   // of all chunks
  std::uint64_t Frame = 0;
  vtkWindow* Window = nullptr; // only compared
  bool IsSelecting = false;
  gatun::SurfacePreparer Preparer;

  CutLevel Cut;                // that was drawn last
  CutLevel Next;               // that takes its place once its visible chunks are there
  std::uint64_t CutPoints = 0; // of the last order
  std::optional<gatun::SurfaceDetailView> Ordered; // the view of the last order
  bool HasCutFailed = false;
  gatun::SurfaceCutter Cutter;
};

#endif
