// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSurfaceMapper.h"

#include "gatunChunkDrawer.h"
#include "gatunCutDrawer.h"
#include "gatunDetailSettings.h"
#include "gatunErrorCodes.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunFrameClock.h"
#include "gatunLevelDrawer.h"
#include "gatunOwned.h"
#include "gatunPublishedFile.h"
#include "gatunSimplifyProperties.h"
#include "gatunStatistics.h"

#include "vtkAbstractArray.h"
#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunSurfaceMapper);

namespace
{
constexpr std::uint64_t MiB = std::uint64_t{ 1 } << 20;

//------------------------------------------------------------------------------
bool HasRole(const gatun::ArrayDescription& array, int attribute)
{
  return (array.AttributeRoles >> attribute & 1u) != 0;
}

//------------------------------------------------------------------------------
/** The number of merges for a reader's choice and a ratio of points to remove. */
std::size_t CountMerges(const gatun::PublishedFile& file, double ratio)
{
  if (ratio <= 0)
  {
    return file.Merges;
  }
  file.File->RequireHierarchy();
  const gatun::FileReader& reader = *file.File->GetFile();
  const std::size_t merges = gatun::CountMerges({ gatun::SimplifyTarget::Ratio, ratio },
    reader.GetNumberOfPoints(), reader.GetNumberOfMerges(), {});
  return std::max(merges, file.Merges);
}

//------------------------------------------------------------------------------
/** Seconds for an image in motion; 0 at rest. Allocated: by VTK. */
double GetBudget(const gatun::DetailSettings& detail, double allocated)
{
  if (!detail.JustInTime || !(allocated > 0 && allocated < gatun::LeastTimeAtRest))
  {
    return 0;
  }
  return detail.TimeBudget > 0 ? detail.TimeBudget : allocated;
}
}

//------------------------------------------------------------------------------
/** The surface that a mapper draws. Methods throw gatun::Error. */
class vtkGatunSurfaceMapper::vtkInternals
{
public:
  gatun::Owned<vtkGatunDetailPolicy> Policy;
  gatun::Statistics Statistics;
  std::set<std::string> Reported;           ///< messages since the last image without an error
  std::optional<gatun::LevelChoice> Shared; ///< what several processes have agreed on

  gatun::DrawnSurface Surface;
  gatun::ChunkDrawer Chunks;
  gatun::LevelDrawer Levels{ Chunks };
  gatun::CutDrawer Cuts{ Chunks };

  /** The file to draw in place of the input; null if there is none. The pipeline must be up to
   * date. */
  static const gatun::PublishedFile* FindFile(vtkGatunSurfaceMapper* mapper);

  /** The bounds of a file; unchanged if it has none. */
  static void GetBounds(const gatun::PublishedFile& file, vtkInformation* info, double* bounds);

  static gatun::SurfaceContents FindContents(
    const gatun::PublishedFile& file, vtkGatunSurfaceMapper* mapper, vtkActor* actor);

  /** Brings the input up to date. Returns false if it is no file. */
  bool Open(vtkGatunSurfaceMapper* mapper, vtkActor* actor);

  gatun::SurfaceImage MakeImage(
    vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor) const;
  void Draw(const gatun::SurfaceImage& image);

  /** The ids in the pixels of a selection, which are those of the chunks, become those of the
   * surface. */
  void ProcessSelection(
    vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop);

  bool IsDrawingFile() const { return this->Surface.Source.File != nullptr; }

  /** Points of the last image; 0 if it was not simplified. */
  std::uint64_t GetDrawnPoints() const;

private:
  void Clear();
  void DrawInMotion(const gatun::SurfaceImage& image, double budget);
};

