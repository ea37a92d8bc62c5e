// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyProjector.h"

#include "gatunError.h"
#include "gatunHartleyBasis.h"
#include "gatunHartleyBlocks.h"
#include "gatunHartleyChunks.h"
#include "gatunHartleyLookup.h"
#include "gatunHartleyPaperSlice.h"
#include "gatunHartleySlab.h"
#include "gatunHartleySlice.h"
#include "gatunHartleyStencil.h"
#include "gatunHartleyXRays.h"
#include "gatunParallel.h"
#include "gatunVector.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string>

namespace gatun
{
namespace
{
using Vector = HartleyView::Vector;
using Triple = HartleyLayout::Triple;

// Upper bound of the memory for the images of blocks that are projected at the same time. One row
// of blocks may take more.
constexpr std::size_t BatchBytes = std::size_t{ 32 } << 20;

// Upper bound of the memory for the images of basis functions.
constexpr std::uint64_t MostBasisBytes = std::uint64_t{ 1 } << 30;

//------------------------------------------------------------------------------
void Check(const HartleyView& view)
{
  if (view.Width == 0 || view.Height == 0)
  {
    ThrowInvalid("the image has no pixels");
  }
  for (const Vector* const vector : { &view.Origin, &view.ColumnStep, &view.RowStep, &view.Step })
  {
    if (!std::all_of(vector->begin(), vector->end(), [](double v) { return std::isfinite(v); }))
    {
      ThrowInvalid("the view has numbers that are not finite");
    }
  }
  const double volume =
    glm::dot(ToVector(view.ColumnStep), glm::cross(ToVector(view.RowStep), ToVector(view.Step)));
  if (!std::isfinite(volume) || volume == 0)
  {
    ThrowInvalid("the columns, rows and rays of the view are linearly dependent");
  }
}

//------------------------------------------------------------------------------
void Check(const HartleyShading& shading)
{
  if (shading.OpacityModel != HartleyOpacityModel::XRay && shading.Table.size() < 2)
  {
    ThrowInvalid("the transfer function has less than two entries");
  }
  if (shading.OpacityModel == HartleyOpacityModel::Exponential &&
    (!std::isfinite(shading.Extinction) || shading.Extinction < 0 || !std::isfinite(shading.Zero)))
  {
    ThrowInvalid("the extinction or zero is negative or not finite");
  }
}

//------------------------------------------------------------------------------
void Check(const HartleyOptions& options)
{
  if (!(options.Padding >= 1 && options.Padding <= 8))
  {
    ThrowInvalid("the padding is not between 1 and 8");
  }
}
}

//------------------------------------------------------------------------------
struct HartleyProjector::Internals
{
  std::shared_ptr<const HartleySource> Source;
  HartleyLayout Layout;
  HartleyOptions Options;

  // For one direction of the rays.
  std::optional<HartleyLattice> Lattice;
  HartleyView View; // that Painter was made for
  std::unique_ptr<HartleyPainter> Painter;
  std::map<Triple, std::vector<float>> Units;

  std::shared_ptr<HartleySpectra> Spectra;
  std::shared_ptr<HartleyBlockVoxels> BlockVoxels;
  std::optional<HartleyChunks> Chunks;

  // Of each block the number of its terms, once it was loaded.
  static constexpr std::uint32_t Unknown = 0xffffffff;
  std::vector<std::uint32_t> TermCounts;

  /** Whether the coefficients of a block have to be loaded to draw it. */
  bool NeedsTerms(const Triple& place) const
  {
    const std::size_t block = this->Layout.GetBlockNumber(place);
    const std::uint32_t count = this->TermCounts[block];
    return count == Unknown || (count > 0 && !this->Painter->IsKept(block));
  }

  HartleyXRays XRays;

