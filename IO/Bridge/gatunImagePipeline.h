// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunImagePipeline_h
#define gatunImagePipeline_h

#include "vtkCompositeDataPipeline.h"
#include "vtkDataObject.h"

namespace gatun
{
/**
 * The executive of algorithms that render images. If the upstream pipeline fails, VTK does not run
 * the algorithm, which would keep its previous image. This executive releases it.
 */
class ImagePipeline : public vtkCompositeDataPipeline
{
public:
  vtkTypeMacro(ImagePipeline, vtkCompositeDataPipeline);

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    if (this->Superclass::ProcessRequest(request, inputs, outputs))
    {
      return 1;
    }
    if (vtkDataObject* const image = this->GetOutputData(0))
    {
      image->ReleaseData();
    }
    this->NoteFailure();
    return 0;
  }

protected:
  /** Gives the algorithm an error code if it has none. */
  virtual void NoteFailure() = 0;
};
}

#endif
