// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfacePreparer.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
SurfacePreparer::~SurfacePreparer()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->IsEnding = true;
    ++this->Version;
  }
  this->Changed.notify_all();
  if (this->Worker.joinable())
  {
    this->Worker.join();
  }
}

//------------------------------------------------------------------------------
void SurfacePreparer::Clear()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Level = nullptr;
  this->Wanted.clear();
  this->Ready.clear();
  ++this->Version;
}

//------------------------------------------------------------------------------
void SurfacePreparer::Prepare(
  const std::shared_ptr<const SurfaceMesh>& level, std::vector<std::uint32_t> chunks)
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (level != this->Level)
    {
      this->Level = level;
      this->Ready.clear();
      ++this->Version;
    }
    std::reverse(chunks.begin(), chunks.end());
    std::erase_if(chunks, [this](std::uint32_t chunk) { return this->Ready.contains(chunk); });
    this->Wanted = std::move(chunks);
    if (!this->Wanted.empty() && !this->Worker.joinable())
    {
      this->Worker = std::thread([this] { this->Run(); });
    }
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
std::optional<SurfacePart> SurfacePreparer::Take(const SurfaceMesh* level, std::uint32_t chunk)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const auto found = this->Ready.find(chunk);
  if (level != this->Level.get() || found == this->Ready.end())
  {
    return std::nullopt;
  }
  SurfacePart part = std::move(found->second);
  this->Ready.erase(found);
  return part;
}

//------------------------------------------------------------------------------
void SurfacePreparer::Wait()
{
  std::unique_lock<std::mutex> lock(this->Guard);
  this->Changed.wait(lock, [this] { return this->Wanted.empty() && !this->IsWorking; });
}

//------------------------------------------------------------------------------
void SurfacePreparer::Run()
{
  using Clock = std::chrono::steady_clock;
  std::unique_lock<std::mutex> lock(this->Guard);
  while (!this->IsEnding)
  {
    if (this->Wanted.empty())
    {
      this->Changed.wait(lock);
      continue;
    }
    const auto chunk = this->Wanted.back();
    this->Wanted.pop_back();
    auto level = this->Level;
    const auto version = this->Version;
    this->IsWorking = true;
    lock.unlock();
    const auto begin = Clock::now();
    SurfacePart part = level->Decode(chunk, false,
      [&](double)
      {
        const std::lock_guard<std::mutex> brief(this->Guard);
        return this->Version == version;
      });
    level.reset();
    const auto taken = Clock::now() - begin;
    lock.lock();
    this->IsWorking = false;
    this->Changed.notify_all();
    if (this->Version == version)
    {
      this->Ready[chunk] = std::move(part);
      this->Changed.wait_for(lock, taken, [&] { return this->Version != version; });
    }
  }
}
}
