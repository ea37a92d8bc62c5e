// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnBlockSource_h
#define gtnBlockSource_h

// Blocks in files of their own as the source of a pipeline, block by block.

#include "gtnBlockList.h"
#include "gtnFileList.h"
#include "gtnInputOptions.h"

#include "vtkUnstructuredGridAlgorithm.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gtn
{
/**
 * Reads the blocks of a piece, which consists of some of the files that a file lists, or of some of
 * the blocks of an Exodus file. A piece has
 * the arrays that vtkGatunMergeBlocks gives to all blocks together, and the point array
 * JoinArrayName unless there is only one: global ids if all blocks have them, or else -1.
 *
 * When it is asked for the first piece, all blocks are read once, one after the other, to know
 * which arrays they have.
 */
class BlockSource : public vtkUnstructuredGridAlgorithm
{
public:
  static BlockSource* New();
  vtkTypeMacro(BlockSource, vtkUnstructuredGridAlgorithm);

  /** steps: with one file each. hasTime: whether the steps have times; if not, there is only one.
   */
  void SetSteps(const std::vector<SeriesStep>& steps, const InputOptions& options, bool hasTime);

  /** The blocks of an Exodus file in place of files. Throws Failure. */
  void SetExodus(const std::string& file, const InputOptions& options);

protected:
  BlockSource();

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  /** What is known of the blocks of a step. */
  struct Survey
  {
    BlockList Blocks; ///< with a small grid for each block that has its arrays
    std::vector<vtkSmartPointer<vtkUnstructuredGrid>> Forms; ///< of the blocks, once done
    bool IsDone = false;
    bool HasGlobalIds = true; ///< whether points are joined by global ids
  };

  struct Block;

  Survey& GetSurvey(std::size_t step) { return this->Surveys[this->IsOneFile ? 0 : step]; }
  Block ReadBlock(std::size_t step, std::size_t number);
  void SurveyStep(std::size_t step);
  void Read(std::size_t step, std::size_t first, std::size_t last, vtkUnstructuredGrid* output);

  std::vector<SeriesStep> Steps;
  std::vector<Survey> Surveys;
  std::vector<double> Times;
  InputOptions Options;
  bool AreGhostsTold = false;
  bool IsOneFile = false; // an Exodus file, with all steps and the same blocks in all of them
};
}

#endif
