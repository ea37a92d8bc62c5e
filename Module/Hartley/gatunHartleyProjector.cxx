// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyProjector.h"

#include "gatunError.h"
#include "gatunHartleyBasis.h"
#include "gatunHartleyChunks.h"
#include "gatunHartleyLookup.h"
#include "gatunHartleyPaperSlice.h"
#include "gatunHartleySlab.h"
#include "gatunHartleySlice.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace gatun
{
namespace
{
using Vector = HartleyView::Vector;
using Triple = HartleyLayout::Triple;

// Blocks of a slab whose pictures are kept at the same time take this many bytes at most, but for a
// row of them.
constexpr std::size_t BatchBytes = std::size_t{ 32 } << 20;

// The most that pictures of basis functions may take.
constexpr std::uint64_t MostBasisBytes = std::uint64_t{ 1 } << 30;

// The most voxels along an axis of blocks that are drawn by their basis functions unless told
// otherwise.
constexpr std::uint32_t LargestBasisBlock = 16;

//------------------------------------------------------------------------------
void Check(const HartleyView& view)
{
  if (view.Width == 0 || view.Height == 0)
  {
    ThrowInvalid("a picture without pixels");
  }
  const auto& a = view.ColumnStep;
  const auto& b = view.RowStep;
  const auto& c = view.Step;
  const double volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
  for (const Vector* const vector : { &view.Origin, &a, &b, &c })
  {
    if (!std::all_of(vector->begin(), vector->end(), [](double v) { return std::isfinite(v); }))
    {
      ThrowInvalid("a view with numbers that are not finite");
    }
  }
  if (!std::isfinite(volume) || volume == 0)
  {
    ThrowInvalid("a view whose columns, rows and rays do not span a space");
  }
}

//------------------------------------------------------------------------------
void Check(const HartleyShading& shading)
{
  if (shading.Law != HartleyLaw::XRay && shading.Table.size() < 2)
  {
    ThrowInvalid("a transfer function of less than two entries");
  }
  if (shading.Law == HartleyLaw::Exponential &&
    (!std::isfinite(shading.Extinction) || shading.Extinction < 0 || !std::isfinite(shading.Zero)))
  {
    ThrowInvalid("an exponential law whose extinction is negative or not finite");
  }
}

//------------------------------------------------------------------------------
void Check(const HartleyOptions& options)
{
  if (!(options.Padding >= 1 && options.Padding <= 8))
  {
    ThrowInvalid("a padding that is not from 1 to 8");
  }
}
}

//------------------------------------------------------------------------------
struct HartleyProjector::Internals
{
  std::shared_ptr<const HartleySource> Source;
  HartleyLayout Layout;
  HartleyOptions Options;

  // For one direction.
  std::optional<HartleyLattice> Lattice;
  HartleyView View; // of the painter
  std::unique_ptr<HartleyPainter> Painter;
  std::map<Triple, std::vector<float>> Units;

  std::shared_ptr<HartleySpectra> Spectra;
  std::optional<HartleyChunks> Chunks;

  HartleyMethod GetMethod() const;
  void Prepare(const HartleyView& view, const std::function<bool(double)>& progress);
  void UseSpectra(const SpectrumPlan& plan);
  const std::vector<float>& GetUnit(const Triple& filled);

  /** The place of a block that is given along the lattice's axes. */
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
    painter.MakeBrush()->Paint(tasks); // the brush has work for several threads
    return;
  }
  const std::size_t each = std::max<std::size_t>(1, tasks.size() / (threads * 8));
  ParallelFor((tasks.size() + each - 1) / each,
    [&](std::size_t i) {
      painter.MakeBrush()->Paint(tasks.subspan(i * each, std::min(each, tasks.size() - i * each)));
    });
}

//------------------------------------------------------------------------------
/** The blocks along an axis that may be seen between two sheared coordinates: first, end. */
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
/** The sheared coordinates of a picture's pixels: lowest and highest, across and down. */
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

//------------------------------------------------------------------------------
void FinishXRay(const HartleyShading& shading, double base, HartleyPicture& picture)
{
  const auto offset = static_cast<float>(base);
  picture.Sums.resize(picture.Colours.size());
  picture.Samples.resize(picture.Colours.size());
  float least = 0;
  float most = 0;
  bool any = false;
  for (std::size_t i = 0; i < picture.Colours.size(); ++i)
  {
    const auto& pixel = picture.Colours[i];
    const float samples = std::max(0.0f, pixel[1]);
    const float sum = pixel[0] + offset * samples;
    picture.Sums[i] = sum;
    picture.Samples[i] = samples;
    if (samples > 0)
    {
      least = any ? std::min(least, sum) : sum;
      most = any ? std::max(most, sum) : sum;
      any = true;
    }
  }
  const bool given = shading.Black != shading.White;
  const float black = given ? static_cast<float>(shading.Black) : least;
  const float white = given ? static_cast<float>(shading.White) : most;
  for (std::size_t i = 0; i < picture.Colours.size(); ++i)
  {
    const float opacity = std::min(1.0f, picture.Samples[i]);
    const float grey =
      white != black ? std::clamp((picture.Sums[i] - black) / (white - black), 0.0f, 1.0f) : 0.0f;
    picture.Colours[i] = { grey * opacity, grey * opacity, grey * opacity, opacity };
  }
}
}

