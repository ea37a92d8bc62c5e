// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnBlockSource.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnPartReader.h"
#include "gtnPrepare.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnSpooledMesh.h"
#include "gtnTimes.h"

#include "gatunArrayBridge.h"
#include "gatunCellInput.h"
#include "gatunError.h"
#include "gatunGhosts.h"
#include "gatunNewArray.h"
#include "vtkGatunMergeBlocks.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>

namespace gtn
{
vtkStandardNewMacro(BlockSource);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

// Replaces the data set of a file in the tree.
void SetData(
  const BlockList& blocks, vtkDataObjectTree* tree, std::size_t file, vtkDataObject* data)
{
  auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (iterator->GetCurrentFlatIndex() == blocks.Places[file])
    {
      tree->SetDataSetFrom(iterator, data);
      return;
    }
  }
}

// A data set as a grid without ghosts, whose cells are right. file: the one that it is from.
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(
  vtkDataObject* data, const std::string& file, bool quiet)
{
  if (!vtkDataSet::SafeDownCast(data))
  {
    SayOnce(file, std::string("holds ") + data->GetClassName() + ", which is left out", quiet);
    return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  vtkNew<vtkGatunMergeBlocks> merge;
  merge->SetInputDataObject(data);
  merge->Update();
  CheckMessages(file, quiet);
  try
  {
    return gatun::MakeCellInput(merge->GetOutput(), false, gatun::GhostCells::Remove).Grid;
  }
  catch (const gatun::Error& error)
  {
    throw Failure(file, error.what());
  }
}

std::size_t GhostsOf(vtkDataObject* data)
{
  auto* const set = vtkDataSet::SafeDownCast(data);
  return set ? gatun::CountGhosts(set->GetCellData()) : 0;
}

bool HasUnusedPoints(vtkUnstructuredGrid* grid)
{
  std::vector<bool> used(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      used[static_cast<std::size_t>(ids->GetId(i))] = true;
    }
  }
  return std::find(used.begin(), used.end(), false) != used.end();
}

/** Gives a form the arrays of a grid with some tuples of any values. */
void CopyForm(vtkDataSetAttributes* from, vtkDataSetAttributes* to, vtkIdType tuples)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    auto copy = vtk::TakeSmartPointer(array->NewInstance());
    copy->SetName(array->GetName());
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    copy->CopyComponentNames(array);
    copy->SetNumberOfTuples(tuples);
    if (auto* numbers = vtkDataArray::SafeDownCast(copy))
    {
      numbers->Fill(0);
    }
    const int number = to->AddArray(copy);
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      if (from->GetAbstractAttribute(type) == array)
      {
        to->SetActiveAttribute(number, type);
      }
    }
  }
}

// The global id of a point of a form, which is not that of any point of a block.
double FormId(vtkDataArray* ids, std::size_t number, int point)
{
  constexpr double exact = 4503599627370496.; // 2^52
  return std::min(exact, ids->GetDataTypeMax()) - 2 * static_cast<double>(number) - point;
}

/** A small grid in place of a block, so that merging it tells the arrays that blocks have together:
 * a vertex, or if the block has points that no cell uses, two vertices at the first of two points.
 * An empty block remains empty. number: of the block. */
vtkSmartPointer<vtkUnstructuredGrid> MakeForm(vtkUnstructuredGrid* grid, std::size_t number)
{
  const bool isEmpty = grid->GetNumberOfPoints() == 0 && grid->GetNumberOfCells() == 0;
  const vtkIdType count = isEmpty ? 0 : HasUnusedPoints(grid) ? 2 : 1;
  auto form = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints() ? grid->GetPoints()->GetDataType() : VTK_FLOAT);
  form->SetPoints(points);
  form->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(0, 0, 0);
    const vtkIdType first = 0;
    form->InsertNextCell(VTK_VERTEX, 1, &first);
  }
  CopyForm(grid->GetPointData(), form->GetPointData(), count);
  CopyForm(grid->GetCellData(), form->GetCellData(), count);
  vtkDataArray* ids = form->GetPointData()->GetGlobalIds();
  for (vtkIdType i = 0; i < count && ids; ++i)
  {
    ids->SetComponent(i, 0, FormId(ids, number, static_cast<int>(i)));
  }
  form->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return form;
}

