// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayChoice.h"

namespace gatun
{
//------------------------------------------------------------------------------
void ArrayChoice::SetArrays(const std::vector<std::string>& names)
{
  for (int i = 0; i < this->Selection->GetNumberOfArrays(); ++i)
  {
    this->Remembered[this->Selection->GetArrayName(i)] = this->Selection->GetArraySetting(i) != 0;
  }
  std::vector<const char*> pointers;
  pointers.reserve(names.size());
  for (const std::string& name : names)
  {
    pointers.push_back(name.c_str());
  }
  // None of these touches the modification time, as the arrays of a file are not a choice.
  this->Selection->SetArrays(pointers.data(), static_cast<int>(pointers.size()));
  for (const std::string& name : names)
  {
    const auto known = this->Remembered.find(name);
    if (known != this->Remembered.end() &&
      known->second != (this->Selection->ArrayIsEnabled(name.c_str()) != 0))
    {
      this->Selection->RemoveArrayByName(name.c_str());
      this->Selection->AddArray(name.c_str(), known->second);
    }
  }
}

//------------------------------------------------------------------------------
bool ArrayChoice::Wants(const std::string& name) const
{
  return name.empty() || this->Selection->ArrayIsEnabled(name.c_str());
}
}