//------------------------------------------------------------------------------
HartleyMethod HartleyProjector::Internals::GetMethod() const
{
  if (this->Options.Method != HartleyMethod::Automatic)
  {
    return this->Options.Method;
  }
  const auto& block = this->Layout.Block;
  return this->Options.Kernel == HartleyKernel::Trilinear ||
      *std::max_element(block.begin(), block.end()) > LargestBasisBlock
    ? HartleyMethod::Slice
    : HartleyMethod::Basis;
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
      ThrowInvalid("the basis functions of blocks of " + std::to_string(block[0]) + " x " +
        std::to_string(block[1]) + " x " + std::to_string(block[2]) + " voxels have pictures of " +
        std::to_string(bytes >> 20) + " MiB; draw blocks as large as this by slices");
    }
    this->Painter = std::make_unique<HartleyBasis>(block, lattice, progress);
  }
  else if (paper)
  {
    this->UseSpectra(HartleyPaperSlice::MakePlan(block, this->Options.Padding));
    this->Painter = std::make_unique<HartleyPaperSlice>(lattice, view, this->Spectra);
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
    unit = this->Painter->PaintUnit(filled);
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
  // Of slices, spectra are kept instead.
  this->Data->Chunks.emplace(
    *this->Data->Source, this->Data->GetMethod() == HartleyMethod::Basis ? options.CacheBytes : 0);
}

//------------------------------------------------------------------------------
HartleyProjector::~HartleyProjector() = default;

//------------------------------------------------------------------------------
HartleyPicture HartleyProjector::Draw(const HartleyView& view, const HartleyShading& shading,
  const std::function<bool(double)>& progress)
{
  Check(view);
  Check(shading);
  auto& data = *this->Data;
  const auto report = [&](double fraction)
  {
    if (progress && !progress(fraction))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  };
  // Pictures of basis functions are this part of the work, say.
  constexpr double preparing = 0.2;
  data.Prepare(view, [&](double fraction) { return !progress || progress(preparing * fraction); });

  const HartleyLattice& lattice = *data.Lattice;
  const HartleyLookup lookup(shading, data.Source->GetBase(), data.Source->GetRange());
  const Triple blocks = data.Layout.GetBlocks();
  std::array<std::uint32_t, 3> counts;
  for (std::size_t i = 0; i < 3; ++i)
  {
    counts[i] = blocks[static_cast<std::size_t>(lattice.Axes[i])];
  }
  const auto box = GetBox(lattice, view);
  const double direction = lattice.Backwards ? -1 : 1;
  const std::array<bool, 2> descending{ direction * lattice.Shear[0] < 0,
    direction * lattice.Shear[1] < 0 };

  HartleyPicture picture;
  picture.Width = view.Width;
  picture.Height = view.Height;
  picture.Method = data.GetMethod();
  const bool xray = shading.Law == HartleyLaw::XRay;
  picture.Colours.assign(std::size_t{ view.Width } * view.Height, { 0, 0, 0, xray ? 0.0f : 1.0f });

  HartleySlab slab;
  std::vector<float> pictures;
  std::vector<Triple> places;
  std::vector<HartleySlab::Part> parts;
  std::vector<HartleyPainter::Task> tasks;
  for (std::uint32_t step = 0; step < counts[2]; ++step)
  {
    report(preparing + (1 - preparing) * step / counts[2]);
    const std::uint32_t along = lattice.Backwards ? counts[2] - 1 - step : step;
    const double middle = along * lattice.Block[2] + (lattice.Block[2] - 1) / 2;
    std::array<std::uint32_t, 2> first, end;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const auto seen = FindBlocks(lattice, i, counts[i], middle, box[i][0], box[i][1]);
      first[i] = seen[0];
      end[i] = seen[1];
    }
    if (first[0] >= end[0] || first[1] >= end[1])
    {
      continue;
    }
    slab.Start(lattice, first, end, middle);

    const std::uint32_t width = end[0] - first[0];
    const std::uint32_t height = end[1] - first[1];
    places.clear();
    for (std::uint32_t row = 0; row < height; ++row)
    {
      for (std::uint32_t column = 0; column < width; ++column)
      {
        places.push_back(data.ToPlace(descending[0] ? end[0] - 1 - column : first[0] + column,
          descending[1] ? end[1] - 1 - row : first[1] + row, along));
      }
    }
    data.Chunks->Load(places);

    const std::size_t points = lattice.GetNumberOfPoints();
    const std::size_t rowsAtOnce =
      std::max<std::size_t>(1, BatchBytes / (points * sizeof(float) * width));
    for (std::size_t from = 0; from < places.size(); from += rowsAtOnce * width)
    {
      const std::size_t to = std::min(places.size(), from + rowsAtOnce * width);
      parts.clear();
      tasks.clear();
      pictures.resize(std::max(pictures.size(), (to - from) * points));
      for (const Triple& place : std::span(places).subspan(from, to - from))
      {
        const auto terms = data.Chunks->GetTerms(place);
        if (terms.empty() && lookup.IsBaseClear() && !xray)
        {
          continue;
        }
        HartleySlab::Part part;
        part.Place = { place[static_cast<std::size_t>(lattice.Axes[0])],
          place[static_cast<std::size_t>(lattice.Axes[1])] };
        part.Unit = data.GetUnit(data.Layout.GetFilled(place)).data();
        if (!terms.empty())
        {
          float* const room = pictures.data() + tasks.size() * points;
          part.Picture = room;
          tasks.push_back({ data.Layout.GetBlockNumber(place), terms, room });
          picture.Terms += terms.size();
        }
        parts.push_back(part);
      }
      picture.Blocks += parts.size();
      Paint(*data.Painter, tasks);
      slab.Add(lattice, lookup, parts);
    }
    if (!slab.AddTo(lattice, view, lookup, picture.Colours) && !xray)
    {
      break;
    }
  }

  if (xray)
  {
    FinishXRay(shading, data.Source->GetBase(), picture);
  }
  else
  {
    for (auto& pixel : picture.Colours)
    {
      pixel[3] = 1 - pixel[3];
    }
  }
  report(1);
  return picture;
}

