// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfacePreparer.h"

#include "vtkPolyData.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
void SurfacePreparer::Clear()
{
  this->Worker.Stop();
  this->Level = nullptr;
  const auto lock = this->Worker.Lock();
  this->Ready.clear();
}

//------------------------------------------------------------------------------
void SurfacePreparer::Prepare(
  const std::shared_ptr<const SurfaceLevel>& level, std::vector<std::uint32_t> chunks)
{
  if (level != this->Level)
  {
    this->Clear();
    this->Level = level;
  }
  if (chunks.empty())
  {
    this->Worker.Request({});
    return;
  }
  this->Worker.Request(
    [this, level, chunks = std::move(chunks)]
    {
      const auto isReady = [&](std::uint32_t chunk)
      {
        const auto lock = this->Worker.Lock();
        return this->Ready.contains(chunk);
      };
      for (const auto chunk : chunks)
      {
        if (this->Worker.IsReplaced())
        {
          return;
        }
        if (!isReady(chunk))
        {
          SurfacePart part =
            level->Decode(chunk, false, [this](double) { return !this->Worker.MustStop(); });
          this->Worker.Publish([&] { this->Ready[chunk] = std::move(part); });
          this->Worker.GoOn();
        }
      }
    });
}

//------------------------------------------------------------------------------
std::optional<SurfacePart> SurfacePreparer::Take(const SurfaceLevel* level, std::uint32_t chunk)
{
  const auto lock = this->Worker.Lock();
  const auto found = this->Ready.find(chunk);
  if (level != this->Level.get() || found == this->Ready.end())
  {
    return std::nullopt;
  }
  SurfacePart part = std::move(found->second);
  this->Ready.erase(found);
  return part;
}
}
