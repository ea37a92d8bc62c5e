// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnXMLKeys.h"

#include "vtkDataArray.h"
#include "vtkInformationKeyLookup.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationStringVectorKey.h"
#include "vtkQuadratureSchemeDefinition.h"
#include "vtkXMLDataElement.h"

#include <string_view>

namespace gtn
{
//------------------------------------------------------------------------------
void MakeUnknownKeys(vtkXMLDataElement* element)
{
  // VTK makes these when they are first used.
  vtkDataArray::UNITS_LABEL();
  vtkAbstractArray::GUI_HIDE();
  vtkQuadratureSchemeDefinition::DICTIONARY();
  vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME();
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const nested = element->GetNestedElement(i);
    const char* const name = nested->GetAttribute("name");
    const char* const location = nested->GetAttribute("location");
    if (std::string_view(nested->GetName()) != "InformationKey")
    {
      MakeUnknownKeys(nested);
    }
    else if (name && location && !vtkInformationKeyLookup::Find(name, location))
    {
      if (nested->GetAttribute("length"))
      {
        vtkInformationStringVectorKey::MakeKey(name, location);
      }
      else
      {
        vtkInformationStringKey::MakeKey(name, location);
      }
    }
  }
}
}
