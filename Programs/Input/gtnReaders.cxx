// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnReaders.h"

#include "gtnFailure.h"
#include "gtnFileKind.h"
#include "gtnFoam.h"
#include "gtnFormats.h"
#include "gtnGridReader.h"
#include "gtnLegacyReader.h"
#include "gtnLibrary.h"
#include "gtnMeshio.h"
#include "gtnMessages.h"
#include "gtnObj.h"
#include "gtnPly.h"
#include "gtnReadable.h"
#include "gtnScene.h"
#include "gtnScratch.h"
#include "gtnSurfaceFileReader.h"
#include "gtnText.h"
#include "gtnXMLPieces.h"

#include "gatunDescriptionText.h"
#include "gatunFileReader.h"
#include "vtkGatunHartleyReader.h"
#include "vtkGatunReader.h"
#include "vtkGatunSurfaceReader.h"

#include "vtkGLTFReader.h"
#include "vtkGenericEnSightReader.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkSLCReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPartitionedDataSetCollectionReader.h"

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace gtn
{
namespace
{

bool IsOneOf(const std::string& extension, std::initializer_list<std::string_view> list)
{
  return std::find(list.begin(), list.end(), extension) != list.end();
}

template <typename Reader>
vtkSmartPointer<vtkAlgorithm> Make(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeSurfaceFileReader(const std::string& file, SurfaceFunction read)
{
  vtkNew<SurfaceFileReader> reader;
  reader->SetFile(file, read);
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeGatun(const std::string& file)
{
  return gatun::FileReader::IsSurfaceFile(file) ? Make<vtkGatunSurfaceReader>(file)
                                                : Make<vtkGatunReader>(file);
}

/** All meshes of a scene together, at their places. */
vtkSmartPointer<vtkAlgorithm> MakeGLTF(const std::string& file)
{
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<SceneMerger> together;
  together->SetInputConnection(reader->GetOutputPort());
  return together;
}

vtkSmartPointer<vtkAlgorithm> MakeLegacy(const std::string& file)
{
  vtkNew<LegacyReader> reader;
  reader->SetFileName(file.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

// The Exodus library prints, at length, what it thinks of other files.
void CheckIsNetCDF(const std::string& file)
{
  if (!IsNetCDF(file))
  {
    throw Failure(file, "is not an Exodus file");
  }
}

// So does the library of MetaImage files.
void CheckIsMetaImage(const std::string& file)
{
  std::string start(4096, '\0');
  std::ifstream(file, std::ios::binary)
    .read(start.data(), static_cast<std::streamsize>(start.size()));
  if (start.find("NDims") == start.npos || start.find("DimSize") == start.npos)
  {
    throw Failure(file, "is not a MetaImage file");
  }
}

vtkSmartPointer<vtkAlgorithm> MakeEnSight(const std::string& file)
{
  vtkNew<vtkGenericEnSightReader> reader;
  reader->SetCaseFileName(file.c_str());
  reader->ReadAllVariablesOn();
  return reader;
}

// The CGNS library ends the program if it cannot open a file.
void CheckIsCGNS(const std::string& file)
{
  if (!HasCGNSContent(file))
  {
    throw Failure(file, "is not a CGNS file");
  }
}

vtkSmartPointer<vtkAlgorithm> MakeCGNS(const std::string& file, bool sets)
{
  const auto make = GetFormatFunctions().MakeCGNS;
  if (!make)
  {
    throw Failure(file, "this gtn was built with a VTK that does not read CGNS files");
  }
  CheckIsCGNS(file);
  GuardExit(file);
  return make(file, sets);
}

} // anonymous namespace

//------------------------------------------------------------------------------
const FormatFunctions& GetFormatFunctions()
{
  static const void* const functions =
    LoadLibrary("gtnFormats", FormatFunctionsName, "read or write Exodus, CGNS and HDF files");
  return *static_cast<const FormatFunctions*>(functions);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& file, bool sets)
{
  const std::string extension = ExtensionOf(file);
  CheckXMLType(file);
  if (extension == ".gtn")
  {
    return MakeGatun(file);
  }
  if (extension == ".vtu")
  {
    return MakeGridReader(file);
  }
  if (IsOneOf(extension, { ".vtm", ".vtmb", ".vti", ".vts", ".vtr", ".pvti", ".pvts", ".pvtr" }))
  {
    return Make<vtkXMLGenericDataObjectReader>(file);
  }
  if (extension == ".vtpc")
  {
    return Make<vtkXMLPartitionedDataSetCollectionReader>(file);
  }
  if (extension == ".vtk")
  {
    return MakeLegacy(file);
  }
  if (IsExodus(file))
  {
    CheckIsNetCDF(file);
    return GetFormatFunctions().MakeExodus(file, sets);
  }
  if (IsOneOf(extension, { ".case", ".encas" }))
  {
    return MakeEnSight(file);
  }
  if (extension == ".foam")
  {
    return MakeFoamReader(file, sets);
  }
  if (extension == ".cgns")
  {
    return MakeCGNS(file, sets);
  }
  if (IsOneOf(extension, { ".vtkhdf", ".hdf" }))
  {
    return GetFormatFunctions().MakeHDF(file);
  }
  if (IsMeshioFile(file))
  {
    return MakeMeshioReader(file);
  }
  return MakeSurfaceReader(file);
}

//------------------------------------------------------------------------------
std::vector<std::string> ListSets(const std::string& file)
{
  std::vector<std::string> names;
  if (IsExodus(file))
  {
    CheckReadable(file);
    GetFormatFunctions().ListExodusSets(MakeReader(file, false), names);
  }
  else if (ExtensionOf(file) == ".foam")
  {
    CheckReadable(file);
    names = ListFoamPatches(file);
  }
  TakeErrors(); // reading the file reports them again
  TakeWarnings();
  return names;
}

//------------------------------------------------------------------------------
bool IsSurfaceFile(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  if (extension == ".gtn")
  {
    return gatun::FileReader::IsSurfaceFile(file);
  }
  if (extension == ".vtk")
  {
    vtkNew<vtkGenericDataObjectReader> reader;
    reader->SetFileName(file.c_str());
    const bool isSurface = reader->ReadOutputType() == VTK_POLY_DATA;
    TakeErrors(); // reading the file reports them again
    return isSurface;
  }
  return IsOneOf(extension, { ".vtp", ".pvtp", ".stl", ".ply", ".obj", ".glb", ".gltf" });
}

//------------------------------------------------------------------------------
std::string DescribeFlatCells(const std::string& cells)
{
  return "has no 3D cells, only " + cells +
    "; save these as a surface (.vtp), such as by Extract Surface of ParaView, to draw or simplify "
    "them";
}

//------------------------------------------------------------------------------
std::string DescribeSurface()
{
  return "is a surface (vtkPolyData), without 3D cells; gtn render and gtn simplify take surfaces";
}

//------------------------------------------------------------------------------
void RequireGrid(const gatun::FileReader& file)
{
  if (file.IsSurface())
  {
    throw Failure(file.GetPath(), DescribeSurface());
  }
  if (file.GetNumberOfTets() == 0 && file.GetNumberOfCells() > 0)
  {
    std::vector<std::string> cells;
    for (const gatun::CellTypeCount& type : file.GetCellTypes())
    {
      cells.push_back(std::to_string(type.Cells) + " " + gatun::NameOfCellType(type.Type));
    }
    throw Failure(file.GetPath(), DescribeFlatCells(Join(cells)));
  }
}

//------------------------------------------------------------------------------
bool IsExodus(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  // Others are known by their names: a file of Exodus may be called mesh.e.4.0 or mesh.e-s002.
  const std::initializer_list<std::string_view> others{ ".gtn", ".vtu", ".pvtu", ".vtp", ".pvtp",
    ".vtm", ".vtmb", ".vti", ".vts", ".vtr", ".pvti", ".pvts", ".pvtr", ".vtpc", ".vtk", ".case",
    ".encas", ".foam", ".cgns", ".vtkhdf", ".hdf", ".stl", ".ply", ".obj", ".glb", ".gltf", ".pvd",
    ".series" };
  return IsOneOf(extension, { ".e", ".exo", ".ex2", ".exii", ".g", ".gen" }) ||
    (!IsOneOf(extension, others) && HasExodusContent(file));
}

//------------------------------------------------------------------------------
std::size_t CountExodusBlocks(const std::string& file, bool sets)
{
  CheckReadable(file);
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(file, sets);
  CheckMessages(file, true);
  return static_cast<std::size_t>(GetFormatFunctions().CountExodusBlocks(reader));
}

//------------------------------------------------------------------------------
std::uint64_t EstimateExodusBlock(const std::string& file, bool sets)
{
  CheckReadable(file);
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(file, sets);
  CheckMessages(file, true);
  return GetFormatFunctions().EstimateExodusBlock(reader);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeExodusReader(
  const std::string& file, bool sets, std::size_t number)
{
  CheckReadable(file);
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(file, sets);
  CheckMessages(file, true);
  GetFormatFunctions().SelectExodusBlock(reader, static_cast<int>(number));
  return reader;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeVolumeReader(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  CheckXMLType(file);
  if (extension == ".ghv")
  {
    return Make<vtkGatunHartleyReader>(file);
  }
  if (extension == ".vti")
  {
    return Make<vtkXMLImageDataReader>(file);
  }
  if (extension == ".vtk")
  {
    return MakeLegacy(file);
  }
  if (extension == ".nii" || (extension == ".gz" && ExtensionOf(StemOf(file)) == ".nii"))
  {
    return Make<vtkNIFTIImageReader>(file);
  }
  if (IsOneOf(extension, { ".mha", ".mhd" }))
  {
    CheckIsMetaImage(file);
    return Make<vtkMetaImageReader>(file);
  }
  if (IsOneOf(extension, { ".nrrd", ".nhdr" }))
  {
    CheckNrrd(file);
    return Make<vtkNrrdReader>(file);
  }
  if (extension == ".slc")
  {
    return Make<vtkSLCReader>(file);
  }
  if (IsOneOf(extension, { ".vtkhdf", ".hdf" }))
  {
    return GetFormatFunctions().MakeHDF(file);
  }
  return nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeSurfaceReader(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  CheckXMLType(file);
  if (extension == ".stl")
  {
    return Make<vtkSTLReader>(file);
  }
  if (extension == ".ply")
  {
    return MakeSurfaceFileReader(file, ReadPly);
  }
  if (extension == ".obj")
  {
    return MakeSurfaceFileReader(file, ReadObj);
  }
  if (IsOneOf(extension, { ".glb", ".gltf" }))
  {
    return MakeGLTF(file);
  }
  if (extension == ".vtp")
  {
    return Make<XMLSurfaceReader>(file);
  }
  if (extension == ".vtk")
  {
    return MakeLegacy(file);
  }
  if (extension == ".gtn")
  {
    return MakeGatun(file);
  }
  return nullptr;
}
}