  HartleyMethod GetMethod() const;
  bool IsLarge() const
  {
    return *std::max_element(this->Layout.Block.begin(), this->Layout.Block.end()) >
      HartleyLayout::LargestBlock;
  }
  void Prepare(const HartleyView& view, const std::function<bool(double)>& progress);
  void UseSpectra(const SpectrumPlan& plan);
  const std::vector<float>& GetUnit(const Triple& filled);
  BlockImage MakeBlockImage(HartleyPainter::Brush& brush, const HartleyView& view,
    const Triple& place, std::span<const HartleyTerm> terms) const;

  /** The place of a block whose position along the lattice's axes is given. */
  Triple ToPlace(std::uint32_t across, std::uint32_t down, std::uint32_t along) const
  {
    Triple place{};
    place[this->Lattice->Axes[0]] = across;
    place[this->Lattice->Axes[1]] = down;
    place[this->Lattice->Axes[2]] = along;
    return place;
  }
};

namespace
{
//------------------------------------------------------------------------------
void Paint(const HartleyPainter& painter, std::span<const HartleyPainter::Task> tasks)
{
  const auto threads = static_cast<std::size_t>(GetNumberOfThreads());
  if (tasks.size() <= threads / 2)
  {
    painter.MakeBrush()->Paint(tasks); // which is parallel itself
    return;
  }
  const std::size_t each = std::max<std::size_t>(1, tasks.size() / (threads * 8));
  ParallelFor((tasks.size() + each - 1) / each,
    [&](std::size_t i) {
      painter.MakeBrush()->Paint(tasks.subspan(i * each, std::min(each, tasks.size() - i * each)));
    });
}

//------------------------------------------------------------------------------
/** The range [first, end) of blocks along an axis that may be visible between two sheared
 * coordinates. */
std::array<std::uint32_t, 2> FindBlocks(const HartleyLattice& lattice, std::size_t axis,
  std::uint32_t blocks, double middleAlong, double low, double high)
{
  const double reach =
    static_cast<double>(lattice.Points[axis] / 2 + HartleySlab::Margin) * HartleyLattice::Spacing;
  const double size = lattice.Block[axis];
  const double middle = (size - 1) / 2 - lattice.Shear[axis] * middleAlong;
  const double most = blocks;
  const double first = std::clamp(std::ceil((low - reach - middle) / size), 0.0, most);
  const double end = std::clamp(std::floor((high + reach - middle) / size) + 1, 0.0, most);
  return { static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(std::max(first, end)) };
}

//------------------------------------------------------------------------------
/** The lowest and highest sheared coordinates of the pixels, across and down. */
std::array<std::array<double, 2>, 2> GetBox(const HartleyLattice& lattice, const HartleyView& view)
{
  const auto origin = lattice.Project(view.Origin);
  const auto column = lattice.Project(view.ColumnStep);
  const auto row = lattice.Project(view.RowStep);
  std::array<std::array<double, 2>, 2> box;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double across = column[i] * (view.Width - 1);
    const double down = row[i] * (view.Height - 1);
    box[i] = { origin[i] + std::min(0.0, across) + std::min(0.0, down),
      origin[i] + std::max(0.0, across) + std::max(0.0, down) };
  }
  return box;
}

}

//------------------------------------------------------------------------------
HartleyMethod HartleyProjector::Internals::GetMethod() const
{
  if (this->Options.Method != HartleyMethod::Automatic)
  {
    return this->Options.Method;
  }
  return this->Options.Kernel == HartleyKernel::Trilinear || this->IsLarge()
    ? HartleyMethod::Slice
    : HartleyMethod::Voxels;
}

//------------------------------------------------------------------------------
void HartleyProjector::Internals::UseSpectra(const SpectrumPlan& plan)
{
  if (!this->Spectra || !(this->Spectra->GetPlan() == plan))
  {
    this->Spectra = std::make_shared<HartleySpectra>(plan, this->Options.CacheBytes);
  }
}

