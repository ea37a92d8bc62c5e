// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnXMLPieces_h
#define gtnXMLPieces_h

// The pieces of .vtu and .vtp files, without their values.

#include "gtnXMLKeys.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <string>
#include <vector>

class vtkXMLDataElement;
class vtkXMLDataParser;

namespace gtn
{
/** An array that a file declares. */
struct XMLArrayForm
{
  int Association = 0; ///< vtkDataObject::POINT or CELL
  std::string Name;
  int Type = 0; ///< a type of VTK, or 0 if it is none
  int Components = 1;
};

/** What a file declares of its points and arrays. */
struct XMLForm
{
  bool IsEmpty = true; ///< without points and cells
  int PointType = 0;   ///< a type of VTK, or 0 without points
  std::vector<XMLArrayForm> Arrays;
};

/** Reads a file of XML. Returns its root, or null; parser keeps it. Throws Failure. */
vtkXMLDataElement* ParseXML(const std::string& file, vtkXMLDataParser* parser);

/** The array of a form with the association and name of another one, or null. */
const XMLArrayForm* FindSame(const XMLForm& form, const XMLArrayForm& array);

/** Reads that of the first piece with points or cells in a .vtu or .vtp file; an empty form of
 * other files. Throws Failure. */
XMLForm ReadXMLForm(const std::string& file);

/** Reads that of all pieces of a .pvtu or .pvtp file, as the file declares it. list: the element
 * with the pieces. */
XMLForm ReadListForm(vtkXMLDataElement* list);

/** The name of a type of VTK in such files, such as Float32. */
std::string NameOfXMLType(int type);

/** Takes empty pieces out of the element of a mesh, as VTK's readers take the types of all pieces
 * from the first one. If all are empty, the first one stays and gets an array of points. Of several
 * time steps, the arrays of one stay: VTK 9.6 takes those of the first step with each name. Returns
 * what is wrong with the other pieces: one has an array of another type than the first one, which
 * VTK's readers would take for that type. */
std::string PreparePieces(vtkXMLDataElement* mesh, int step);

/** The index of a requested time among the time steps of an output. */
int FindRequestedStep(vtkInformation* outInfo);

/** A reader of VTK that reads empty pieces, too, and refuses pieces that differ in their types. Of
 * several time steps in a file, each has a reader of its own: VTK 9.1 appends the cells of each
 * step to those of the one before. */
template <typename Reader>
class XMLPieceReader : public Reader
{
protected:
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override
  {
    vtkInformation* const info = outputVector->GetInformationObject(0);
    auto* const step = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    if (this->IsOfStep || this->GetNumberOfTimeSteps() < 2 || !info->Has(step))
    {
      return this->Reader::RequestData(request, inputVector, outputVector);
    }
    auto fresh = vtk::TakeSmartPointer(this->NewInstance());
    static_cast<XMLPieceReader*>(fresh.Get())->IsOfStep = true;
    static_cast<XMLPieceReader*>(fresh.Get())->Step = FindRequestedStep(info);
    fresh->SetFileName(this->GetFileName());
    fresh->UpdateInformation();
    fresh->UpdateTimeStep(info->Get(step));
    vtkDataObject* const output = vtkDataObject::GetData(outputVector);
    output->ShallowCopy(fresh->GetOutputDataObject(0));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), info->Get(step));
    return fresh->GetErrorCode() == 0 ? 1 : 0;
  }

  int ReadPrimaryElement(vtkXMLDataElement* mesh) override
  {
    MakeUnknownKeys(mesh);
    const std::string problem = PreparePieces(mesh, this->Step);
    if (!problem.empty())
    {
      vtkErrorWithObjectMacro(this, << problem);
      return 0;
    }
    return this->Reader::ReadPrimaryElement(mesh);
  }

private:
  bool IsOfStep = false; // the reader of one time step
  int Step = 0;
};

class XMLSurfaceReader : public XMLPieceReader<vtkXMLPolyDataReader>
{
public:
  static XMLSurfaceReader* New();
  vtkTypeMacro(XMLSurfaceReader, vtkXMLPolyDataReader);
};
}

#endif
