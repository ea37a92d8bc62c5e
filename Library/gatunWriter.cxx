// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBorder.h"

#include "gatunErrorBound.h"
#include "gatunFileWriter.h"
#include "gatunMeshMerges.h"
#include "gatunPartWriter.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

using namespace gatun;

/** A file that is being written, as a whole or in parts. */
struct gatun_writer
{
  std::unique_ptr<FileWriter> File; // of whole meshes
  std::unique_ptr<PartWriter> Parts;
  std::vector<std::unique_ptr<const MergeTree>> Trees; // of the meshes
  std::vector<ArrayDescription> Arrays;
  WriterOptions Options;
  MeshInput Mesh; // of the next steps
  MeshInput First;
  MeshInput Last;
  bool HasMesh = false; // there is none at first when a file is appended to
  bool HasFailed = false;

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

namespace
{
MeshInput TakeMesh(const gatun_mesh& from)
{
  MeshInput mesh;
  mesh.Points = from.points;
  mesh.CoordinateType = TakeType(from.coordinate_type);
  Need(IsFloating(mesh.CoordinateType), "coordinates have to be float32 or float64");
  mesh.Coordinates = from.coordinates;
  mesh.Cells = from.cells;
  mesh.Connectivity = from.connectivity;
  mesh.WideIds = from.wide_ids != 0;
  mesh.Types = from.types;
  mesh.Offsets = from.offsets;
  mesh.FaceLocations = from.face_locations;
  mesh.Faces = from.faces;
  mesh.FacesSize = from.faces_size;
  Need(mesh.Points == 0 || mesh.Coordinates, "the mesh has no coordinates");
  Need(mesh.Cells == 0 || mesh.Connectivity, "the mesh has no connectivity");
  Need(!mesh.Types == !mesh.Offsets, "types and offsets come together");
  Need(!mesh.FaceLocations == !mesh.Faces, "faces and their locations come together");
  if (from.point_array)
  {
    const auto array = Take(from.point_array);
    if (array.name)
    {
      mesh.PointArray.Name = array.name;
    }
    mesh.PointArray.ComponentNames = TakeTexts(array.component_names, 3);
    mesh.PointArray.Keys = TakeKeys(array.keys, array.key_count);
  }
  return mesh;
}

/** Descriptions of arrays with what else a writer is told of them. */
struct TakenArrays
{
  TakenArrays(const gatun_array* arrays, std::size_t count)
  {
    Need(arrays || count == 0, "the descriptions of the arrays are missing");
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto& from = this->Sources.emplace_back(TakeElement(arrays, i));
      this->List.push_back(TakeArray(from));
    }
    this->AddErrors();
  }

  /** The core knows bounds by the names of arrays, which may repeat, and "*" for all. */
  void AddErrors()
  {
    std::map<std::string, std::string> bounds;
    for (std::size_t i = 0; i < this->List.size(); ++i)
    {
      const std::string bound = this->Sources[i].error ? this->Sources[i].error : "";
      const auto& name = this->List[i].Name;
      const auto [found, isNew] = bounds.emplace(name, bound);
      Need(found->second == bound, "arrays of the same name have different bounds of errors");
      if (isNew && !bound.empty())
      {
        Need(name != "*", "an array with the name '*' has to be exact");
        this->Errors.push_back(ParseError(name + "=" + bound));
      }
    }
  }

  /** Adds the fields that a hierarchy preserves: see gatun_array::weight. */
  void AddFields(MeshMerges& merges) const
  {
    const auto isField = [&](std::size_t i)
    { return this->List[i].Where == Association::Point && this->Sources[i].values; };
    const auto add = [&](auto&& weigh)
    {
      bool any = false;
      for (std::size_t i = 0; i < this->List.size(); ++i)
      {
        if (const double weight = weigh(i); weight > 0)
        {
          Need(isField(i), "an array with a weight in the hierarchy has no values of points");
          merges.AddArray(
            this->List[i].Type, this->Sources[i].values, this->List[i].Components, weight);
          any = true;
        }
      }
      return any;
    };
    constexpr std::uint32_t scalars = 1;
    if (!add([&](std::size_t i) { return this->Sources[i].weight; }) &&
      !add([&](std::size_t i)
        { return isField(i) && (this->List[i].AttributeRoles & scalars) ? 1. : 0.; }))
    {
      add([&](std::size_t i) { return isField(i) ? 1. : 0.; });
    }
  }

