// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartSurvey_h
#define gatunPartSurvey_h

// Survey of all parts of a mesh before the first one is written.

#include "gatunArrayCopies.h"
#include "gatunBoundaryMerge.h"
#include "gatunDomainSurvey.h"
#include "gatunPartValues.h"
#include "gatunStepSection.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Data of a part after the survey. */
struct SurveyedPart
{
  std::size_t Chunks = 0;
  std::uint64_t Points = 0;
  std::uint64_t Cells = 0;
  std::uint64_t Hash = 0;                // of the mesh
  std::vector<std::uint64_t> StepHashes; // of the values
};

/** A hash of a mesh and, unless they are null, the global ids of its points. */
std::uint64_t HashPart(const MeshInput& mesh, const std::int64_t* globalIds);

/** A hash of the values of a step. */
std::uint64_t HashValues(const std::vector<ArrayDescription>& arrays,
  std::span<const void* const> values, std::uint64_t points, std::uint64_t cells);

/** The points of one part that other parts may have, too. */
class PartSurvey
{
public:
  /** Which points are looked for in other parts. */
  enum class Candidates
  {
    Boundary, ///< see FindPartBoundary
    WithIds   ///< those with a global id of 0 and more
  };

  /** part: with its layout. number: that of the part. globalIds: null if coordinates decide. */
  PartSurvey(const WriterPart& part, std::uint32_t number, const std::int64_t* globalIds,
    Candidates candidates);

  /** Adds the values of point arrays at a step. */
  void AddValues(const std::vector<ArrayDescription>& arrays, std::span<const void* const> values);

  const std::vector<BoundaryRecord>& GetUses() const { return this->Uses; }

private:
  std::vector<BoundaryRecord> Uses;
};

/** Finds the domains of coordinates and arrays of all parts. */
class PartDomains
{
public:
  /** rounded: the steps of the mesh whose values these are, if they are on its lattices; null
   * otherwise. */
  explicit PartDomains(const WriterState& state, const std::vector<PartStep>* rounded = nullptr)
    : State(state)
    , Rounded(rounded)
  {
  }

  void AddMesh(const MeshInput& part);
  void AddStep(std::size_t step, std::span<const void* const> values, std::uint64_t points,
    std::uint64_t cells);

  std::size_t GetSteps() const { return this->Steps.size(); }

  /** Serializes the values for another process, and adds such a message. */
  void Put(ByteWriter& out);
  void Add(ByteReader& in);

  /** The domains, when the numbers of points and cells of the file are known. before: the scales
   * of the step before, unless this one is a key step. */
  PointDomain FinishMesh();
  StepDomains FinishStep(std::size_t step, const StepScales* before);

  /** Forgets all that is known. To be called when all domains are finished. */
  void Clear()
  {
    this->Axes.clear();
    this->Steps.clear();
    this->Copies.clear();
  }

private:
  const Domain* FindRounded(std::size_t step, std::size_t array, std::size_t component) const;
  RoundingRequest GetRequest(const ArrayDescription& array) const;

  const WriterState& State;
  const std::vector<PartStep>* const Rounded;
  std::vector<DomainSurvey> Axes;
  std::vector<std::vector<DomainSurvey>> Steps; // component after component
  std::vector<CopySurvey> Copies;               // of the same steps
};
}

#endif
