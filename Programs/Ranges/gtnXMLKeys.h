// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnXMLKeys_h
#define gtnXMLKeys_h

// Information keys in VTK's XML files that only the program that wrote them defines.

class vtkXMLDataElement;

namespace gtn
{
/** Makes keys of texts for those in an element that VTK does not know; it would leave them out. */
void MakeUnknownKeys(vtkXMLDataElement* element);
}

#endif
