// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnFoam.h"

#include "gtnFailure.h"
#include "gtnMessages.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenFOAMReader.h"

#include <filesystem>
#include <regex>
#include <string_view>
#include <system_error>

namespace gtn
{
namespace
{

void CheckIsReconstructed(const std::string& file)
{
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(file).parent_path();
  std::error_code error;
  if (!fs::exists(folder / "constant" / "polyMesh", error) &&
    fs::exists(folder / "processor0", error))
  {
    throw Failure(file,
      "is a decomposed OpenFOAM case, whose mesh is in the folders processor0, ...; make it one "
      "mesh with reconstructPar (or reconstructParMesh) first");
  }
}

// VTK 9.6 never decomposes polyhedra.
template <typename Reader>
void KeepPolyhedra(Reader* reader)
{
  if constexpr (requires { reader->DecomposePolyhedraOff(); })
  {
    reader->DecomposePolyhedraOff();
  }
}

/** Goes on without the fields that cannot be read, with a warning. */
class FoamReader : public vtkOpenFOAMReader
{
public:
  static FoamReader* New();
  vtkTypeMacro(FoamReader, vtkOpenFOAMReader);

protected:
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override
  {
    const int result = this->Superclass::RequestData(request, inputVector, outputVector);
    auto* const blocks = vtkMultiBlockDataSet::GetData(outputVector);
    const bool hasMesh = result != 0 && blocks && blocks->GetNumberOfPoints() > 0;
    for (const std::string& error : TakeErrors())
    {
      const std::string field = hasMesh ? FindField(error) : std::string();
      if (field.empty())
      {
        vtkErrorMacro(<< error);
      }
      else
      {
        vtkWarningMacro(<< "the field '" << field
                        << "' is left out, which VTK does not read: " << error);
      }
    }
    return result;
  }

private:
  // The name of the file of a field that a message names; those of the mesh are in polyMesh.
  static std::string FindField(const std::string& error)
  {
    std::smatch found;
    const bool isOfFile = std::regex_search(error, found, std::regex(R"( of (.*/([^/:]+)): )"));
    return isOfFile && found[1].str().find("/polyMesh/") == std::string::npos ? found[2].str()
                                                                              : std::string();
  }
};
vtkStandardNewMacro(FoamReader);

// The file is empty; the case is in the folder around it.
vtkSmartPointer<FoamReader> MakeFoam(const std::string& file, bool sets)
{
  CheckIsReconstructed(file);
  auto reader = vtkSmartPointer<FoamReader>::New();
  reader->SetFileName(file.c_str());
  KeepPolyhedra(reader.Get());
  reader->CreateCellToPointOff();
  reader->CacheMeshOff();
  reader->UpdateInformation();
  reader->DisableAllPatchArrays();
  for (int i = 0; i < reader->GetNumberOfPatchArrays(); ++i)
  {
    const char* const name = reader->GetPatchArrayName(i);
    reader->SetPatchArrayStatus(name, sets || std::string_view(name) == "internalMesh" ? 1 : 0);
  }
  reader->EnableAllCellArrays();
  reader->EnableAllPointArrays();
  return reader;
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeFoamReader(const std::string& file, bool sets)
{
  return MakeFoam(file, sets);
}

//------------------------------------------------------------------------------
std::vector<std::string> ListFoamPatches(const std::string& file)
{
  const vtkSmartPointer<FoamReader> reader = MakeFoam(file, false);
  std::vector<std::string> names;
  for (int i = 0; i < reader->GetNumberOfPatchArrays(); ++i)
  {
    names.emplace_back(reader->GetPatchArrayName(i));
  }
  std::erase(names, "internalMesh");
  return names;
}
}
