// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchDeviation.h"

#include "benchHarness.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace bench
{
namespace
{
using Vec = std::array<double, 3>;
using Tet = std::array<vtkIdType, 4>;

Vec Minus(const Vec& a, const Vec& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vec Cross(const Vec& a, const Vec& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Vec& a, const Vec& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Six times the volume. */
double Determinant(const std::array<Vec, 4>& p)
{
  return Dot(Minus(p[1], p[0]), Cross(Minus(p[2], p[0]), Minus(p[3], p[0])));
}

Tet GetTet(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  grid->GetCellPoints(cell, count, ids);
  if (count != 4)
  {
    throw Failure("not all cells are tetrahedra");
  }
  return { ids[0], ids[1], ids[2], ids[3] };
}

std::array<Vec, 4> GetCorners(vtkUnstructuredGrid* grid, const Tet& tet)
{
  std::array<Vec, 4> corners;
  for (std::size_t i = 0; i < 4; ++i)
  {
    grid->GetPoint(tet[i], corners[i].data());
  }
  return corners;
}

double Uniform(std::mt19937_64& random)
{
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/** Weights of N corners, evenly over the simplex. */
template <std::size_t N>
std::array<double, N> MakeWeights(std::mt19937_64& random)
{
  std::array<double, N> weights;
  double sum = 0;
  for (double& weight : weights)
  {
    weight = -std::log(1 - Uniform(random));
    sum += weight;
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

template <std::size_t N>
Vec Mix(const std::array<Vec, N>& corners, const std::array<double, N>& weights)
{
  Vec place{};
  for (std::size_t i = 0; i < N; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      place[c] += weights[i] * corners[i][c];
    }
  }
  return place;
}

/** So many of what has sizes, in proportion to them: called with the places, in order. */
template <typename Use>
void Choose(const std::vector<double>& sizes, std::size_t count, std::mt19937_64& random, Use&& use)
{
  const double all = std::accumulate(sizes.begin(), sizes.end(), 0.0);
  double sum = 0;
  std::size_t done = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    sum += sizes[i];
    // One in each of so many equal parts.
    const double end = sum / all * static_cast<double>(count);
    while (done < count && (static_cast<double>(done) + 0.5 < end))
    {
      use(i, random);
      ++done;
    }
  }
}

/** Faces that only one tetrahedron has, with the grid's points and arrays. */
vtkSmartPointer<vtkPolyData> MakeBoundary(vtkUnstructuredGrid* grid)
{
  std::vector<std::array<vtkIdType, 3>> faces;
  faces.reserve(4 * static_cast<std::size_t>(grid->GetNumberOfCells()));
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    Tet tet = GetTet(grid, cell);
    std::sort(tet.begin(), tet.end());
    for (std::size_t side = 0; side < 4; ++side)
    {
      auto& face = faces.emplace_back();
      std::copy_if(
        tet.begin(), tet.end(), face.begin(), [&](vtkIdType id) { return id != tet[side]; });
    }
  }
  std::sort(faces.begin(), faces.end());
  vtkNew<vtkCellArray> triangles;
  for (std::size_t i = 0; i < faces.size();)
  {
    auto next = i + 1;
    while (next < faces.size() && faces[next] == faces[i])
    {
      ++next;
    }
    if (next == i + 1)
    {
      triangles->InsertNextCell(3, faces[i].data());
    }
    i = next;
  }
  auto boundary = vtkSmartPointer<vtkPolyData>::New();
  boundary->SetPoints(grid->GetPoints());
  boundary->SetPolys(triangles);
  boundary->GetPointData()->ShallowCopy(grid->GetPointData());
  return boundary;
}

vtkDataArray* GetArray(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* const array = grid->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw Failure("there is no point array " + name);
  }
  return array;
}

/** Samples in boxes, so that those near a tetrahedron are found. */
class Bins
{
public:
  explicit Bins(const std::vector<Vec>& places)
    : Places(places)
    , Order(places.size())
  {
    this->Low.fill(std::numeric_limits<double>::max());
    Vec high;
    high.fill(std::numeric_limits<double>::lowest());
    for (const Vec& place : places)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        this->Low[c] = std::min(this->Low[c], place[c]);
        high[c] = std::max(high[c], place[c]);
      }
    }
    this->Number = std::max(1, static_cast<int>(std::cbrt(places.size() / 2.0)));
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double length = high[c] - this->Low[c];
      this->PerLength[c] = length > 0 ? this->Number / length : 0;
    }
    std::vector<std::size_t> bins(places.size());
    this->Firsts.assign(
      static_cast<std::size_t>(this->Number) * this->Number * this->Number + 1, 0);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      bins[i] = this->GetBin(
        this->GetPlace(places[i], 0), this->GetPlace(places[i], 1), this->GetPlace(places[i], 2));
      ++this->Firsts[bins[i] + 1];
    }
    std::partial_sum(this->Firsts.begin(), this->Firsts.end(), this->Firsts.begin());
    auto ends = this->Firsts;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      this->Order[ends[bins[i]]++] = i;
    }
  }

  /** All samples in the boxes that a box of two corners meets. */
  template <typename Use>
  void ForEach(const Vec& low, const Vec& high, Use&& use) const
  {
    std::array<int, 3> first;
    std::array<int, 3> last;
    for (std::size_t c = 0; c < 3; ++c)
    {
      first[c] = this->GetPlace(low, c);
      last[c] = this->GetPlace(high, c);
    }
    for (int k = first[2]; k <= last[2]; ++k)
    {
      for (int j = first[1]; j <= last[1]; ++j)
      {
        const auto row = this->GetBin(0, j, k);
        const auto end = this->Firsts[row + static_cast<std::size_t>(last[0]) + 1];
        for (auto i = this->Firsts[row + static_cast<std::size_t>(first[0])]; i < end; ++i)
        {
          use(this->Order[i]);
        }
      }
    }
  }