/** A form with the field arrays of a time step: those that all blocks have in common change with
 * time in all of them. surveyed: the form of a block, with those of the step of the form; current:
 * the block at the step. */
vtkSmartPointer<vtkUnstructuredGrid> FollowStep(
  vtkUnstructuredGrid* form, vtkUnstructuredGrid* surveyed, vtkUnstructuredGrid* current)
{
  auto follower = vtkSmartPointer<vtkUnstructuredGrid>::New();
  follower->ShallowCopy(form);
  vtkFieldData* const field = form->GetFieldData();
  for (int i = 0; i < field->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = field->GetAbstractArray(i);
    const char* const name = array->GetName();
    vtkAbstractArray* const old = name ? surveyed->GetFieldData()->GetAbstractArray(name) : nullptr;
    vtkAbstractArray* const now = name ? current->GetFieldData()->GetAbstractArray(name) : nullptr;
    if (old && now && gatun::AreEqual(array, old))
    {
      follower->GetFieldData()->AddArray(now); // in its place
    }
  }
  return follower;
}

// Where a form is in merged blocks.
struct FormPlace
{
  std::size_t Number = 0;
  vtkIdType FirstPoint = 0; // if points are not joined
  vtkIdType FirstCell = 0;
  vtkIdType Size = 0;
};

/** Makes ghosts of forms, which are not written, nor the points that only they use: each point gets
 * a cell. */
void MarkForms(vtkUnstructuredGrid* grid, const std::vector<FormPlace>& forms, bool hasGlobalIds)
{
  vtkDataArray* ids = hasGlobalIds ? grid->GetPointData()->GetGlobalIds() : nullptr;
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  if (!ghosts)
  {
    ghosts = grid->AllocateCellGhostArray();
  }
  for (const FormPlace& form : forms)
  {
    for (vtkIdType cell = form.FirstCell; cell < form.FirstCell + form.Size; ++cell)
    {
      ghosts->SetValue(cell,
        static_cast<unsigned char>(ghosts->GetValue(cell) | vtkDataSetAttributes::DUPLICATECELL));
    }
    vtkIdType point = form.FirstPoint + 1;
    for (vtkIdType i = 0; ids && form.Size > 1 && i < ids->GetNumberOfTuples(); ++i)
    {
      if (ids->GetComponent(i, 0) == FormId(ids, form.Number, 1))
      {
        point = i;
      }
    }
    if (form.Size > 1)
    {
      grid->GetCells()->ReplaceCellAtId(form.FirstCell + 1, 1, &point);
    }
  }
}

/** Tells which points are joined with those of other blocks: as vtkGatunMergeBlocks does. */
void MarkJoins(vtkUnstructuredGrid* grid, bool hasGlobalIds)
{
  vtkDataArray* ids = grid->GetPointData()->GetGlobalIds();
  AddJoinArray(grid, ids && hasGlobalIds ? ids : nullptr);
}

} // anonymous namespace

