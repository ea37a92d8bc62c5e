// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDependencySection.h"

#include "gatunDependencyCodec.h"
#include "gatunError.h"
#include "gatunMeshDependencies.h"
#include "gatunParallel.h"

#include <chrono>
#include <system_error>

namespace gatun
{
namespace
{
constexpr std::chrono::milliseconds BetweenProgress{ 20 };
}

//------------------------------------------------------------------------------
DependencySection::DependencySection(WriterState& state, const WriterPart& part)
  : State(state)
  , Part(part)
{
  if (GetNumberOfThreads() == 1)
  {
    return;
  }
  try
  {
    this->Found = std::async(std::launch::async,
      [this] { return this->Find([this](double) { return !this->IsAborted; }); });
  }
  catch (const std::system_error&)
  {
    // There are no more threads. They are found when the section is written.
  }
}

//------------------------------------------------------------------------------
DependencySection::~DependencySection()
{
  this->IsAborted = true;
}

//------------------------------------------------------------------------------
std::optional<MergeDependencies> DependencySection::Find(
  const std::function<bool(double)>& progress) const
{
  const WriterOptions& options = this->State.Options;
  return FindDependencies(this->Part.Mesh, *options.Tree, options.IsSurface, progress);
}

//------------------------------------------------------------------------------
std::optional<MergeDependencies> DependencySection::Wait(
  const std::function<bool(double)>& progress)
{
  if (!this->Found.valid())
  {
    return this->Find(progress);
  }
  while (this->Found.wait_for(BetweenProgress) != std::future_status::ready)
  {
    if (progress && !progress(1))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  }
  return this->Found.get();
}

//------------------------------------------------------------------------------
void DependencySection::Write(const MergeTree& tree, const std::function<bool(double)>& progress)
{
  const auto dependencies = this->Wait(progress);
  const auto stream = dependencies ? EncodeDependencies(tree, *dependencies, progress) : Bytes();
  if (!stream.empty())
  {
    this->State.Statistics.DependencyBytes += stream.size();
    this->State.File.AddSection(SectionDependencies, stream, 0);
  }
}
}
