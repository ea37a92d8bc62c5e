// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileReader: the boundary.

#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"

namespace gatun
{
//------------------------------------------------------------------------------
void FileReader::Internals::ReadBoundary()
{
  if (this->File.FindSections(SectionBoundary).empty())
  {
    return;
  }
  this->Boundary = this->File.FindSection(SectionBoundary, BoundaryName);
  if (this->IsSurface)
  {
    this->File.Fail(ErrorCode::Corrupt, "it is a surface, and has a boundary all the same");
  }
}

//------------------------------------------------------------------------------
/** Throws unless this can be the boundary of the whole. */
void FileReader::Internals::CheckBoundary(const Internals& whole) const
{
  const bool fits = this->IsSurface && this->Meta.Points <= whole.Meta.Points &&
    this->Meta.CoordinateType == whole.Meta.CoordinateType &&
    this->Meta.Arrays == whole.Meta.Arrays && this->Meta.HasTime == whole.Meta.HasTime &&
    this->Times == whole.Times && this->Levels.empty() && this->Masks.empty() &&
    (!this->Tree || (whole.Tree && this->Tree->Merges <= whole.Tree->Merges));
  if (!fits)
  {
    this->File.Fail(ErrorCode::Corrupt, "it cannot be the boundary of the mesh");
  }
}

//------------------------------------------------------------------------------
bool FileReader::HasBoundary() const
{
  return this->Self->Boundary.has_value();
}

//------------------------------------------------------------------------------
std::shared_ptr<const FileReader> FileReader::OpenBoundary() const
{
  if (!this->HasBoundary())
  {
    ThrowInvalid(
      "there is no boundary in the file; write one with gtn pack --boundary", this->GetPath());
  }
  return std::shared_ptr<const FileReader>(
    new FileReader(std::make_unique<Internals>(*this->Self, *this->Self->Boundary)));
}

//------------------------------------------------------------------------------
MeshCounts FileReader::CountBoundary() const
{
  return this->HasBoundary()
    ? Internals::Count(*this->Self, *this->Self->Boundary, Internals::BoundaryName)
    : MeshCounts();
}
}
