// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartAssembly_h
#define gatunPartAssembly_h

#include "gatunPartAgreement.h"
#include "gatunPartExchange.h"
#include "gatunStepSection.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * Makes one file of the sections that each process has written into a temporary file: in the order
 * of the processes, with the tables of all. The bytes are those of a single process that writes the
 * same parts in the same order. Only the tables are sent.
 */
class PartAssembly
{
public:
  /** common: the file, in the first process; null in the others. */
  PartAssembly(PartExchange& exchange, const PartAgreement& agreement, WriterState& state,
    StepSection& steps, OutputFile* common);

  /** Completes the file, and moves it to its path. Collective. Returns its statistics in all
   * processes. */
  FileStatistics Finish();

private:
  /** The output of a process, with positions in its temporary file. */
  struct Contribution
  {
    std::uint64_t Size = 0;
    std::vector<SectionRef> Sections;
    MeshTable Table; // entries of its chunks and blocks
    MetaTable Meta;
    FileStatistics Statistics;
    std::vector<StepTable> Steps; // entries of its chunks and blocks
    std::uint64_t Begin = 0;      // of its sections, none if 0
    std::uint64_t Offset = 0;     // of them in the common file

    void Move(StreamRef& stream) const;
  };

  Bytes PutOwn() const;
  Contribution Read(const Bytes& message, const ProcessShare& share) const;
  std::vector<PartExchange::Message> Assemble(const std::vector<PartExchange::Message>& messages);
  StepTable MakeStep(const std::vector<Contribution>& all, std::size_t step) const;
  void TakeTables(const std::vector<Contribution>& all);
  void CopyOwn(const PartExchange::Message& message) const;

  PartExchange& Exchange;
  const PartAgreement& Agreement;
  WriterState& State;
  StepSection& Steps;
  OutputFile* const Common;
};
}

#endif