//------------------------------------------------------------------------------
void HartleyProjector::Internals::Prepare(
  const HartleyView& view, const std::function<bool(double)>& progress)
{
  const auto& block = this->Layout.Block;
  const auto lattice = HartleyLattice::Make(block, view.Step);
  const bool paper =
    this->GetMethod() == HartleyMethod::Slice && this->Options.Kernel == HartleyKernel::Trilinear;
  if (this->Painter && this->Lattice == lattice &&
    (!paper || (view.Step == this->View.Step && view.ColumnStep == this->View.ColumnStep)))
  {
    return;
  }
  this->Painter.reset();
  this->Units.clear();
  this->Lattice = lattice;
  this->View = view;
  if (this->GetMethod() == HartleyMethod::Basis)
  {
    const std::uint64_t bytes = std::uint64_t{ this->Layout.GetVoxelsPerBlock() } *
      lattice.GetNumberOfPoints() * sizeof(float);
    if (bytes > MostBasisBytes)
    {
      ThrowInvalid("the images of the basis functions of blocks of " + std::to_string(block[0]) +
        " x " + std::to_string(block[1]) + " x " + std::to_string(block[2]) + " voxels take " +
        std::to_string(bytes >> 20) + " MiB; use the method Slice for blocks of this size");
    }
    this->Painter = std::make_unique<HartleyBasis>(block, lattice, progress);
  }
  else if (paper)
  {
    this->UseSpectra(HartleyPaperSlice::MakePlan(block, this->Options.Padding));
    this->Painter = std::make_unique<HartleyPaperSlice>(lattice, view, this->Spectra);
  }
  else if (this->GetMethod() == HartleyMethod::Voxels)
  {
    if (this->IsLarge())
    {
      ThrowInvalid("blocks have more than " + std::to_string(HartleyLayout::LargestBlock) +
        " voxels along an axis; use the method Slice for blocks of this size");
    }
    if (!this->BlockVoxels)
    {
      this->BlockVoxels = std::make_shared<HartleyBlockVoxels>(
        this->Layout.GetNumberOfBlocks(), this->Options.CacheBytes);
    }
    this->Painter = std::make_unique<HartleyStencil>(lattice, block, this->BlockVoxels);
  }
  else
  {
    this->UseSpectra(HartleySlice::MakePlan(block, lattice, this->Options.Padding));
    this->Painter = std::make_unique<HartleySlice>(lattice, this->Spectra);
  }
}

//------------------------------------------------------------------------------
const std::vector<float>& HartleyProjector::Internals::GetUnit(const Triple& filled)
{
  auto& unit = this->Units[filled];
  if (unit.empty())
  {
    const auto image = this->Painter->PaintUnit(filled);
    const auto& points = this->Lattice->Points;
    const std::size_t stride = HartleySlab::RoundUp(points[0]);
    unit.resize(stride * points[1]);
    for (std::size_t row = 0; row < points[1]; ++row)
    {
      std::copy_n(image.data() + row * points[0], points[0], unit.data() + row * stride);
    }
  }
  return unit;
}

//------------------------------------------------------------------------------
HartleyProjector::HartleyProjector(
  std::shared_ptr<const HartleySource> source, const HartleyOptions& options)
  : Data(std::make_unique<Internals>())
{
  Check(options);
  this->Data->Source = std::move(source);
  this->Data->Layout = this->Data->Source->GetLayout();
  this->Data->Options = options;
  this->Data->TermCounts.assign(this->Data->Layout.GetNumberOfBlocks(), Internals::Unknown);
  // Other methods than Basis keep spectra or voxels instead of coefficients.
  this->Data->Chunks.emplace(
    *this->Data->Source, this->Data->GetMethod() == HartleyMethod::Basis ? options.CacheBytes : 0);
}

//------------------------------------------------------------------------------
HartleyProjector::~HartleyProjector() = default;

