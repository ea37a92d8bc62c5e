// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunPVWriter
 * @brief Writes meshes for ParaView's Save Data, on all processes of the data server.
 *
 * Differs from vtkGatunWriter in three ways. Its Controller is the global one: on several
 * processes, each one writes what it has into the one file. A hierarchy and layers, which need the
 * whole mesh, are then added by the first process, which has to have the memory for it; a file
 * without them is there meanwhile, whose name ends with ".parts". And it can write the time steps
 * as a series of files.
 *
 * @sa vtkGatunWriter vtkGatunPVMergeBlocks
 */

#ifndef vtkGatunPVWriter_h
#define vtkGatunPVWriter_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkGatunWriter.h"

#include <string> // For std::string

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class VTKGATUNPARAVIEW_EXPORT vtkGatunPVWriter : public vtkGatunWriter
{
public:
  static vtkGatunPVWriter* New();
  vtkTypeMacro(vtkGatunPVWriter, vtkGatunWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to write each time step into a file of its own. The number of the step, from 0, stands
   * in front of the extension: mesh_0.gtn, mesh_1.gtn, and so on. No effect with WriteAllTimeSteps,
   * or without time steps. Default: off.
   */
  vtkSetMacro(WriteTimeSteps, bool);
  vtkGetMacro(WriteTimeSteps, bool);
  vtkBooleanMacro(WriteTimeSteps, bool);
  ///@}

  ///@{
  /**
   * The first and the last time step of a series of files, from 0, and the interval. If the last
   * one is less than the first, all steps from there on. Default: 0, -1, 1.
   */
  vtkSetClampMacro(MinTimeStep, int, 0, VTK_INT_MAX);
  vtkGetMacro(MinTimeStep, int);
  vtkSetClampMacro(MaxTimeStep, int, -1, VTK_INT_MAX);
  vtkGetMacro(MaxTimeStep, int);
  vtkSetClampMacro(TimeStepStride, int, 1, VTK_INT_MAX);
  vtkGetMacro(TimeStepStride, int);
  ///@}

  ///@{
  /**
   * What SetLayers of the superclass takes, one by one. "(none)", the choice in the panel, is no
   * array.
   */
  void SetLayerArray(const char* name);
  void SetLayerComponent(int component);
  void SetNumberOfLayers(int number);
  void SetLayerSpacing(int spacing);
  ///@}

  ///@{
  /**
   * Tolerances as texts: "NAME=abs:E", "NAME=rel:E", "NAME=pw:E" or "NAME=bits:N" of an array, with
   * ",zeros" at the end if values of 0 stay exact; "abs:E", "rel:E" or "bits:N" of coordinates, and
   * an empty text or "none" for none. Another text is an error.
   */
  void AddArrayToleranceText(const char* text);
  void SetPointToleranceText(const char* text);
  vtkGetMacro(PointToleranceText, std::string);
  ///@}

  /**
   * Writes the file, or the series. A series ends at the first file that fails; those before it
   * remain. Returns 1 on success.
   */
  int Write() override;

protected:
  vtkGatunPVWriter();
  ~vtkGatunPVWriter() override;

  std::string PointToleranceText;
  bool WriteTimeSteps = false;
  int MinTimeStep = 0;
  int MaxTimeStep = -1;
  int TimeStepStride = 1;

private:
  int WriteFile();
  int WriteWhole(const std::string& name);
  int WriteSeries(const std::string& name);

  vtkGatunPVWriter(const vtkGatunPVWriter&) = delete;
  void operator=(const vtkGatunPVWriter&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