  std::vector<gatun_array> Sources;
  std::vector<ArrayDescription> List;
  std::vector<ArrayError> Errors;
};

WriterOptions TakeOptions(const gatun_options& from, const TakenArrays& arrays)
{
  Need((from.keep_order & ~std::uint32_t{ KeepAll }) == 0, "there is no such order to keep");
  Need(from.profile == GATUN_FAST || from.profile == GATUN_SMALL, "there is no such profile");
  Need(from.layers >= GATUN_NO_LAYERS && from.layers <= GATUN_HISTOGRAM,
    "there is no such spacing of layers");
  WriterOptions options;
  options.Keep = static_cast<std::uint8_t>(from.keep_order);
  options.Coding = from.profile == GATUN_SMALL ? Profile::Small : Profile::Fast;
  options.ChunkSize = from.chunk_size;
  options.KeyStepInterval =
    from.key_step_interval > 0 ? from.key_step_interval : options.KeyStepInterval;
  options.PointsMove = from.points_move != 0;
  options.Boundary = from.boundary != 0;
  options.Levels = from.levels;
  options.Dependencies = from.dependencies != 0;
  options.Errors = arrays.Errors;
  if (from.layers != GATUN_NO_LAYERS)
  {
    Need(from.layer_array < arrays.List.size(), "there is no array for the layers");
    options.Layers = LayerRequest{ from.layer_array, from.layer_component, from.layer_count,
      static_cast<LayerSpacing>(from.layers), arrays.Sources[from.layer_array].values };
    Need(options.Layers->Values != nullptr, "the array of the layers has no values");
  }
  return options;
}

FieldData TakeFields(const gatun_field* fields, std::size_t count)
{
  FieldData data;
  Need(fields || count == 0, "the field data are missing");
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto from = TakeElement(fields, i);
    NeedPointers(from.name);
    FieldArray field;
    field.Name = from.name;
    field.VTKType = from.vtk_type;
    field.Components = std::max(from.components, 1u);
    field.ComponentNames = TakeTexts(from.component_names, field.Components);
    field.Keys = TakeKeys(from.keys, from.key_count);
    field.IsText = from.texts != nullptr;
    Need(field.IsText || from.values || from.count == 0, "a field array has no values");
    for (std::uint64_t k = 0; field.IsText && k < from.count; ++k)
    {
      const char* const text = from.texts[k] ? from.texts[k] : "";
      field.Texts.emplace_back(
        text, from.text_bytes ? static_cast<std::size_t>(from.text_bytes[k]) : std::strlen(text));
    }
    if (!field.IsText)
    {
      field.Type = TakeType(from.type);
      const auto* const bytes = static_cast<const std::uint8_t*>(from.values);
      field.Values.assign(bytes, bytes + Product(from.count, SizeOf(field.Type)));
    }
    data.push_back(std::move(field));
  }
  return data;
}

/** The arrays of a step, for so many points and cells. */
std::vector<const void*> TakeValues(const gatun_values& from,
  const std::vector<ArrayDescription>& arrays, std::uint64_t points, std::uint64_t cells)
{
  Need(from.array_count == arrays.size(), "the step has not as many arrays as the file");
  Need(from.arrays || arrays.empty(), "the values of the arrays are missing");
  std::vector<const void*> values;
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const auto& array = arrays[i];
    const auto tuples = array.Where == Association::Point ? points : cells;
    const auto bytes = Product(tuples, Product(array.Components, SizeOf(array.Type)));
    if (from.arrays[i].bytes != bytes || (bytes > 0 && !from.arrays[i].data))
    {
      ThrowInvalid("array '" + array.Name + "' has " + std::to_string(from.arrays[i].bytes) +
        " bytes of values, and needs " + std::to_string(bytes));
    }
    values.push_back(from.arrays[i].data);
  }
  return values;
}

RemainingCells TakeRemaining(const gatun_values& from)
{
  RemainingCells remaining;
  remaining.Cells = { from.remaining_cells, static_cast<std::size_t>(from.remaining_cell_count) };
  remaining.DropsPoints = from.drops_points != 0;
  if (remaining.DropsPoints)
  {
    Need(from.remaining_points || from.remaining_point_count == 0,
      "the numbers of the remaining points are missing");
    remaining.Points = { from.remaining_points,
      static_cast<std::size_t>(from.remaining_point_count) };
  }
  return remaining;
}
}

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
      const auto wish = Take(options);
      const TakenArrays taken(arrays, array_count);
      auto made = std::make_unique<gatun_writer>();
      made->Mesh = TakeMesh(form);
      made->Arrays = taken.List;
      made->Options = TakeOptions(wish, taken);
      made->Options.IsSurface = form.is_surface != 0;
      const auto report = WrapProgress(progress, user);
      if (wish.hierarchy || wish.levels > 0)
      {
        MeshMerges merges(made->Mesh);
        taken.AddFields(merges);
        made->Trees.push_back(std::make_unique<const MergeTree>(made->Options.IsSurface
            ? merges.BuildSurface(made->Mesh, {}, report)
            : merges.Build(made->Mesh, {}, report)));
        made->Options.Tree = made->Trees.back().get();
      }
      made->File =
        std::make_unique<FileWriter>(path, made->Mesh, made->Arrays, made->Options, report);
      made->First = made->Last = made->Mesh;
      made->HasMesh = true;
      *writer = made.release();
    });
}

gatun_status gatun_append(const char* path, gatun_writer** writer)
{
  return Guard(
    [&]
    {
      NeedPointers(path, writer);
      auto made = std::make_unique<gatun_writer>();
      made->File = std::make_unique<FileWriter>(FileWriter::Append(), path);
      made->Arrays = made->File->GetArrays();
      *writer = made.release();
    });
}

gatun_status gatun_add_mesh(gatun_writer* writer, const gatun_mesh* mesh, gatun_progress progress,
  void* user, uint32_t* number)
{
  return Guard(
    [&]
    {
      NeedPointers(writer, mesh);
      Need(writer->File != nullptr, "a mesh in parts has no other meshes");
      writer->Do(
        [&]
        {
          writer->Mesh = TakeMesh(Take(mesh));
          auto options = writer->Options;
          options.Tree = nullptr;
          const auto added =
            writer->File->AddMesh(writer->Mesh, options, WrapProgress(progress, user));
          writer->Last = writer->Mesh;
          writer->HasMesh = true;
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
          const auto list = TakeValues(from, writer->Arrays, points, cells);
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
      Need(!wish.hierarchy && wish.levels == 0 && wish.layers == GATUN_NO_LAYERS,
        "hierarchies and layers need the whole mesh, and cannot be written in parts");
      const TakenArrays taken(arrays, array_count);
      auto made = std::make_unique<gatun_writer>();
      made->Arrays = taken.List;
      PartWriterOptions own;
      own.File = TakeOptions(wish, taken);
      made->Parts = std::make_unique<PartWriter>(path, made->Arrays, own);
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
          writer->Parts->SurveyStep(
            TakeValues(Take(values), writer->Arrays, writer->Mesh.Points, writer->Mesh.Cells));
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