//------------------------------------------------------------------------------
std::vector<HartleyProjector::BlockPicture> HartleyProjector::DrawBlocks(
  const HartleyView& view, std::size_t chunk)
{
  Check(view);
  auto& data = *this->Data;
  data.Prepare(view, {});
  const HartleyLattice& lattice = *data.Lattice;
  const auto* const paper = dynamic_cast<const HartleyPaperSlice*>(data.Painter.get());
  const auto terms = data.Source->GetChunk(chunk);
  const auto box = data.Layout.GetBlocksOfChunk(chunk);

  std::vector<BlockPicture> pictures;
  const auto brush = data.Painter->MakeBrush();
  std::size_t number = 0;
  for (std::uint32_t z = box.First[2]; z < box.End[2]; ++z)
  {
    for (std::uint32_t y = box.First[1]; y < box.End[1]; ++y)
    {
      for (std::uint32_t x = box.First[0]; x < box.End[0]; ++x, ++number)
      {
        const Triple place{ x, y, z };
        const std::size_t block = data.Layout.GetBlockNumber(place);
        BlockPicture made;
        Vector middle;
        for (std::size_t i = 0; i < 3; ++i)
        {
          middle[i] = place[i] * static_cast<double>(data.Layout.Block[i]) +
            (static_cast<double>(data.Layout.Block[i]) - 1) / 2;
        }
        made.View.Step = view.Step;
        made.View.Origin = middle;
        if (paper)
        {
          made.Width = made.Height = static_cast<unsigned>(paper->GetSize());
          made.View.ColumnStep = paper->GetAcross();
          made.View.RowStep = paper->GetDown();
          made.Sums = paper->PaintOwn(block, terms->GetBlock(number));
        }
        else
        {
          made.Width = static_cast<unsigned>(lattice.Points[0]);
          made.Height = static_cast<unsigned>(lattice.Points[1]);
          made.View.ColumnStep = made.View.RowStep = {};
          made.View.ColumnStep[static_cast<std::size_t>(lattice.Axes[0])] = HartleyLattice::Spacing;
          made.View.RowStep[static_cast<std::size_t>(lattice.Axes[1])] = HartleyLattice::Spacing;
          made.Sums.resize(lattice.GetNumberOfPoints());
          const HartleyPainter::Task task{ block, terms->GetBlock(number), made.Sums.data() };
          brush->Paint({ &task, 1 });
        }
        made.View.Width = made.Width;
        made.View.Height = made.Height;
        for (std::size_t i = 0; i < 3; ++i)
        {
          made.View.Origin[i] -= (made.Width - 1) / 2.0 * made.View.ColumnStep[i] +
            (made.Height - 1) / 2.0 * made.View.RowStep[i];
        }
        pictures.push_back(std::move(made));
      }
    }
  }
  return pictures;
}
}
