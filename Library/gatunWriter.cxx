// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWriterInput.h"

#include "gatunFileWriter.h"
#include "gatunPartWriter.h"

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace gatun;

/** A file that is being written, as a whole or in parts. */
struct gatun_writer
{
  std::unique_ptr<FileWriter> File; // of whole meshes
  std::unique_ptr<PartWriter> Parts;
  std::vector<std::unique_ptr<const MergeTree>> Trees; // of the meshes
  TakenArrays Arrays;
  WriterOptions Options;
  bool HasHierarchy = false;
  MeshInput Mesh; // of the next steps
  MeshInput First;
  MeshInput Last;
  bool HasMesh = false; // there is none at first when a file is appended to
  bool HasFailed = false;

  /** Lets the next steps have a mesh that has been added. */
  void SetMesh(const MeshInput& mesh)
  {
    this->Mesh = this->Last = mesh;
    this->HasMesh = true;
  }

  /** The options of a mesh. values: of the arrays at its first step, null where there are none. */
  WriterOptions MakeOptions(const MeshInput& mesh, bool isSurface,
    std::span<const void* const> values, const FileWriter::Progress& progress)
  {
    auto options = this->Options;
    options.IsSurface = isSurface;
    if (options.Layers)
    {
      options.Layers->Values = values[options.Layers->Array];
      Need(mesh.Points == 0 || options.Layers->Values, "the array of the layers has no values");
    }
    if (this->HasHierarchy)
    {
      options.Tree = this->Trees
                       .emplace_back(std::make_unique<const MergeTree>(
                         this->Arrays.BuildTree(mesh, isSurface, values, progress)))
                       .get();
    }
    return options;
  }

  void TakeAll(TakenArrays arrays, const gatun_options& options)
  {
    this->Arrays = std::move(arrays);
    this->Options = TakeOptions(options, this->Arrays);
    this->HasHierarchy = options.hierarchy != 0 || options.levels > 0;
  }

  /** Does a part of the work, unless something has failed before. */
  template <typename Work>
  void Do(Work&& work)
  {
    Need(!this->HasFailed, "writing has failed before; the writer can only be discarded");
    this->HasFailed = true;
    work();
    this->HasFailed = false;
  }
};

//------------------------------------------------------------------------------
gatun_status gatun_create(const char* path, const gatun_mesh* mesh, const gatun_array* arrays,
  size_t array_count, const gatun_options* options, gatun_progress progress, void* user,
  gatun_writer** writer)
{
  return Guard(
    [&]
    {
      NeedPointers(path, mesh, writer);
      const auto form = Take(mesh);
      auto made = std::make_unique<gatun_writer>();
      made->TakeAll(TakenArrays(arrays, array_count), Take(options));
      made->First = TakeMesh(form);
      const auto report = WrapProgress(progress, user);
      const auto own =
        made->MakeOptions(made->First, form.is_surface != 0, made->Arrays.GetValues(), report);
      made->File =
        std::make_unique<FileWriter>(path, made->First, made->Arrays.GetList(), own, report);
      made->SetMesh(made->First);
      *writer = made.release();
    });
}

gatun_status gatun_append(const char* path, const gatun_array* arrays, size_t array_count,
  const gatun_options* options, gatun_writer** writer)
{
  return Guard(
    [&]
    {
      NeedPointers(path, writer);
      auto made = std::make_unique<gatun_writer>();
      made->File = std::make_unique<FileWriter>(FileWriter::Append(), path);
      TakenArrays taken(arrays, array_count);
      taken.SetList(made->File->GetArrays());
      made->TakeAll(std::move(taken), Take(options));
      *writer = made.release();
    });
}

gatun_status gatun_add_mesh(gatun_writer* writer, const gatun_mesh* mesh, const gatun_values* first,
  gatun_progress progress, void* user, uint32_t* number)
{
  return Guard(
    [&]
    {
      NeedPointers(writer, mesh);
      Need(writer->File != nullptr, "a mesh in parts has no other meshes");
      writer->Do(
        [&]
        {
          const auto form = Take(mesh);
          const auto input = TakeMesh(form);
          const auto& arrays = writer->Arrays.GetList();
          const auto values = first ? TakeValues(Take(first), arrays, input.Points, input.Cells)
                                    : std::vector<const void*>(arrays.size());
          const auto report = WrapProgress(progress, user);
          const auto options = writer->MakeOptions(input, form.is_surface != 0, values, report);
          const auto added = writer->File->AddMesh(input, options, report);
          writer->SetMesh(input);
          if (number)
          {
            *number = added;
          }
        });
    });
}

gatun_status gatun_use_mesh(gatun_writer* writer, uint32_t number)
{
  return Guard(
    [&]
    {
      NeedPointers(writer);
      Need(writer->File != nullptr, "a mesh in parts has no other meshes");
      Need(writer->HasMesh, "there is no mesh");
      writer->Do(
        [&]
        {
          writer->File->UseMesh(number); // the last one, or the first one of a new file
          writer->Mesh = number == 0 ? writer->First : writer->Last;
        });
    });
}

