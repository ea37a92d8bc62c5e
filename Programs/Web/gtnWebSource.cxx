// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnWebSource.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <system_error>
#include <thread>

namespace gtn
{
namespace
{
constexpr std::uint64_t WebBlock = 64 << 10;
constexpr std::uint64_t SmallGap = WebBlock; // to fetch rather than to make another request
constexpr std::size_t MostKept = 1024;       // blocks
constexpr std::size_t MostAtOnce = 128;      // in one request
constexpr std::size_t MostAhead = 32;        // what a request brings beyond what is needed
constexpr std::size_t Connections = 4;
}

//------------------------------------------------------------------------------
WebSource::WebSource(const std::string& address)
  : File(address, WebBlock)
{
  this->Keep(0, std::make_shared<const WebFile::Bytes>(this->File.GetFirst()));
}

//------------------------------------------------------------------------------
int WebSource::ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const
{
  const auto size = this->GetSize();
  const auto length = std::min<std::uint64_t>(bytes.size(), size - std::min(offset, size));
  if (length == 0)
  {
    return 0;
  }
  for (const auto& [number, block] : this->Obtain(this->FindBlocks({ { offset, length } }, 0)))
  {
    const auto begin = number * WebBlock;
    const auto from = std::max(begin, offset);
    const auto to = std::min(begin + block->size(), offset + length);
    if (from < to)
    {
      std::copy_n(block->begin() + static_cast<std::ptrdiff_t>(from - begin), to - from,
        bytes.begin() + static_cast<std::ptrdiff_t>(from - offset));
    }
  }
  bytes = bytes.subspan(static_cast<std::size_t>(length));
  return 0;
}

//------------------------------------------------------------------------------
void WebSource::Fetch(const std::vector<gatun::ByteRange>& ranges) const
{
  auto wanted = this->FindBlocks(ranges, SmallGap);
  std::uint64_t count = 0;
  for (const auto& run : wanted)
  {
    count += run.Length;
  }
  if (count > MostKept)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Planned = std::move(wanted);
    return;
  }
  this->Obtain(wanted);
}

//------------------------------------------------------------------------------
/** The blocks in which ranges are; ranges with at most a gap between them are joined. */
WebSource::Numbers WebSource::FindBlocks(
  const std::vector<gatun::ByteRange>& ranges, std::uint64_t gap) const
{
  Numbers numbers;
  for (const auto& range : gatun::JoinRanges(ranges, gap))
  {
    if (range.Offset >= this->GetSize())
    {
      break;
    }
    const auto last = std::min(range.Offset + range.Length, this->GetSize()) - 1;
    const auto first = range.Offset / WebBlock;
    numbers.push_back({ first, last / WebBlock + 1 - first });
  }
  return gatun::JoinRanges(std::move(numbers), 0);
}

//------------------------------------------------------------------------------
/** The blocks, those that have to be fetched included. */
WebSource::Blocks WebSource::Obtain(const Numbers& wanted) const
{
  Blocks found;
  std::map<std::uint64_t, std::shared_future<Block>> awaited;
  std::vector<Job> own;
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    for (const auto& run : wanted)
    {
      for (auto number = run.Offset; number < run.Offset + run.Length; ++number)
      {
        if (auto block = this->FindKept(number))
        {
          found[number] = std::move(block);
          continue;
        }
        if (this->Pending.count(number) == 0)
        {
          this->Claim(number, own);
        }
        awaited[number] = this->Pending.at(number);
      }
    }
    for (auto& job : own)
    {
      this->ReadAhead(job);
    }
  }
  this->Run(own);
  for (const auto& [number, result] : awaited)
  {
    found[number] = result.get();
  }
  return found;
}

//------------------------------------------------------------------------------
WebSource::Block WebSource::FindKept(std::uint64_t number) const
{
  const auto place = this->Places.find(number);
  if (place == this->Places.end())
  {
    return nullptr;
  }
  this->Kept.splice(this->Kept.begin(), this->Kept, place->second);
  return place->second->second;
}

//------------------------------------------------------------------------------
/** Adds a block to the jobs of this thread. Others wait for it. */
void WebSource::Claim(std::uint64_t number, std::vector<Job>& jobs) const
{
  if (jobs.empty() || FindEnd(jobs.back()) != number || jobs.back().Results.size() == MostAtOnce)
  {
    jobs.push_back({ number, {} });
  }
  auto& result = jobs.back().Results.emplace_back();
  this->Pending[number] = result.get_future().share();
}

//------------------------------------------------------------------------------
/** Adds blocks of the plan that follow a job. */
void WebSource::ReadAhead(Job& job) const
{
  const auto number = FindEnd(job);
  const auto after = std::upper_bound(this->Planned.begin(), this->Planned.end(), number,
    [](std::uint64_t value, const gatun::ByteRange& run) { return value < run.Offset; });
  if (after == this->Planned.begin())
  {
    return;
  }
  const auto& run = *std::prev(after);
  const auto end = std::min(run.Offset + run.Length, number + MostAhead);
  for (auto next = number; next < end; ++next)
  {
    if (this->Places.count(next) > 0 || this->Pending.count(next) > 0)
    {
      return;
    }
    auto& result = job.Results.emplace_back();
    this->Pending[next] = result.get_future().share();
  }
}

//------------------------------------------------------------------------------
/** Keeps a block in place of those that have not been used for the longest time. */
void WebSource::Keep(std::uint64_t number, const Block& block) const
{
  this->Kept.emplace_front(number, block);
  this->Places[number] = this->Kept.begin();
  if (this->Kept.size() > MostKept)
  {
    this->Places.erase(this->Kept.back().first);
    this->Kept.pop_back();
  }
}

//------------------------------------------------------------------------------
void WebSource::Run(std::vector<Job>& jobs) const
{
  std::atomic<std::size_t> next{ 0 };
  const auto work = [&]
  {
    for (auto i = next++; i < jobs.size(); i = next++)
    {
      this->Run(jobs[i]);
    }
  };
  std::vector<std::jthread> helpers;
  try
  {
    for (std::size_t i = 1; i < std::min(jobs.size(), Connections); ++i)
    {
      helpers.emplace_back(work);
    }
  }
  catch (const std::system_error&)
  {
    // There are fewer threads then.
  }
  work();
}

//------------------------------------------------------------------------------
/** Fetches blocks in a row. A failure is that of their futures. */
void WebSource::Run(Job& job) const noexcept
{
  std::vector<Block> blocks;
  std::exception_ptr failure;
  try
  {
    blocks = this->Request(job);
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  const std::lock_guard<std::mutex> lock(this->Guard);
  for (std::size_t i = 0; i < job.Results.size(); ++i)
  {
    this->Pending.erase(job.First + i);
    if (failure)
    {
      job.Results[i].set_exception(failure);
      continue;
    }
    this->Keep(job.First + i, blocks[i]);
    job.Results[i].set_value(std::move(blocks[i]));
  }
}

//------------------------------------------------------------------------------
std::vector<WebSource::Block> WebSource::Request(const Job& job) const
{
  const auto offset = job.First * WebBlock;
  const auto length = std::min(FindEnd(job) * WebBlock, this->GetSize()) - offset;
  const auto bytes = this->File.Get(offset, length);
  std::vector<Block> blocks;
  for (std::size_t begin = 0; begin < bytes.size(); begin += WebBlock)
  {
    const auto size = std::min<std::size_t>(WebBlock, bytes.size() - begin);
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
    blocks.push_back(
      std::make_shared<const WebFile::Bytes>(from, from + static_cast<std::ptrdiff_t>(size)));
  }
  return blocks;
}
}