//------------------------------------------------------------------------------
BlockSource::BlockSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
void BlockSource::SetSteps(
  const std::vector<SeriesStep>& steps, const InputOptions& options, bool hasTime)
{
  this->Steps = steps;
  this->Options = options;
  this->Times = hasTime ? TimesOf(steps) : std::vector<double>();
  this->Surveys.clear();
  for (const SeriesStep& step : steps)
  {
    this->Surveys.emplace_back().Blocks = ReadBlockList(step.Files.front(), options);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void BlockSource::SetExodus(const std::string& file, const InputOptions& options)
{
  this->Options = options;
  this->IsOneFile = true;
  const std::size_t count = CountExodusBlocks(file, options.Sets);
  if (count == 0)
  {
    throw Failure(file, "has no blocks");
  }
  this->Surveys.assign(1, {});
  this->Surveys.front().Blocks = MakeBlockList(file, count);
  const auto reader = MakeExodusReader(file, options.Sets, 0);
  reader->UpdateInformation();
  CheckMessages(file, true);
  vtkInformation* info = reader->GetOutputInformation(0);
  this->Times.clear();
  if (info->Has(Pipeline::TIME_STEPS()))
  {
    const double* times = info->Get(Pipeline::TIME_STEPS());
    this->Times.assign(times, times + info->Length(Pipeline::TIME_STEPS()));
  }
  this->Modified();
}

//------------------------------------------------------------------------------
int BlockSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  PublishTimes(info, this->Times);
  return 1;
}

//------------------------------------------------------------------------------
int BlockSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const std::size_t step = FindStep(info, this->Times);
  try
  {
    const Survey& survey = this->GetSurvey(step);
    const auto pieces =
      static_cast<std::size_t>(std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())));
    const auto piece = static_cast<std::size_t>(info->Get(Pipeline::UPDATE_PIECE_NUMBER()));
    const std::size_t count = survey.Blocks.Files.size();
    if (!survey.IsDone && (pieces > 1 || this->IsOneFile))
    {
      this->SurveyStep(step);
    }
    this->Read(step, piece * count / pieces, (piece + 1) * count / pieces, output);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< ReasonOf(error));
    return 0;
  }
  if (!this->Times.empty())
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Times[step]);
  }
  return 1;
}

//------------------------------------------------------------------------------
// A block of an Exodus file has a name.
struct BlockSource::Block
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::string Name;
  std::size_t Ghosts = 0; // that were left out
};

//------------------------------------------------------------------------------
BlockSource::Block BlockSource::ReadBlock(std::size_t step, std::size_t number)
{
  const std::string& file = this->GetSurvey(step).Blocks.Files[number];
  const bool quiet = this->Options.Quiet;
  if (!this->IsOneFile)
  {
    const vtkSmartPointer<vtkDataObject> data = ReadPart(file, {}, this->Options);
    return { MakeGrid(data, file, quiet), {}, GhostsOf(data) };
  }
  const auto reader = MakeExodusReader(file, this->Options.Sets, number);
  if (this->Times.empty())
  {
    reader->Update();
  }
  else
  {
    reader->UpdateTimeStep(this->Times[step]);
  }
  CheckMessages(file, quiet);
  Block block;
  auto* tree = vtkDataObjectTree::SafeDownCast(reader->GetOutputDataObject(0));
  auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (block.Grid)
    {
      throw Failure(file, "has blocks that cannot be read one by one");
    }
    block.Grid = MakeGrid(iterator->GetCurrentDataObject(), file, quiet);
    vtkInformation* info =
      iterator->HasCurrentMetaData() ? iterator->GetCurrentMetaData() : nullptr;
    const char* name = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
    block.Name = name ? name : "";
  }
  if (!block.Grid)
  {
    throw Failure(file, "has blocks that cannot be read one by one");
  }
  return block;
}

