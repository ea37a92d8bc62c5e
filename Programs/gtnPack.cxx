// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn pack: any mesh or surface as a .gtn file.

#include "gtnArraySetting.h"
#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnHelp.h"
#include "gtnInput.h"
#include "gtnMergeOptions.h"
#include "gtnMessages.h"
#include "gtnNames.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnParse.h"
#include "gtnPieceOptions.h"
#include "gtnProgress.h"
#include "gtnStepChooser.h"
#include "gtnText.h"
#include "gtnWriteGatun.h"

#include "gatunError.h"
#include "gatunErrorBound.h"
#include "gatunFileReader.h"
#include "gatunPointRounding.h"
#include "vtkGatunWriter.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace gtn
{
namespace
{

struct PackOptions
{
  std::vector<std::string> In;
  std::string Out;
  bool Overwrite = false;
  InputOptions Input;
  std::string KeepOrder = "none";
  int ChunkSize = 0;
  int KeyStepInterval = 8;
  bool Hierarchy = false;
  bool Dependencies = false;
  int Levels = 0;
  bool Boundary = false;
  MergeOptions Merges;
  std::optional<std::string> Layers; ///< as given
  int LayerComponent = -1;
  std::optional<std::string> PointTolerance; ///< as given
  std::vector<std::string> Tolerances;       ///< of arrays, as given
  std::string Profile = "fast";
  bool FillMissing = false;
  bool Append = false;
  PieceOptions Pieces;
};

/** Sets how coordinates are rounded. */
void SetPointTolerance(vtkGatunWriter* writer, const std::string& text)
{
  const auto bound = gatun::ParseBound(text);
  if (!bound)
  {
    Refuse("--point-tolerance", text,
      "abs:E with a number E above 0, rel:E with E from 0 to 1, or bits:N with N from 1 to 31");
  }
  gatun::CheckPointBound(*bound);
  writer->SetPointTolerance(static_cast<int>(bound->Kind), bound->Bound);
}

void SetArrayTolerance(vtkGatunWriter* writer, const std::string& text)
{
  const gatun::ArrayError error = gatun::ParseError(text);
  writer->SetArrayTolerance(error.Array.c_str(), static_cast<int>(error.Bound.Kind),
    error.Bound.Bound, error.Bound.KeepZeros);
}

/** Calls a function with the value of an option. Throws UsageError if that is wrong. */
void SetOption(const char* option, const std::function<void()>& set)
{
  try
  {
    set();
  }
  catch (const gatun::Error& error)
  {
    throw UsageError(std::string(option) + ": " + error.what());
  }
}

int OrderOf(const std::string& name)
{
  return name == "points" ? vtkGatunWriter::KEEP_POINTS
    : name == "cells"     ? vtkGatunWriter::KEEP_CELLS
    : name == "all"       ? vtkGatunWriter::KEEP_ALL
                          : vtkGatunWriter::KEEP_NONE;
}

void SetLayers(vtkGatunWriter* writer, const PackOptions& options)
{
  constexpr int most = 4096;
  const ArraySetting choice =
    ParseArraySetting("--layers", *options.Layers, most, "uniform|normal|histogram");
  writer->SetLayers(choice.Name.c_str(), options.LayerComponent, choice.Count.value_or(0),
    choice.Word == "uniform"    ? vtkGatunWriter::LAYERS_UNIFORM
      : choice.Word == "normal" ? vtkGatunWriter::LAYERS_NORMAL
                                : vtkGatunWriter::LAYERS_HISTOGRAM);
}

void PrintSizes(vtkGatunWriter* writer, const PackOptions& options, bool verbose, bool joinsFiles)
{
  const gatun::FileReader file(options.Out);
  const vtkSmartPointer<vtkTable> table = writer->GetStatistics();
  const auto get = [&](const char* name) { return table->GetValueByName(0, name).ToTypeUInt64(); };
  const auto cells = static_cast<double>(get("Cells"));
  const vtkTypeUInt64 steps = get("TimeSteps");
  const vtkTypeUInt64 meshes = get("Meshes");
  fmt::print("{}: {}, {} points{}{}\n", options.Out,
    meshes > 1 ? GroupDigits(get("Cells")) + " cells" : ListCells(file), GroupDigits(get("Points")),
    meshes > 1 ? fmt::format(" of {} meshes", meshes) : "",
    steps > 1 ? fmt::format(", {} time steps", steps) : "");
  const auto print = [cells](const std::string& name, vtkTypeUInt64 bytes)
  {
    if (bytes > 0)
    {
      fmt::print("  {:<14} {:>14} bytes", name, GroupDigits(bytes));
      if (cells > 0)
      {
        fmt::print(" {:>9.3f} bits/cell", 8. * static_cast<double>(bytes) / cells);
      }
      fmt::print("\n");
    }
  };
  print("connectivity", get("ConnectivityBytes"));
  print("points", get("GeometryBytes"));
  print("arrays", get("ArrayBytes"));
  if (verbose)
  {
    const std::vector<std::uint64_t> bytes = file.GetStatistics().ArrayBytes;
    for (std::size_t i = 0; i < bytes.size(); ++i)
    {
      print("  " + MakePrintableLine(file.GetArrays()[i].Name), bytes[i]);
    }
  }
  print("order", get("OrderBytes"));
  print("field data", get("FieldDataBytes"));
  print("hierarchy", get("HierarchyBytes"));
  print("dependencies", get("DependencyBytes"));
  print("base meshes", get("LevelBytes"));
  print("boundary", get("BoundaryBytes"));
  print("other meshes", get("OtherMeshBytes"));
  print("directory", get("DirectoryBytes"));
  print("file", get("FileBytes"));
  if (const vtkTypeUInt64 joined = get("JoinedPoints"); joined > 0 && joinsFiles)
  {
    fmt::print("  {} points that pieces have in common were joined; --keep-apart keeps them\n",
      GroupDigits(joined));
  }
  if (options.PointTolerance)
  {
    fmt::print("  coordinates differ by at most {:.6g}\n",
      table->GetValueByName(0, "PointError").ToDouble());
  }
  if (get("HierarchyBytes") > 0 && get("Points") > 0)
  {
    fmt::print("  the hierarchy takes {:.2f} bits per point\n",
      8. * static_cast<double>(get("HierarchyBytes")) / static_cast<double>(get("Points")));
  }
}

/** Names steps whose times do not ascend. */
void CheckTimes(const Input& input)
{
  const std::vector<double>& times = input.GetTimes();
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    if (!(times[i] > times[i - 1]))
    {
      throw Failure(input.GetName(),
        fmt::format("the times of the steps must ascend: step {} is at {}, and step {} at {}; "
                    "--steps chooses some of them, such as --steps 0:{}",
          i - 1, DescribeNumber(times[i - 1]), i, DescribeNumber(times[i]), i - 1));
    }
  }
}

void Pack(const PackOptions& options, const Settings& settings)
{
  if (ExtensionOf(options.Out) != ".gtn")
  {
    throw UsageError(options.Out + ": the name must end in .gtn");
  }
  vtkNew<vtkGatunWriter> writer;
  if (options.Layers)
  {
    SetLayers(writer, options);
  }
  if (options.PointTolerance)
  {
    SetOption("--point-tolerance", [&] { SetPointTolerance(writer, *options.PointTolerance); });
  }
  for (const std::string& tolerance : options.Tolerances)
  {
    SetOption("--tolerance", [&] { SetArrayTolerance(writer, tolerance); });
  }
  writer->SetProfile(
    options.Profile == "fast" ? vtkGatunWriter::PROFILE_FAST : vtkGatunWriter::PROFILE_SMALL);
  Input input(options.In, options.Input);
  CheckTimes(input);
  CheckWritable(options.Out, options.Overwrite || options.Append);

  writer->SetFileName(options.Out.c_str());
  writer->SetKeepOrder(OrderOf(options.KeepOrder));
  writer->SetChunkSize(options.ChunkSize);
  writer->SetKeyStepInterval(options.KeyStepInterval);
  writer->WriteAllTimeStepsOn();
  writer->SetFillMissingArrays(options.FillMissing);
  writer->SetAppend(options.Append);
  writer->SetHierarchy(options.Dependencies     ? vtkGatunWriter::HIERARCHY_WITH_DEPENDENCIES
      : options.Hierarchy || options.Levels > 0 ? vtkGatunWriter::HIERARCHY_ON
                                                : vtkGatunWriter::HIERARCHY_OFF);
  writer->SetLevels(options.Levels);
  writer->SetWriteBoundary(options.Boundary);
  options.Merges.ApplyWeights(writer.Get());
  if (!SetPieces(writer, input, options.Pieces, settings))
  {
    Progress progress("reading", settings.ShowProgress);
    input.Read(0, progress);
  }
  {
    Progress progress("packing", settings.ShowProgress);
    writer->SetInputConnection(input.GetAlgorithm()->GetOutputPort());
    RunWriter(writer.Get(), input.GetName(), progress);
  }
  CheckMessages(input.GetName(), settings.Quiet);
  if (!settings.Quiet)
  {
    PrintSizes(writer, options, settings.Verbose, input.JoinsFiles());
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddPack(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<PackOptions>();
  CLI::App* command = AddCommand(app, settings, "pack",
    "Write meshes or surfaces to a .gtn file, without loss unless told otherwise. Several files,\n"
    "or one file with time steps, become the time steps of one mesh. Blocks are merged;\n"
    "'Gatun Split Blocks' in ParaView gives them back.",
    "  gtn pack mesh.vtu mesh.gtn\n"
    "  gtn pack --keep-order all --arrays pressure mesh.vtu mesh.gtn\n"
    "  gtn pack --levels 8 --weight pressure mesh.vtu mesh.gtn\n"
    "  gtn pack --layers temperature:8 mesh.vtu mesh.gtn\n"
    "  gtn pack run_0.vtu run_1.vtu run_2.vtu run.gtn\n"
    "  gtn pack run.pvd run.gtn\n"
    "  gtn pack --steps 0:100:10 run.e run.gtn\n"
    "  gtn pack --append run_3.vtu run.gtn\n"
    "  gtn pack --point-tolerance abs:1e-6 surface.stl surface.gtn\n"
    "  gtn pack --tolerance pressure=abs:0.01 --tolerance '*=rel:1e-4' mesh.vtu mesh.gtn\n"
    "  gtn pack --memory 2000 --spill /scratch large.vtu large.gtn\n"
    "  gtn pack -f crash.e crash.gtn\n"
    "  gtn pack --sets crash.e crash.gtn");
  auto* const force = AddForce(command, options->Overwrite);
  command
    ->add_flag("--append", options->Append,
      "Add the time steps to the .gtn file, if it exists. They have to be later than its last one, "
      "and to have the same arrays. Kept order, chunk size and key steps are those of the file; "
      "meshes that do not change are stored once if the other options are the same, too")
    ->excludes(force);
  AddArrays(command, options->Input);
  AddSkip(command, options->Input, "Leave out these point and cell arrays");
  AddSkipMissing(command, options->Input);
  AddSets(command, options->Input);
  AddNoGhosts(command, options->Input,
    "Leave out ghost cells (vtkGhostType) and points that only they use, as --pieces does");
  AddSteps(command, options->Input.Steps);
  command->add_flag("--fill-missing", options->FillMissing,
    "Let arrays come and go with time: a step that lacks an array of another step gets it, with "
    "NaN, or 0 if it is of integers (default: such steps are refused)");
  command
    ->add_option("--keep-order", options->KeepOrder,
      "Order to keep: none, points, cells, or all (points, cells, and the corners of "
      "tetrahedra and triangles and faces of polyhedra; corners of other cells always keep "
      "their order) "
      "(default: none)")
    ->check(CLI::IsMember({ "none", "points", "cells", "all" }))
    ->option_text("WHAT");
  command
    ->add_option("--profile", options->Profile,
      "Optimize the file for reading speed (fast) or for size (small; down to half the space, read "
      "several times slower) (default: fast)")
    ->check(CLI::IsMember({ "fast", "small" }))
    ->option_text("WHAT");
  command
    ->add_option("--chunk-size", options->ChunkSize,
      "Maximum number of cells per chunk, 64 to 1048576, and at most 65535 points; with --profile "
      "small, of tetrahedra that cells can be split into (default: 65536; 131072 for more than one "
      "million, 262144 for more than 10 million; a quarter of that with --layers)")
    ->check(CLI::Range(64, 1048576))
    ->option_text("N");
  command
    ->add_option("--key-step-interval", options->KeyStepInterval,
      "Interval of key steps, which are coded independently of other time steps, 1 to 1000000 "
      "(default: 8)")
    ->check(CLI::Range(1, 1000000))
    ->option_text("N");
  command->add_flag("--hierarchy", options->Hierarchy,
    "Store a hierarchy of edge collapses, so that the mesh can be read and rendered at any level "
    "of detail (see gtn simplify). With --memory or --pieces, the mesh is never in memory as a "
    "whole");
  command
    ->add_option("--levels", options->Levels,
      "Store the hierarchy and up to N coarser meshes, 0 to 64, the first with an eighth of the "
      "points and each further one with half (about, with --memory or --pieces), so that coarse "
      "levels of detail are read fast (default: 0)")
    ->check(CLI::Range(0, 64))
    ->option_text("N");
  command->add_flag("--dependencies", options->Dependencies,
    "Store the hierarchy, and which merges depend on which: some 3 bytes a point. With it, meshes "
    "of more than 4 million tetrahedra can be finer where a view is near; of smaller ones, "
    "readers find it out themselves");
  command->add_flag("--boundary", options->Boundary,
    "Store the boundary of the mesh, too, so that ParaView shows it at once when the mesh is read "
    "on demand");
  AddWeights(command, options->Merges);
  auto* layers = command
                   ->add_option("--layers", options->Layers,
                     "Arrange the chunks by the values of a point array at the first time step, so "
                     "that an isosurface needs few of them. N is the number of layers, 1 to 4096, "
                     "or 0 to choose it (default: 0). SPACING is uniform, normal or histogram "
                     "(default: histogram). Give both if the name of the array has colons")
                   ->option_text("ARRAY[:N][:SPACING]");
  AddComponent(command, "--layer-component", options->LayerComponent,
    "Component for --layers: a number from 0, or magnitude (default: magnitude)")
    ->needs(layers);
  command
    ->add_option("--point-tolerance", options->PointTolerance,
      "Round coordinates: abs:E changes each of them by at most E, above 0, in their units; rel:E "
      "by at most E times the longest side of the bounding box; bits:N gives that side 2^N places, "
      "N from 1 to 31. No cell turns over: where one would, coordinates are finer. Values of "
      "arrays stay (default: none; everything is stored without loss)")
    ->option_text("WHAT");
  command
    ->add_option("--tolerance", options->Tolerances,
      "Let the values of an array differ by at most a bound, NAME=KIND:E. NAME is an array, or * "
      "for all floating-point arrays that are not named. KIND is abs (the difference), rel (by the "
      "range of the component at the time step), pw (by the magnitude of the value), or bits (the "
      "number of significant binary digits to keep, 1 to 52). With ',zeros' at the end, values of "
      "0 stay exact. Ids, NaN and infinities always do. May be repeated (default: none; everything "
      "is stored without loss)")
    ->allow_extra_args(false)
    ->option_text("NAME=KIND:E");
  AddPieceOptions(command, options->Pieces);
  command->add_flag("--keep-apart", options->Input.KeepApart,
    "With --pieces or --memory, do not join the points that several files of a mesh have in "
    "common, "
    "such as those on both sides of a fault (default: points with the same coordinates and values "
    "become one)");
  command->add_flag("--triangles", options->Input.Triangles,
    "Divide the polygons and strips of a surface into triangles, which --hierarchy and --levels "
    "need");
  command->add_flag("--split-cells", options->Input.Split,
    "Split 3D cells into tetrahedra. Nonlinear ones lose the points between their corners, and "
    "cells of a lower dimension are left out");
  auto* files = command->add_option(FilesArgument, options->In,
    std::string("One or more meshes, then the .gtn file to write. Meshes: ") + InputFormats +
      ". Surfaces: " + SurfaceInputFormats);
  files->required();
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      if (options->In.size() < 2)
      {
        throw UsageError("pack takes one or more meshes and then the name of a .gtn file");
      }
      if (options->Merges.AreGiven && !options->Hierarchy && !options->Dependencies &&
        options->Levels == 0)
      {
        throw UsageError("--weight needs --hierarchy, --levels or --dependencies");
      }
      options->Input.InPieces = options->Pieces.AreGiven();
      options->Input.NamesSets = true;
      if (options->Input.KeepApart && !options->Input.InPieces)
      {
        throw UsageError("--keep-apart needs --pieces or --memory: a mesh that is read as a whole "
                         "keeps all points");
      }
      if ((options->FillMissing || options->Append) && options->Input.InPieces)
      {
        throw UsageError((options->Append ? "--append" : "--fill-missing") +
          std::string(" needs the whole mesh, without --pieces and --memory"));
      }
      options->Out = options->In.back();
      options->In.pop_back();
      Pack(*options, settings);
    });
}
}