private:
  int GetPlace(const Vec& at, std::size_t c) const
  {
    const double place = (at[c] - this->Low[c]) * this->PerLength[c];
    return static_cast<int>(std::clamp(place, 0.0, this->Number - 1.0));
  }

  std::size_t GetBin(int i, int j, int k) const
  {
    const auto number = static_cast<std::size_t>(this->Number);
    return (static_cast<std::size_t>(k) * number + static_cast<std::size_t>(j)) * number +
      static_cast<std::size_t>(i);
  }

  const std::vector<Vec>& Places;
  std::vector<std::size_t> Order;
  std::vector<std::size_t> Firsts;
  Vec Low{};
  Vec PerLength{};
  int Number = 1;
};

/** The field of a grid at all places that are in it; of those in several tetrahedra, that of the
 * first. NaN elsewhere. */
std::vector<double> Probe(
  const std::vector<Vec>& places, vtkUnstructuredGrid* grid, vtkDataArray* array)
{
  std::vector<double> values(places.size(), std::nan(""));
  const Bins bins(places);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const Tet tet = GetTet(grid, cell);
    const auto p = GetCorners(grid, tet);
    const double whole = Determinant(p);
    if (whole == 0)
    {
      continue;
    }
    Vec low = p[0];
    Vec high = p[0];
    for (const Vec& corner : p)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], corner[c]);
        high[c] = std::max(high[c], corner[c]);
      }
    }
    bins.ForEach(low, high,
      [&](std::size_t i)
      {
        if (!std::isnan(values[i]))
        {
          return;
        }
        double value = 0;
        for (std::size_t corner = 0; corner < 4; ++corner)
        {
          auto moved = p;
          moved[corner] = places[i];
          const double weight = Determinant(moved) / whole;
          if (weight < -1e-9)
          {
            return;
          }
          value += weight * array->GetTuple1(tet[corner]);
        }
        values[i] = value;
      });
  }
  return values;
}

} // anonymous namespace

//------------------------------------------------------------------------------
Samples MakeSamples(vtkUnstructuredGrid* grid, const std::string& name, std::size_t count)
{
  vtkDataArray* const array = GetArray(grid, name);
  Samples samples;
  std::mt19937_64 random(29);
  std::vector<double> sizes(static_cast<std::size_t>(grid->GetNumberOfCells()));
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(i);
    sizes[i] = std::abs(Determinant(GetCorners(grid, GetTet(grid, cell))));
  }
  Choose(sizes, count, random,
    [&](std::size_t i, std::mt19937_64& numbers)
    {
      const Tet tet = GetTet(grid, static_cast<vtkIdType>(i));
      const auto weights = MakeWeights<4>(numbers);
      samples.Places.push_back(Mix(GetCorners(grid, tet), weights));
      double value = 0;
      for (std::size_t c = 0; c < 4; ++c)
      {
        value += weights[c] * array->GetTuple1(tet[c]);
      }
      samples.Values.push_back(value);
    });
  double range[2];
  array->GetRange(range);
  samples.Range = range[1] - range[0];
  samples.Diagonal = grid->GetLength();

  const auto boundary = MakeBoundary(grid);
  std::vector<std::array<Vec, 3>> triangles(static_cast<std::size_t>(boundary->GetNumberOfCells()));
  sizes.resize(triangles.size());
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    boundary->GetCellPoints(static_cast<vtkIdType>(i), corners, ids);
    for (std::size_t c = 0; c < 3; ++c)
    {
      boundary->GetPoint(ids[c], triangles[i][c].data());
    }
    const Vec normal =
      Cross(Minus(triangles[i][1], triangles[i][0]), Minus(triangles[i][2], triangles[i][0]));
    sizes[i] = std::sqrt(Dot(normal, normal));
  }
  Choose(sizes, count / 10, random,
    [&](std::size_t i, std::mt19937_64& numbers)
    { samples.OnBoundary.push_back(Mix(triangles[i], MakeWeights<3>(numbers))); });
  return samples;
}

