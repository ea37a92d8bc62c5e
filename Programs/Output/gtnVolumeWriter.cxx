// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnVolumeWriter.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnText.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkMetaImageWriter.h"
#include "vtkNIFTIImageWriter.h"
#include "vtkNew.h"
#include "vtkStructuredPointsWriter.h"
#include "vtkXMLImageDataWriter.h"

namespace gtn
{
const char* const VolumeOutputFormats = ".vti .vtk .nii .nii.gz .mha";

namespace
{

bool IsNifti(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".nii" || (extension == ".gz" && ExtensionOf(StemOf(file)) == ".nii");
}

// Runs one of VTK's writers.
template <typename Writer>
void Run(Writer* writer, vtkImageData* volume, const std::string& file, Progress& progress)
{
  writer->SetInputData(volume);
  writer->SetFileName(file.c_str());
  progress.Watch(writer);
  writer->Write();
  CheckInterrupt();
  CheckWritten(writer, true, file);
}

void WriteFile(vtkImageData* volume, const std::string& file, Progress& progress)
{
  if (IsNifti(file))
  {
    vtkNew<vtkNIFTIImageWriter> writer;
    Run(writer.Get(), volume, file, progress);
  }
  else if (ExtensionOf(file) == ".mha")
  {
    vtkNew<vtkMetaImageWriter> writer;
    Run(writer.Get(), volume, file, progress);
  }
  else if (ExtensionOf(file) == ".vtk")
  {
    vtkNew<vtkStructuredPointsWriter> writer;
    writer->SetFileTypeToBinary();
    Run(writer.Get(), volume, file, progress);
  }
  else
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetHeaderTypeToUInt64();
    writer->SetCompressorTypeToZLib();
    Run(writer.Get(), volume, file, progress);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
bool IsVolumeOutput(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".vti" || extension == ".vtk" || extension == ".mha" || IsNifti(file);
}

//------------------------------------------------------------------------------
void WriteVolume(vtkImageData* volume, const std::string& file, Progress& progress)
{
  TemporaryFile temporary(file);
  try
  {
    WriteFile(volume, temporary.GetName(), progress);
  }
  catch (const Failure& failure)
  {
    TakeErrors();
    throw Failure(file, failure.what());
  }
  CheckMessages(file, true);
  temporary.Commit();
}
}