//------------------------------------------------------------------------------
const gatun::PublishedFile* vtkGatunSurfaceMapper::vtkInternals::FindFile(
  vtkGatunSurfaceMapper* mapper)
{
  if (mapper->GetNumberOfInputConnections(0) < 1)
  {
    return nullptr;
  }
  const gatun::PublishedFile* const file = gatun::GetUsableFile(mapper->GetInputInformation());
  return file && file->OnDemand && file->File->GetFile()->IsSurface() ? file : nullptr;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::GetBounds(
  const gatun::PublishedFile& file, vtkInformation* info, double* bounds)
{
  const gatun::FileReader& reader = *file.File->GetFile();
  const gatun::Bounds box = reader.GetBounds(gatun::GetRequestedStep(reader, info));
  if (!box.IsEmpty())
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = box[axis].Min;
      bounds[2 * axis + 1] = box[axis].Max;
    }
  }
}

//------------------------------------------------------------------------------
gatun::SurfaceContents vtkGatunSurfaceMapper::vtkInternals::FindContents(
  const gatun::PublishedFile& file, vtkGatunSurfaceMapper* mapper, vtkActor* actor)
{
  const gatun::FileReader& reader = *file.File->GetFile();
  gatun::SurfaceContents what;
  what.Step = gatun::GetRequestedStep(reader, mapper->GetInputInformation());
  int where = 0;
  vtkAbstractArray* const scalars = mapper->ScalarVisibility && mapper->GetInput()
    ? vtkAbstractMapper::GetAbstractScalars(mapper->GetInput(), mapper->ScalarMode,
        mapper->ArrayAccessMode, mapper->ArrayId, mapper->ArrayName, where)
    : nullptr;
  if (scalars && scalars->GetName())
  {
    what.Scalars = scalars->GetName();
  }
  const bool hasTextures = mapper->HaveTextures(actor);
  const auto association = where == 0 ? gatun::Association::Point : gatun::Association::Cell;
  for (std::uint32_t i = 0; i < reader.GetArrays().size() && reader.GetNumberOfSteps() > 0; ++i)
  {
    const gatun::ArrayDescription& array = reader.GetArrays()[i];
    const bool gives =
      scalars && where < 2 && array.Where == association && array.Name == what.Scalars;
    if (file.Selected[i] &&
      (gives || HasRole(array, vtkDataSetAttributes::NORMALS) ||
        (hasTextures && HasRole(array, vtkDataSetAttributes::TCOORDS))))
    {
      what.Arrays.push_back(i);
    }
  }
  return what;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Clear()
{
  this->Levels.Clear();
  this->Cuts.Clear();
  this->Chunks.ForgetPrepared();
  this->Surface = {};
}

//------------------------------------------------------------------------------
bool vtkGatunSurfaceMapper::vtkInternals::Open(vtkGatunSurfaceMapper* mapper, vtkActor* actor)
{
  this->Chunks.Reset();
  if (mapper->GetNumberOfInputConnections(0) > 0 && !mapper->GetStatic())
  {
    mapper->GetInputAlgorithm()->Update();
  }
  const gatun::PublishedFile* const file = FindFile(mapper);
  if (!file)
  {
    this->Clear();
    return false;
  }
  gatun::SurfaceContents what = FindContents(*file, mapper, actor);
  const std::size_t merges = CountMerges(*file, gatun::DetailSettings(this->Policy.Get()).Ratio);
  const gatun::PublishedFile& before = this->Surface.Source;
  const bool isSame = this->Surface.Mesh && file->File == before.File &&
    file->RestoreOrder == before.RestoreOrder && what == this->Surface.What;
  if (!isSame)
  {
    this->Clear();
  }
  gatun::DrawnSurface surface{ *file, std::move(what), this->Surface.Mesh };
  if (!isSame || merges != surface.Mesh->GetMerges())
  {
    surface.Mesh = std::make_shared<const gatun::SurfaceLevel>(*file, merges, surface.What);
    this->Chunks.SetContents(
      file->File->GetFile()->GetBounds(surface.What.Step), surface.What.Scalars);
    this->Levels.SetSurface(surface);
    this->Cuts.SetSurface(surface);
  }
  this->Surface = std::move(surface);
  return true;
}

//------------------------------------------------------------------------------
gatun::SurfaceImage vtkGatunSurfaceMapper::vtkInternals::MakeImage(
  vtkGatunSurfaceMapper* mapper, vtkRenderer* renderer, vtkActor* actor) const
{
  return { mapper, renderer, actor, gatun::DetailSettings(this->Policy.Get()),
    MiB * static_cast<std::uint64_t>(mapper->MemoryBudget) };
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::Draw(const gatun::SurfaceImage& image)
{
  this->Chunks.BeginFrame(image);
  if (!image.IsSelection)
  {
    if (this->Shared && this->Shared->Shown >= 0)
    {
      this->Levels.DrawShared(image, *this->Shared);
      return;
    }
    // An actor within another one, as in ParaView, is allocated nothing.
    const double allocated =
      std::min(image.Actor->GetAllocatedRenderTime(), image.Renderer->GetAllocatedRenderTime());
    const double budget = this->Shared ? 0 : GetBudget(image.Detail, allocated);
    if (budget > 0)
    {
      this->DrawInMotion(image, budget);
      return;
    }
    if (image.Detail.PixelError > 0 && this->Cuts.DrawPrecise(image))
    {
      this->Levels.NoteOther();
      return;
    }
  }
  if (this->Levels.DrawWhole(image) && this->Levels.PrepareMotion(image) && !this->Shared)
  {
    this->Cuts.Request(image, this->Levels.GetMotionBudget());
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::DrawInMotion(
  const gatun::SurfaceImage& image, double budget)
{
  const gatun::LevelDrawer::Plan plan = this->Levels.MakePlan(image, budget);
  if (plan.Wanted > 0 &&
    this->Cuts.DrawInMotion(image, budget, plan.Seconds, plan.Shown == plan.Wanted))
  {
    this->Levels.NoteOther();
    return;
  }
  this->Levels.DrawInMotion(image, plan, !this->Cuts.IsAdvancing());
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::vtkInternals::ProcessSelection(
  vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop)
{
  const int pass = vtkHardwareSelector::COMPOSITE_INDEX_PASS;
  const unsigned char* const drawn = selector->GetRawPixelBuffer(pass);
  unsigned char* const told = selector->GetPixelBuffer(pass);
  if (!drawn || this->Levels.IsEmpty())
  {
    return;
  }
  std::map<std::uint32_t, std::vector<unsigned int>> pixelsOf;
  for (const unsigned int pixel : pixels)
  {
    const std::uint32_t number = drawn[pixel] + 256u * drawn[pixel + 1] + 65536u * drawn[pixel + 2];
    pixelsOf[number].push_back(pixel);
    if (told)
    {
      // The number of a chunk is nothing that concerns the user.
      std::fill_n(told + pixel, 3, static_cast<unsigned char>(0));
    }
  }
  for (auto& [number, list] : pixelsOf)
  {
    auto& chunks = this->Levels.GetWhole().Chunks;
    if (number > 0 && number <= chunks.size() && chunks[number - 1].Mapper)
    {
      chunks[number - 1].Mapper->ProcessSelectorPixelBuffers(selector, list, prop);
    }
  }
}

//------------------------------------------------------------------------------
std::uint64_t vtkGatunSurfaceMapper::vtkInternals::GetDrawnPoints() const
{
  const std::uint64_t merges = this->Chunks.GetCounts().Merges;
  return this->Surface.Mesh && merges > 0
    ? this->Surface.Source.File->GetFile()->GetNumberOfPoints() - merges
    : 0;
}

//------------------------------------------------------------------------------
vtkGatunSurfaceMapper::vtkGatunSurfaceMapper()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkGatunSurfaceMapper::~vtkGatunSurfaceMapper() = default;

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetMemoryBudget(int mebibytes)
{
  this->MemoryBudget = std::max(0, mebibytes);
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetDetailPolicy(vtkGatunDetailPolicy* policy)
{
  this->Internals->Policy.Set(policy);
}

//------------------------------------------------------------------------------
vtkGatunDetailPolicy* vtkGatunSurfaceMapper::GetDetailPolicy()
{
  return this->Internals->Policy.Get();
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunSurfaceMapper::GetStatistics()
{
  auto& self = *this->Internals;
  self.Statistics.Clear();
  self.Statistics.Add("DrawnPoints", self.GetDrawnPoints());
  self.Statistics.Add("DrawnChunks", self.Chunks.GetCounts().Drawn);
  self.Statistics.Add("CulledChunks", self.Chunks.GetCounts().Culled);
  self.Statistics.Add("DecodedChunks", self.Chunks.GetCounts().Decoded);
  self.Statistics.Add("BufferBytes", self.Chunks.Buffers.GetBytes());
  return self.Statistics.Get();
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::WaitForPreparation()
{
  this->Internals->Cuts.Wait();
  this->Internals->Chunks.Wait();
}

//------------------------------------------------------------------------------
bool vtkGatunSurfaceMapper::GetIsDrawingFile()
{
  return this->Internals->IsDrawingFile();
}

//------------------------------------------------------------------------------
double* vtkGatunSurfaceMapper::GetBounds()
{
  double* const bounds = this->Superclass::GetBounds();
  if (const gatun::PublishedFile* const file = vtkInternals::FindFile(this))
  {
    vtkInternals::GetBounds(*file, this->GetInputInformation(), bounds);
  }
  return bounds;
}

//------------------------------------------------------------------------------
/** Reports what is being thrown. */
void vtkGatunSurfaceMapper::Fail() noexcept
{
  try
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The surface cannot be drawn");
    this->SetErrorCode(failure.Code);
    if (!failure.Aborted && this->Internals->Reported.insert(failure.Message).second)
    {
      vtkErrorMacro(<< failure.Message);
    }
  }
  catch (...)
  {
    // No memory for a message, or an observer of errors that throws.
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  auto& self = *this->Internals;
  this->SetErrorCode(vtkErrorCode::NoError);
  bool isFile = false;
  try
  {
    isFile = self.Open(this, actor);
    if (isFile)
    {
      self.Draw(self.MakeImage(this, renderer, actor));
      if (self.Chunks.GetFailure())
      {
        std::rethrow_exception(self.Chunks.GetFailure());
      }
      self.Reported.clear();
    }
  }
  catch (...)
  {
    isFile = true;
    this->Fail();
  }
  if (!isFile)
  {
    this->Superclass::RenderPiece(renderer, actor);
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::ProposeLevels(vtkRenderer* renderer, vtkActor* actor, int levels[2])
{
  levels[0] = levels[1] = -1;
  try
  {
    auto& self = *this->Internals;
    if (renderer && actor && self.Open(this, actor))
    {
      const gatun::SurfaceImage image = self.MakeImage(this, renderer, actor);
      // VTK allocates the time later, and all of a window's to the renderers of an image.
      const double budget =
        GetBudget(image.Detail, 1 / renderer->GetRenderWindow()->GetDesiredUpdateRate());
      const auto choice = budget > 0 ? self.Levels.Propose(image, budget) : gatun::LevelChoice{};
      levels[0] = choice.Wanted;
      levels[1] = choice.Shown;
    }
  }
  catch (...)
  {
    // RenderPiece fails, too, and tells the error.
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetLevels(const int levels[2])
{
  this->Internals->Shared = gatun::LevelChoice{ levels[0], levels[1] };
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::ResetLevels()
{
  this->Internals->Shared.reset();
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixels, vtkProp* prop)
{
  if (!this->Internals->IsDrawingFile())
  {
    this->Superclass::ProcessSelectorPixelBuffers(selector, pixels, prop);
    return;
  }
  try
  {
    this->Internals->ProcessSelection(selector, pixels, prop);
  }
  catch (...)
  {
    this->Fail();
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Chunks.Buffers.Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "DetailPolicy:\n";
  this->GetDetailPolicy()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "IsDrawingFile: " << (this->GetIsDrawingFile() ? "true" : "false") << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