//------------------------------------------------------------------------------
/** One call of HartleyProjector::Draw, slab by slab from front to back. */
class HartleyProjector::Drawing
{
public:
  Drawing(Internals& data, const HartleyView& view, const HartleyShading& shading)
    : Data(data)
    , Lattice(*data.Lattice)
    , View(view)
    , Lookup(shading, data.Source->GetBase(), data.Source->GetRange())
    , IsXRay(shading.OpacityModel == HartleyOpacityModel::XRay)
    , Box(GetBox(*data.Lattice, view))
  {
    const Triple blocks = data.Layout.GetBlocks();
    const double direction = this->Lattice.Backwards ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Counts[i] = blocks[static_cast<std::size_t>(this->Lattice.Axes[i])];
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      this->Descending[i] = direction * this->Lattice.Shear[i] < 0;
    }
    this->Image.Width = view.Width;
    this->Image.Height = view.Height;
    this->Image.Method = data.GetMethod();
    const std::size_t planes = this->Lookup.GetOpacity().Planes;
    const std::size_t plane = std::size_t{ view.Width } * view.Height;
    this->Pixels.assign(planes * plane, 0);
    if (!this->IsXRay)
    {
      std::fill_n(this->Pixels.end() - static_cast<std::ptrdiff_t>(plane), plane, 1.0f);
    }
  }

  std::uint32_t GetNumberOfSlabs() const { return this->Counts[2]; }

  /** Returns false if slabs behind this one are not visible. */
  bool DrawSlab(std::uint32_t step)
  {
    const std::uint32_t along = this->Lattice.Backwards ? this->Counts[2] - 1 - step : step;
    const double middle = along * this->Lattice.Block[2] + (this->Lattice.Block[2] - 1) / 2;
    std::array<std::uint32_t, 2> first, end;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const auto seen =
        FindBlocks(this->Lattice, i, this->Counts[i], middle, this->Box[i][0], this->Box[i][1]);
      first[i] = seen[0];
      end[i] = seen[1];
    }
    if (first[0] >= end[0] || first[1] >= end[1])
    {
      return true;
    }
    this->Slab.Start(this->Lattice, first, end, middle, this->Lookup.GetOpacity().Planes);
    this->ListPlaces(first, end, along);
    this->LoadTerms();
    const std::size_t width = end[0] - first[0];
    const std::size_t rowsAtOnce = std::max<std::size_t>(
      1, BatchBytes / (this->Lattice.GetNumberOfPoints() * sizeof(float) * width));
    for (std::size_t from = 0; from < this->Places.size(); from += rowsAtOnce * width)
    {
      const std::size_t count = std::min(this->Places.size() - from, rowsAtOnce * width);
      this->DrawBatch(std::span(this->Places).subspan(from, count));
    }
    return this->Slab.AddTo(this->Lattice, this->View, this->Lookup.GetOpacity(), this->Pixels) ||
      this->IsXRay;
  }

  HartleyImage Finish(const HartleyShading& shading)
  {
    const std::size_t plane = std::size_t{ this->Image.Width } * this->Image.Height;
    const float* const first = this->Pixels.data();
    if (this->IsXRay)
    {
      this->Image.Sums.assign(first, first + plane);
      this->Image.Samples.assign(first + plane, first + 2 * plane);
      FinishHartleyXRay(shading, this->Data.Source->GetBase(), this->Image);
      return std::move(this->Image);
    }
    const std::size_t colors = this->Lookup.GetOpacity().Planes - 1;
    const std::size_t green = colors > 1 ? plane : 0;
    this->Image.Colors.resize(plane);
    for (std::size_t i = 0; i < plane; ++i)
    {
      this->Image.Colors[i] = { first[i], first[green + i], first[2 * green + i],
        1 - first[colors * plane + i] };
    }
    return std::move(this->Image);
  }