//------------------------------------------------------------------------------
// Reads all blocks of a step, one after the other, and keeps their forms.
void BlockSource::SurveyStep(std::size_t step)
{
  Survey& survey = this->GetSurvey(step);
  std::size_t ghosts = 0;
  for (std::size_t i = 0; i < survey.Blocks.Files.size(); ++i)
  {
    const Block block = this->ReadBlock(step, i);
    ghosts += block.Ghosts;
    survey.HasGlobalIds = survey.HasGlobalIds &&
      (block.Grid->GetNumberOfPoints() == 0 || block.Grid->GetPointData()->GetGlobalIds());
    survey.Forms.push_back(MakeForm(block.Grid, i));
    SetData(survey.Blocks, survey.Blocks.Tree, i, survey.Forms.back());
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(survey.Blocks.Tree);
    if (this->IsOneFile && !block.Name.empty())
    {
      blocks->GetMetaData(static_cast<unsigned>(i))
        ->Set(vtkCompositeDataSet::NAME(), block.Name.c_str());
    }
  }
  survey.IsDone = true;
  if (ghosts > 0 && !this->AreGhostsTold)
  {
    this->AreGhostsTold = true;
    if (!this->Options.Lost)
    {
      vtkWarningMacro(<< gatun::DescribeLostGhosts(ghosts));
    }
    else if (this->Options.Ghosts)
    {
      this->Options.Lost->insert(gatun::DescribeLostGhosts(ghosts));
    }
  }
}

//------------------------------------------------------------------------------
// Copies a tree, and its data up to the pointers of arrays. VTK 9.6 has one name for that.
template <typename Tree>
void CopyTree(Tree* from, Tree* to)
{
  if constexpr (requires { to->RecursiveShallowCopy(from); })
  {
    to->RecursiveShallowCopy(from);
  }
  else
  {
    to->ShallowCopy(from);
  }
}

//------------------------------------------------------------------------------
// Merges some blocks with the forms of the others, which become ghosts.
void BlockSource::Read(
  std::size_t step, std::size_t first, std::size_t last, vtkUnstructuredGrid* output)
{
  const Survey& survey = this->GetSurvey(step);
  auto blocks = vtk::TakeSmartPointer(survey.Blocks.Tree->NewInstance());
  CopyTree(survey.Blocks.Tree.Get(), blocks.Get());
  for (std::size_t i = first; i < last; ++i)
  {
    const auto grid = this->ReadBlock(step, i).Grid;
    SetData(survey.Blocks, blocks, i, grid);
    for (std::size_t k = 0; i == first && this->IsOneFile && k < survey.Forms.size(); ++k)
    {
      if (k < first || k >= last)
      {
        SetData(survey.Blocks, blocks, k, FollowStep(survey.Forms[k], survey.Forms[i], grid));
      }
    }
  }

  // Merged blocks are in the order of the tree.
  std::vector<FormPlace> forms;
  vtkIdType points = 0;
  vtkIdType cells = 0;
  auto iterator = vtk::TakeSmartPointer(blocks->NewTreeIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const auto begin = survey.Blocks.Places.begin();
    const auto found =
      std::find(begin, survey.Blocks.Places.end(), iterator->GetCurrentFlatIndex());
    const auto number = static_cast<std::size_t>(found - begin);
    auto* data = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (number < first || number >= last)
    {
      forms.push_back({ number, points, cells, data->GetNumberOfCells() });
    }
    points += data->GetNumberOfPoints();
    cells += data->GetNumberOfCells();
  }
  vtkNew<vtkGatunMergeBlocks> merge;
  merge->SetInputDataObject(blocks);
  merge->Update();
  if (merge->GetErrorCode() != vtkErrorCode::NoError ||
    merge->GetOutput()->GetNumberOfCells() != cells)
  {
    throw Failure("cannot be merged");
  }
  vtkWarningMacro(<< survey.Blocks.Files.size() << " blocks were merged into one grid");
  InputOptions options = this->Options;
  vtkNew<vtkUnstructuredGrid> merged;
  merged->ShallowCopy(merge->GetOutput());
  if (last - first < survey.Blocks.Files.size())
  {
    MarkJoins(merged, survey.HasGlobalIds);
    options.Arrays.emplace_back(JoinArrayName);
    MarkForms(merged, forms, survey.HasGlobalIds);
  }
  Preparer::Prepare(
    gatun::MakeCellInput(merged, false, gatun::GhostCells::Remove).Grid, options, output);
  CheckMessages(this->IsOneFile ? survey.Blocks.Files.front() : this->Steps[step].Files.front(),
    this->Options.Quiet);
}
}
