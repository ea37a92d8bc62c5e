// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunOpenFile.h"

#include "gatunFieldData.h"

#include <utility>

using namespace gatun;

/** The field data of a step. */
struct gatun_fields
{
  explicit gatun_fields(FieldData data)
    : Data(std::move(data))
  {
    for (const auto& array : this->Data)
    {
      this->ComponentNames.emplace_back(array.ComponentNames);
      this->Keys.emplace_back(array.Keys);
      this->Texts.emplace_back(array.Texts);
      auto& lengths = this->Lengths.emplace_back();
      for (const auto& text : array.Texts)
      {
        lengths.push_back(text.size());
      }
    }
  }

  const FieldData Data;
  std::vector<TextList> ComponentNames;
  std::vector<KeyList> Keys;
  std::vector<TextList> Texts;
  std::vector<std::vector<std::uint64_t>> Lengths; // of the texts
};

gatun_status gatun_get_fields(
  gatun_file* file, uint64_t step, gatun_fields** fields, uint32_t* count)
{
  return Guard(
    [&]
    {
      NeedPointers(file, fields, count);
      const auto place = file->Find(step);
      const auto& mesh = *place.Mesh->GetFile();
      auto made = std::make_unique<gatun_fields>(
        place.Step < mesh.GetNumberOfSteps() ? mesh.GetFieldData(place.Step) : FieldData());
      *count = static_cast<std::uint32_t>(made->Data.size());
      *fields = made.release();
    });
}

gatun_status gatun_get_field(gatun_fields* fields, uint32_t index, gatun_field* field)
{
  return Guard(
    [&]
    {
      NeedPointers(fields, field);
      Need(index < fields->Data.size(), "there is no such field array");
      const auto& from = fields->Data[index];
      gatun_field own{};
      own.name = from.Name.c_str();
      own.type = from.IsText ? gatun_type{} : static_cast<gatun_type>(from.Type);
      own.components = from.Components;
      own.vtk_type = from.VTKType;
      own.component_names = fields->ComponentNames[index].Get();
      own.keys = fields->Keys[index].Get();
      own.key_count = fields->Keys[index].GetCount();
      own.count = from.IsText ? from.Texts.size() : from.Values.size() / SizeOf(from.Type);
      own.values = from.IsText ? nullptr : from.Values.data();
      own.texts = from.IsText ? fields->Texts[index].Get() : nullptr;
      own.text_bytes = from.IsText ? fields->Lengths[index].data() : nullptr;
      Give(own, field);
    });
}

void gatun_free_fields(gatun_fields* fields)
{
  delete fields;
}