private:
  /** The visible blocks of a slab, in an order in which no block is behind a later one. */
  void ListPlaces(const std::array<std::uint32_t, 2>& first,
    const std::array<std::uint32_t, 2>& end, std::uint32_t along)
  {
    this->Places.clear();
    for (std::uint32_t row = 0; row < end[1] - first[1]; ++row)
    {
      const std::uint32_t down = this->Descending[1] ? end[1] - 1 - row : first[1] + row;
      for (std::uint32_t column = 0; column < end[0] - first[0]; ++column)
      {
        const std::uint32_t across = this->Descending[0] ? end[0] - 1 - column : first[0] + column;
        this->Places.push_back(this->Data.ToPlace(across, down, along));
      }
    }
  }

  /** Loads the chunks of the listed blocks, except those of which all blocks are known to be empty
   * or to have what they need in memory. */
  void LoadTerms()
  {
    this->Wanted.clear();
    std::copy_if(this->Places.begin(), this->Places.end(), std::back_inserter(this->Wanted),
      [&](const Triple& place) { return this->Data.NeedsTerms(place); });
    this->Data.Chunks->Load(this->Wanted);
    for (const Triple& place : this->Wanted)
    {
      this->Data.TermCounts[this->Data.Layout.GetBlockNumber(place)] =
        static_cast<std::uint32_t>(this->Data.Chunks->GetTerms(place).size());
    }
  }

  /** Projects blocks whose chunks are loaded and adds them to the slab. */
  void DrawBatch(std::span<const Triple> places)
  {
    const std::size_t points = this->Lattice.GetNumberOfPoints();
    this->Parts.clear();
    this->Tasks.clear();
    this->Images.resize(std::max(this->Images.size(), places.size() * points + HartleySlab::Lanes));
    for (const Triple& place : places)
    {
      const std::size_t block = this->Data.Layout.GetBlockNumber(place);
      const std::size_t count = this->Data.TermCounts[block];
      if (count == 0 && this->Lookup.IsBaseClear() && !this->IsXRay)
      {
        continue;
      }
      HartleySlab::Part part;
      part.Place = { place[static_cast<std::size_t>(this->Lattice.Axes[0])],
        place[static_cast<std::size_t>(this->Lattice.Axes[1])] };
      part.Unit = this->Data.GetUnit(this->Data.Layout.GetFilled(place)).data();
      if (count > 0)
      {
        float* const image = this->Images.data() + this->Tasks.size() * points;
        part.Image = image;
        this->Tasks.push_back({ block, {}, image });
        if (this->Data.NeedsTerms(place))
        {
          this->Tasks.back().Terms = this->Data.Chunks->GetTerms(place);
        }
        this->Image.Terms += count;
      }
      this->Parts.push_back(part);
    }
    this->Image.Blocks += this->Parts.size();
    Paint(*this->Data.Painter, this->Tasks);
    this->Slab.Add(this->Lattice, this->Lookup.GetOpacity(), this->Parts);
  }

  Internals& Data;
  const HartleyLattice& Lattice;
  const HartleyView& View;
  HartleyLookup Lookup;
  bool IsXRay;
  std::array<std::array<double, 2>, 2> Box; // of all pixels, in sheared coordinates
  std::array<std::uint32_t, 3> Counts{};    // of blocks, along the lattice's axes
  std::array<bool, 2> Descending{};         // whether rays meet blocks of high indices first
  HartleyImage Image;
  std::vector<float> Pixels; // planes of the opacity model

  // Reused from slab to slab.
  HartleySlab Slab;
  std::vector<float> Images;
  std::vector<Triple> Places;
  std::vector<Triple> Wanted; // places whose terms are loaded
  std::vector<HartleySlab::Part> Parts;
  std::vector<HartleyPainter::Task> Tasks;
};

