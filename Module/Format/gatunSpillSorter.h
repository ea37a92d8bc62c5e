// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSpillSorter_h
#define gatunSpillSorter_h

#include "gatunAtomicFile.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace gatun
{
/**
 * Sorts records in bounded memory. Sorted runs that do not fit are in one file without a name,
 * which the system removes when it is closed, also if the process is killed.
 *
 * Records are trivially copyable and are compared by operator<. Methods throw Error(CannotWrite).
 */
template <typename Record>
class SpillSorter
{
  static_assert(std::is_trivially_copyable_v<Record>);

public:
  /** memory: about the number of bytes to take. */
  SpillSorter(std::string folder, std::size_t memory)
    : Folder(std::move(folder))
    , Most(std::max<std::size_t>(memory / sizeof(Record), LeastRecords))
  {
  }

  void Add(const Record& record)
  {
    if (this->Records.size() == this->Most)
    {
      this->Spill();
    }
    if (this->Records.size() == this->Records.capacity())
    {
      this->Records.reserve(
        std::clamp<std::size_t>(2 * this->Records.size(), LeastRecords, this->Most));
    }
    this->Records.push_back(record);
  }

  /** To be called once behind the last record. */
  void Sort()
  {
    if (!this->Spilled)
    {
      std::sort(this->Records.begin(), this->Records.end());
      this->Runs.push_back({ 0, 0, std::move(this->Records), 0 });
    }
    else
    {
      this->Spill();
      this->Records = {};
    }
    this->Records.shrink_to_fit();
    for (std::size_t r = 0; r < this->Runs.size(); ++r)
    {
      if (this->Fill(this->Runs[r]))
      {
        this->Heap.push_back(r);
      }
    }
    std::make_heap(this->Heap.begin(), this->Heap.end(), Later{ *this });
  }

  /** The next record in order, or null behind the last one. Valid until the next call of Next. */
  const Record* Get() const
  {
    return this->Heap.empty() ? nullptr : &this->Runs[this->Heap.front()].Get();
  }

  void Next()
  {
    std::pop_heap(this->Heap.begin(), this->Heap.end(), Later{ *this });
    Run& run = this->Runs[this->Heap.back()];
    ++run.At;
    if (run.At < run.Records.size() || this->Fill(run))
    {
      std::push_heap(this->Heap.begin(), this->Heap.end(), Later{ *this });
    }
    else
    {
      this->Heap.pop_back();
      std::vector<Record>().swap(run.Records);
    }
  }

  /** The number of bytes in the file. */
  std::uint64_t GetSpilledBytes() const
  {
    return this->Spilled ? this->Spilled->File.GetSize() : 0;
  }

private:
  static constexpr std::size_t LeastRecords = 64;

  /** Sorted records, of which a part is in memory. */
  struct Run
  {
    std::uint64_t Begin = 0; // of the rest in the file
    std::uint64_t End = 0;
    std::vector<Record> Records;
    std::size_t At = 0;

    const Record& Get() const { return this->Records[this->At]; }
  };

  struct Later
  {
    const SpillSorter& Sorter;
    bool operator()(std::size_t l, std::size_t r) const
    {
      const Record& left = this->Sorter.Runs[l].Get();
      const Record& right = this->Sorter.Runs[r].Get();
      return right < left || (!(left < right) && r < l);
    }
  };

  void Spill()
  {
    if (this->Records.empty())
    {
      return;
    }
    if (!this->Spilled)
    {
      this->Spilled.emplace(this->Folder);
    }
    std::sort(this->Records.begin(), this->Records.end());
    const auto begin = this->Spilled->File.GetSize();
    this->Spilled->File.Write({ reinterpret_cast<const std::uint8_t*>(this->Records.data()),
      this->Records.size() * sizeof(Record) });
    this->Runs.push_back({ begin, this->Spilled->File.GetSize(), {}, 0 });
    this->Records.clear();
  }

  /** Reads the next records of a run. Returns whether there are any. */
  bool Fill(Run& run)
  {
    if (run.Begin < run.End)
    {
      const auto most = std::max(this->Most / this->Runs.size(), LeastRecords);
      const auto left = static_cast<std::size_t>(run.End - run.Begin) / sizeof(Record);
      run.Records.resize(std::min(most, left));
      run.At = 0;
      const auto size = run.Records.size() * sizeof(Record);
      this->Spilled->File.ReadAt(
        run.Begin, { reinterpret_cast<std::uint8_t*>(run.Records.data()), size });
      run.Begin += size;
    }
    else if (run.At > 0)
    {
      run.Records = {};
      run.At = 0;
    }
    return run.At < run.Records.size();
  }

  /** A file that can be made in place. */
  struct Scratch
  {
    explicit Scratch(const std::string& folder)
      : File(AtomicFile::MakeScratch(folder))
    {
    }

    AtomicFile File;
  };

  const std::string Folder;
  const std::size_t Most; // records in memory
  std::optional<Scratch> Spilled;
  std::vector<Record> Records;
  std::vector<Run> Runs;
  std::vector<std::size_t> Heap; // of the runs with records
};
}

#endif
