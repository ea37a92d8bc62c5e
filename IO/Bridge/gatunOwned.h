// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunOwned_h
#define gatunOwned_h

#include "vtkSmartPointer.h"

namespace gatun
{
/** A property that is an object and never null. */
template <typename Object>
class Owned
{
public:
  /** Null sets a new object. Returns whether the object is another one than before. */
  bool Set(Object* object)
  {
    if (object == this->Pointer)
    {
      return false;
    }
    this->Pointer = object;
    if (!object)
    {
      this->Pointer = vtkSmartPointer<Object>::New();
    }
    return true;
  }

  Object* Get() const { return this->Pointer; }

private:
  vtkSmartPointer<Object> Pointer = vtkSmartPointer<Object>::New();
};
}

#endif