//------------------------------------------------------------------------------
HartleyImage HartleyProjector::Draw(const HartleyView& view, const HartleyShading& shading,
  const std::function<bool(double)>& progress)
{
  Check(view);
  Check(shading);
  const auto report = [&](double fraction)
  {
    if (progress && !progress(fraction))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  };
  if (shading.OpacityModel == HartleyOpacityModel::XRay)
  {
    // An estimate of the spectrum's share of the work.
    constexpr double making = 0.9;
    report(0);
    const auto& options = this->Data->Options;
    if (options.Method == HartleyMethod::Automatic &&
      options.Kernel == HartleyKernel::KaiserBessel &&
      this->Data->XRays.Make(*this->Data->Source, options.CacheBytes,
        [&](double done) { return !progress || progress(making * done); }))
    {
      report(making);
      HartleyImage image = this->Data->XRays.Draw(view, shading);
      report(1);
      return image;
    }
  }
  // An estimate of the images of basis functions' share of the work.
  constexpr double preparing = 0.2;
  this->Data->Prepare(
    view, [&](double fraction) { return !progress || progress(preparing * fraction); });

  Drawing drawing(*this->Data, view, shading);
  const std::uint32_t slabs = drawing.GetNumberOfSlabs();
  for (std::uint32_t slab = 0; slab < slabs; ++slab)
  {
    report(preparing + (1 - preparing) * slab / slabs);
    if (!drawing.DrawSlab(slab))
    {
      break;
    }
  }
  HartleyImage image = drawing.Finish(shading);
  report(1);
  return image;
}

//------------------------------------------------------------------------------
HartleyProjector::BlockImage HartleyProjector::Internals::MakeBlockImage(
  HartleyPainter::Brush& brush, const HartleyView& view, const Triple& place,
  std::span<const HartleyTerm> terms) const
{
  const HartleyLattice& lattice = *this->Lattice;
  const auto* const paper = dynamic_cast<const HartleyPaperSlice*>(this->Painter.get());
  const std::size_t block = this->Layout.GetBlockNumber(place);
  BlockImage made;
  made.View.Step = view.Step;
  if (paper)
  {
    made.Width = made.Height = static_cast<unsigned>(paper->GetSize());
    made.View.ColumnStep = paper->GetAcross();
    made.View.RowStep = paper->GetDown();
    made.Sums = paper->PaintOwn(block, terms);
  }
  else
  {
    made.Width = static_cast<unsigned>(lattice.Points[0]);
    made.Height = static_cast<unsigned>(lattice.Points[1]);
    made.View.ColumnStep = made.View.RowStep = {};
    made.View.ColumnStep[static_cast<std::size_t>(lattice.Axes[0])] = HartleyLattice::Spacing;
    made.View.RowStep[static_cast<std::size_t>(lattice.Axes[1])] = HartleyLattice::Spacing;
    made.Sums.resize(lattice.GetNumberOfPoints());
    const HartleyPainter::Task task{ block, terms, made.Sums.data() };
    brush.Paint({ &task, 1 });
  }
  made.View.Width = made.Width;
  made.View.Height = made.Height;
  const glm::dvec3 size(this->Layout.Block[0], this->Layout.Block[1], this->Layout.Block[2]);
  const glm::dvec3 middle = glm::dvec3(place[0], place[1], place[2]) * size + (size - 1.0) / 2.0;
  made.View.Origin = ToArray(middle - ToVector(made.View.ColumnStep) * ((made.Width - 1) / 2.0) -
    ToVector(made.View.RowStep) * ((made.Height - 1) / 2.0));
  return made;
}

//------------------------------------------------------------------------------
std::vector<HartleyProjector::BlockImage> HartleyProjector::DrawBlocks(
  const HartleyView& view, std::size_t chunk)
{
  Check(view);
  auto& data = *this->Data;
  data.Prepare(view, {});
  const auto terms = data.Source->GetChunk(chunk);
  const auto brush = data.Painter->MakeBrush();
  std::vector<BlockImage> images;
  ForEachHartleyBlock(data.Layout, chunk,
    [&](std::size_t number, const Triple& place)
    { images.push_back(data.MakeBlockImage(*brush, view, place, terms->GetBlock(number))); });
  return images;
}
}