//------------------------------------------------------------------------------
Deviation Compare(const Samples& samples, vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* const array = GetArray(grid, name);
  auto values = Probe(samples.Places, grid, array);
  const auto boundary = MakeBoundary(grid);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(boundary);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  const auto findNearest = [&](const Vec& place, double& value)
  {
    Vec nearest;
    vtkIdType id = -1;
    int sub = 0;
    double distance2 = 0;
    locator->FindClosestPoint(place.data(), nearest.data(), cell, id, sub, distance2);
    double weights[3];
    Vec within;
    double parameters[3];
    double ignored = 0;
    cell->EvaluatePosition(nearest.data(), within.data(), sub, parameters, ignored, weights);
    // Of a triangle that is almost a line, they may be anything.
    double sum = 0;
    for (double& weight : weights)
    {
      weight = std::isfinite(weight) ? std::clamp(weight, 0.0, 1.0) : 1.0;
      sum += weight;
    }
    value = 0;
    for (vtkIdType c = 0; c < 3; ++c)
    {
      value += weights[c] / sum * array->GetTuple1(cell->GetPointId(static_cast<int>(c)));
    }
    return std::sqrt(distance2);
  };

  Deviation deviation;
  double sum = 0;
  double sumInside = 0;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    bool isOutside = false;
    if (std::isnan(values[i]))
    {
      isOutside = findNearest(samples.Places[i], values[i]) > 1e-6 * samples.Diagonal;
    }
    const double error = std::abs(values[i] - samples.Values[i]) / samples.Range;
    sum += error * error;
    deviation.Largest = std::max(deviation.Largest, error);
    deviation.Outside += isOutside ? 1 : 0;
    sumInside += isOutside ? 0 : error * error;
    inside += isOutside ? 0 : 1;
  }
  deviation.Rms = std::sqrt(sum / static_cast<double>(values.size()));
  deviation.RmsInside =
    std::sqrt(sumInside / static_cast<double>(std::max<std::size_t>(1, inside)));
  for (const Vec& place : samples.OnBoundary)
  {
    double value = 0;
    const double distance = findNearest(place, value) / samples.Diagonal;
    deviation.BoundaryMean += distance / static_cast<double>(samples.OnBoundary.size());
    deviation.BoundaryLargest = std::max(deviation.BoundaryLargest, distance);
  }
  return deviation;
}

//------------------------------------------------------------------------------
Shapes LookAtShapes(vtkUnstructuredGrid* grid)
{
  Shapes shapes;
  std::vector<double> ratios;
  std::size_t positive = 0;
  std::size_t negative = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const auto p = GetCorners(grid, GetTet(grid, cell));
    const double volume = Determinant(p) / 6;
    shapes.Volume += std::abs(volume);
    positive += volume > 0 ? 1 : 0;
    negative += volume < 0 ? 1 : 0;
    double edges = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t j = i + 1; j < 4; ++j)
      {
        const Vec edge = Minus(p[i], p[j]);
        edges += Dot(edge, edge);
      }
    }
    ratios.push_back(edges > 0 ? 12 * std::cbrt(9 * volume * volume) / edges : 0);
  }
  std::sort(ratios.begin(), ratios.end());
  shapes.Worst = ratios.front();
  shapes.FirstPercentile = ratios[ratios.size() / 100];
  shapes.Median = ratios[ratios.size() / 2];
  shapes.Flat = ratios.size() - positive - negative;
  shapes.Inverted = std::min(positive, negative);
  return shapes;
}
}
