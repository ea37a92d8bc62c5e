// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnComplex.h"

#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace gtn
{
namespace
{

using Labels = std::array<Hash, 4>;

// The even permutations, three for each corner that comes first.
constexpr int EvenPermutations[12][4] = { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 },
  { 1, 0, 3, 2 }, { 1, 2, 0, 3 }, { 1, 3, 2, 0 }, { 2, 0, 1, 3 }, { 2, 1, 3, 0 }, { 2, 3, 0, 1 },
  { 3, 0, 2, 1 }, { 3, 1, 0, 2 }, { 3, 2, 1, 0 } };

Labels Permuted(const Labels& labels, int permutation)
{
  const int* p = EvenPermutations[permutation];
  return { labels[p[0]], labels[p[1]], labels[p[2]], labels[p[3]] };
}

// The smallest of the permutations from first to last - 1.
Labels Smallest(const Labels& labels, int first, int last)
{
  Labels best = Permuted(labels, first);
  for (int i = first + 1; i < last; ++i)
  {
    best = std::min(best, Permuted(labels, i));
  }
  return best;
}

Labels LabelsOf(const Tet& tet, const std::vector<Hash>& points)
{
  return { points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]] };
}

// The sets that points belong to.
class Sets
{
public:
  explicit Sets(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t(0));
  }

  std::size_t Find(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      this->Parent[i] = this->Parent[this->Parent[i]];
      i = this->Parent[i];
    }
    return i;
  }

  void Join(std::size_t i, std::size_t j) { this->Parent[this->Find(i)] = this->Find(j); }

private:
  std::vector<std::size_t> Parent;
};

// Which points have a label that another one has, too.
std::vector<bool> FindAmbiguous(const std::vector<Hash>& labels)
{
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&labels](std::size_t i, std::size_t j) { return labels[i] < labels[j]; });
  std::vector<bool> ambiguous(labels.size());
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (labels[order[i]] == labels[order[i - 1]])
    {
      ambiguous[order[i]] = true;
      ambiguous[order[i - 1]] = true;
    }
  }
  return ambiguous;
}

// Some tetrahedra with their points, numbered anew.
Complex Extract(const Complex& whole, const std::vector<std::size_t>& tets)
{
  Complex part;
  part.KeepCorners = whole.KeepCorners;
  std::unordered_map<std::int64_t, std::int64_t> numbers;
  for (const std::size_t i : tets)
  {
    Tet tet = whole.Tets[i];
    for (std::int64_t& corner : tet)
    {
      const auto [entry, isNew] =
        numbers.try_emplace(corner, static_cast<std::int64_t>(part.Points.size()));
      if (isNew)
      {
        part.Points.push_back(whole.Points[corner]);
      }
      corner = entry->second;
    }
    part.Tets.push_back(tet);
    part.Cells.push_back(whole.Cells[i]);
  }
  return part;
}

// The points of the smallest class with more than one, of those the one with the smallest label.
std::vector<std::size_t> SmallestClass(const std::vector<Hash>& labels)
{
  std::map<Hash, std::vector<std::size_t>> classes;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    classes[labels[i]].push_back(i);
  }
  std::vector<std::size_t> smallest;
  for (auto& [label, points] : classes)
  {
    if (points.size() > 1 && (smallest.empty() || points.size() < smallest.size()))
    {
      smallest = std::move(points);
    }
  }
  return smallest;
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::size_t CountDistinct(std::vector<Hash> labels)
{
  std::sort(labels.begin(), labels.end());
  return std::unique(labels.begin(), labels.end()) - labels.begin();
}

//------------------------------------------------------------------------------
std::vector<Hash> Complex::HashTets() const
{
  std::vector<Hash> hashes(this->Tets.size());
  constexpr std::size_t step = 8192;
  gatun::ParallelFor((hashes.size() + step - 1) / step,
    [&](std::size_t part)
    {
      const std::size_t end = std::min(hashes.size(), (part + 1) * step);
      for (std::size_t i = part * step; i < end; ++i)
      {
        const Labels labels = LabelsOf(this->Tets[i], this->Points);
        const Labels canonical = this->KeepCorners ? labels : Smallest(labels, 0, 12);
        hashes[i] = HashOf(canonical.data(), sizeof(canonical), this->Cells[i]);
      }
    });
  return hashes;
}

//------------------------------------------------------------------------------
void Complex::Refine()
{
  std::vector<Hash> sums(this->Points.size());
  for (std::size_t i = 0; i < this->Tets.size(); ++i)
  {
    const Labels labels = LabelsOf(this->Tets[i], this->Points);
    for (int corner = 0; corner < 4; ++corner)
    {
      Labels seen = labels;
      Hash place = this->Cells[i];
      if (this->KeepCorners)
      {
        place.High += corner;
      }
      else
      {
        seen = Smallest(labels, 3 * corner, 3 * corner + 3);
      }
      sums[this->Tets[i][corner]] += HashOf(seen.data(), sizeof(seen), place);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    this->Points[i] = HashOf(&sums[i], sizeof(Hash), this->Points[i]);
  }
}

//------------------------------------------------------------------------------
bool Complex::HashAmbiguousParts(std::size_t& budget, std::vector<Hash>& hashes) const
{
  const std::vector<bool> ambiguous = FindAmbiguous(this->Points);
  Sets sets(this->Points.size());
  const auto ambiguousCorner = [&](const Tet& tet)
  { return std::find_if(tet.begin(), tet.end(), [&](std::int64_t id) { return ambiguous[id]; }); };
  for (const Tet& tet : this->Tets)
  {
    const auto first = ambiguousCorner(tet);
    for (const std::int64_t id : tet)
    {
      if (ambiguous[id])
      {
        sets.Join(id, *first);
      }
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> parts;
  for (std::size_t i = 0; i < this->Tets.size(); ++i)
  {
    const auto corner = ambiguousCorner(this->Tets[i]);
    if (corner != this->Tets[i].end())
    {
      parts[sets.Find(*corner)].push_back(i);
    }
  }

  hashes.clear();
  for (const auto& [root, tets] : parts)
  {
    Hash hash;
    if (!Extract(*this, tets).HashCanonically(budget, hash))
    {
      return false;
    }
    hashes.push_back(hash);
  }
  std::sort(hashes.begin(), hashes.end());
  return true;
}

//------------------------------------------------------------------------------
bool Complex::HashCanonically(std::size_t& budget, Hash& hash) const
{
  if (budget < this->Tets.size())
  {
    return false;
  }
  budget -= this->Tets.size();
  const std::vector<std::size_t> alike = SmallestClass(this->Points);
  if (alike.empty())
  {
    std::vector<Hash> tets = this->HashTets();
    std::sort(tets.begin(), tets.end());
    hash = HashOf(tets.data(), tets.size() * sizeof(Hash));
    return true;
  }
  bool isFirst = true;
  for (const std::size_t point : alike)
  {
    Complex marked = *this;
    marked.Points[point] = HashOf("marked", 6, marked.Points[point]);
    // Each round of refining visits all tetrahedra; there are as many as new classes at most.
    for (std::size_t classes = CountDistinct(marked.Points); classes < marked.Points.size();)
    {
      if (budget < this->Tets.size())
      {
        return false;
      }
      budget -= this->Tets.size();
      marked.Refine();
      const std::size_t now = CountDistinct(marked.Points);
      if (now == classes)
      {
        break;
      }
      classes = now;
    }
    Hash outcome;
    if (!marked.HashCanonically(budget, outcome))
    {
      return false;
    }
    hash = isFirst ? outcome : std::min(hash, outcome);
    isFirst = false;
  }
  return true;
}
}
