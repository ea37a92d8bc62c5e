// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnXMLFaces.h"

#include <algorithm>
#include <utility>

namespace gtn
{
namespace
{
class StreamFaces : public XMLFaces
{
public:
  StreamFaces(std::unique_ptr<XMLArray> faces, std::unique_ptr<XMLArray> ends, Fail fail)
    : Faces(std::move(faces))
    , FaceEnds(std::move(ends))
    , FailFor(std::move(fail))
  {
  }

  std::uint64_t GetSize() const override { return this->Faces->GetSize(); }

  void Read(std::uint64_t begin, std::size_t count, std::vector<std::int64_t>& values,
    std::vector<std::size_t>& ends) override
  {
    // Only the end of each cell is known.
    if (begin == 0)
    {
      this->NextCell = 0;
      this->End = 0;
    }
    if (begin != this->NextCell)
    {
      this->FailFor(begin);
    }
    std::vector<std::int64_t> stored;
    this->FaceEnds->ReadAs(begin, count, stored);
    const std::int64_t first = this->End;
    ends.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      // Cells without faces have -1.
      if (stored[i] >= 0 &&
        (stored[i] < this->End || static_cast<std::uint64_t>(stored[i]) > this->Faces->GetSize()))
      {
        this->FailFor(begin + i);
      }
      this->End = std::max(this->End, stored[i]);
      ends[i] = static_cast<std::size_t>(this->End - first);
    }
    this->Faces->ReadAs(
      static_cast<std::uint64_t>(first), static_cast<std::size_t>(this->End - first), values);
    this->NextCell = begin + count;
  }

private:
  const std::unique_ptr<XMLArray> Faces;
  const std::unique_ptr<XMLArray> FaceEnds;
  const Fail FailFor;

  // The cell behind those that were read last, and where their faces end.
  std::uint64_t NextCell = 0;
  std::int64_t End = 0;
};

/** Reads values together with the ends of the values before them: range[0] is where the first one
 * begins. */
void ReadEnds(
  XMLArray& ends, std::uint64_t begin, std::size_t count, std::vector<std::int64_t>& range)
{
  if (begin > 0)
  {
    ends.ReadAs(begin - 1, count + 1, range);
    return;
  }
  ends.ReadAs(0, count, range);
  range.insert(range.begin(), 0);
}

bool AreEnds(const std::vector<std::int64_t>& range, std::uint64_t most)
{
  return range.front() >= 0 && std::is_sorted(range.begin(), range.end()) &&
    static_cast<std::uint64_t>(range.back()) <= most;
}

class ListFaces : public XMLFaces
{
public:
  ListFaces(Lists lists, Fail fail)
    : Arrays(std::move(lists))
    , FailFor(std::move(fail))
  {
  }

  // A face is in two cells.
  std::uint64_t GetSize() const override
  {
    return this->Arrays.Faces->GetSize() + 2 * this->Arrays.Points->GetSize();
  }

  void Read(std::uint64_t begin, std::size_t count, std::vector<std::int64_t>& values,
    std::vector<std::size_t>& ends) override
  {
    std::vector<std::int64_t> range;
    ReadEnds(*this->Arrays.FaceEnds, begin, count, range);
    if (!AreEnds(range, this->Arrays.Faces->GetSize()))
    {
      this->FailFor(begin);
    }
    std::vector<std::int64_t> faces;
    this->Arrays.Faces->ReadAs(static_cast<std::uint64_t>(range.front()),
      static_cast<std::size_t>(range.back() - range.front()), faces);
    this->ReadFaces(begin, faces);
    if (begin == 0)
    {
      this->Given = 0;
    }
    values.clear();
    ends.resize(count);
    auto face = faces.begin();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::int64_t number = range[i + 1] - range[i];
      if (number > 0)
      {
        values.push_back(number);
        std::for_each(
          face, face + number, [&](std::int64_t id) { this->Append(begin + i, id, values); });
        face += number;
      }
      ends[i] = values.size();
    }
    this->Given += values.size();
  }

private:
  /** Reads all of these faces, those that are near each other together. */
  void ReadFaces(std::uint64_t cell, std::vector<std::int64_t> faces)
  {
    constexpr std::int64_t near = 1024;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (!faces.empty() &&
      (faces.front() < 0 ||
        static_cast<std::uint64_t>(faces.back()) >= this->Arrays.PointEnds->GetSize()))
    {
      this->FailFor(cell);
    }
    this->Runs.clear();
    for (auto from = faces.begin(); from != faces.end();)
    {
      auto to = from + 1;
      while (to != faces.end() && *to - to[-1] <= near)
      {
        ++to;
      }
      Run& run = this->Runs.emplace_back();
      run.First = *from;
      ReadEnds(*this->Arrays.PointEnds, static_cast<std::uint64_t>(*from),
        static_cast<std::size_t>(to[-1] - *from + 1), run.Ends);
      if (!AreEnds(run.Ends, this->Arrays.Points->GetSize()))
      {
        this->FailFor(cell);
      }
      this->Arrays.Points->ReadAs(static_cast<std::uint64_t>(run.Ends.front()),
        static_cast<std::size_t>(run.Ends.back() - run.Ends.front()), run.Points);
      from = to;
    }
  }

  /** Appends the number of points of a face and the points. */
  void Append(std::uint64_t cell, std::int64_t face, std::vector<std::int64_t>& values)
  {
    const auto run = std::upper_bound(this->Runs.begin(), this->Runs.end(), face,
                       [](std::int64_t id, const Run& other) { return id < other.First; }) -
      1;
    const auto at = static_cast<std::size_t>(face - run->First);
    const std::int64_t before = run->Ends.front();
    values.push_back(run->Ends[at + 1] - run->Ends[at]);
    values.insert(values.end(), run->Points.begin() + (run->Ends[at] - before),
      run->Points.begin() + (run->Ends[at + 1] - before));
    // Few values of a file must not become many.
    constexpr std::uint64_t mostTimes = 16;
    if (this->Given + values.size() > mostTimes * this->GetSize())
    {
      this->FailFor(cell);
    }
  }

  /** Consecutive faces. */
  struct Run
  {
    std::int64_t First = 0;
    std::vector<std::int64_t> Ends; // where the first one begins, and where each ends
    std::vector<std::int64_t> Points;
  };

  const Lists Arrays;
  const Fail FailFor;
  std::vector<Run> Runs;
  std::uint64_t Given = 0; // values since the first cell
};
}

//------------------------------------------------------------------------------
std::unique_ptr<XMLFaces> XMLFaces::FromStream(
  std::unique_ptr<XMLArray> faces, std::unique_ptr<XMLArray> ends, Fail fail)
{
  return std::make_unique<StreamFaces>(std::move(faces), std::move(ends), std::move(fail));
}

//------------------------------------------------------------------------------
std::unique_ptr<XMLFaces> XMLFaces::FromLists(Lists lists, Fail fail)
{
  return std::make_unique<ListFaces>(std::move(lists), std::move(fail));
}
}