//------------------------------------------------------------------------------
gatun_status gatun_write_step(
  gatun_writer* writer, const gatun_values* values, gatun_progress progress, void* user)
{
  return Guard(
    [&]
    {
      NeedPointers(writer, values);
      Need(writer->Parts || writer->HasMesh, "there is no mesh");
      writer->Do(
        [&]
        {
          const auto from = Take(values);
          const bool isWhole = !from.remaining_cells;
          const auto remaining = isWhole ? RemainingCells() : TakeRemaining(from);
          const auto points = remaining.DropsPoints ? remaining.Points.size() : writer->Mesh.Points;
          const auto cells = isWhole ? writer->Mesh.Cells : remaining.Cells.size();
          const auto list = TakeValues(from, writer->Arrays.GetList(), points, cells);
          const auto fields = TakeFields(from.fields, from.field_count);
          const auto report = WrapProgress(progress, user);
          if (writer->Parts)
          {
            Need(isWhole && !from.coordinates, "a mesh in parts keeps its cells and points");
            writer->Parts->WriteStep(list, fields, from.has_time != 0, from.time, report);
            return;
          }
          const void* coordinates = nullptr;
          if (from.coordinates)
          {
            coordinates = TakeBuffer(*from.coordinates,
              Product(points, 3 * SizeOf(writer->Mesh.CoordinateType)), "the coordinates");
          }
          writer->File->WriteStep(list, fields, from.has_time != 0, from.time, report, coordinates,
            isWhole ? nullptr : &remaining);
        });
    });
}

gatun_status gatun_finish(gatun_writer* writer, uint64_t* file_bytes)
{
  const std::unique_ptr<gatun_writer> own(writer);
  return Guard(
    [&]
    {
      NeedPointers(writer);
      writer->Do(
        [&]
        {
          const auto written =
            writer->Parts ? writer->Parts->Finish().File : writer->File->Finish();
          if (file_bytes)
          {
            *file_bytes = written.FileBytes;
          }
        });
    });
}

void gatun_discard(gatun_writer* writer)
{
  delete writer;
}

//------------------------------------------------------------------------------
namespace
{
constexpr const char* NotInParts = "the mesh is not written in parts";

/** Calls use with the writer of parts and the next part, whose steps come next. */
template <typename Use>
gatun_status TakePart(gatun_writer* writer, const gatun_mesh* part, Use&& use)
{
  return Guard(
    [&]
    {
      NeedPointers(writer, part);
      Need(writer->Parts != nullptr, NotInParts);
      writer->Do(
        [&]
        {
          writer->Mesh = TakeMesh(Take(part));
          use(*writer->Parts, writer->Mesh);
        });
    });
}
}

//------------------------------------------------------------------------------
gatun_status gatun_create_parts(const char* path, const gatun_array* arrays, size_t array_count,
  const gatun_options* options, gatun_writer** writer)
{
  return Guard(
    [&]
    {
      NeedPointers(path, writer);
      const auto wish = Take(options);
      Need(wish.layers == GATUN_NO_LAYERS,
        "layers need the whole mesh, and cannot be written in parts");
      auto made = std::make_unique<gatun_writer>();
      made->TakeAll(TakenArrays(arrays, array_count), wish);
      PartWriterOptions own;
      own.File = made->Options;
      if (made->HasHierarchy)
      {
        own.Weights = made->Arrays.FindWeights();
      }
      made->Parts = std::make_unique<PartWriter>(path, made->Arrays.GetList(), own);
      *writer = made.release();
    });
}

gatun_status gatun_survey_part(gatun_writer* writer, const gatun_mesh* part,
  const int64_t* global_ids, gatun_progress progress, void* user)
{
  return TakePart(writer, part,
    [&](PartWriter& parts, const MeshInput& mesh)
    { parts.Survey(mesh, global_ids, WrapProgress(progress, user)); });
}

gatun_status gatun_survey_step(gatun_writer* writer, const gatun_values* values)
{
  return Guard(
    [&]
    {
      NeedPointers(writer, values);
      Need(writer->Parts != nullptr, NotInParts);
      writer->Do(
        [&]
        {
          writer->Parts->SurveyStep(TakeValues(
            Take(values), writer->Arrays.GetList(), writer->Mesh.Points, writer->Mesh.Cells));
        });
    });
}

gatun_status gatun_add_part(gatun_writer* writer, const gatun_mesh* part, const int64_t* global_ids,
  gatun_progress progress, void* user)
{
  return TakePart(writer, part,
    [&](PartWriter& parts, const MeshInput& mesh)
    { parts.Write(mesh, global_ids, WrapProgress(progress, user)); });
}
