// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDescription.h"

#include "gatunDescriptionText.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{

// Spaces at the end of a line are of no use.
void EndLine(std::string& text)
{
  text.erase(text.find_last_not_of(' ') + 1);
  text += '\n';
}

std::string TextOf(const Table& table)
{
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.Columns.size(); ++i)
  {
    const char* const title = table.Columns[i].Title;
    std::size_t width = title ? std::string(title).size() : 0;
    for (const std::vector<Entry>& row : table.Rows)
    {
      width = std::max(width, row[i].Text.size());
    }
    widths.push_back(width);
  }
  std::string text = table.Title + "\n";
  const auto addLine = [&](const auto& textOf)
  {
    for (std::size_t i = 0; i < table.Columns.size(); ++i)
    {
      if (table.Columns[i].Title)
      {
        const std::string cell = textOf(i);
        const std::string space(widths[i] - std::min(widths[i], cell.size()), ' ');
        text += "  " + (table.Columns[i].IsNumber ? space + cell : cell + space);
      }
    }
    EndLine(text);
  };
  addLine([&](std::size_t i) { return table.Columns[i].Title; });
  for (const std::vector<Entry>& row : table.Rows)
  {
    addLine([&](std::size_t i) { return row[i].Text; });
  }
  return text;
}

Json::Value JsonOf(const Table& table)
{
  Json::Value json(table.IsObject ? Json::objectValue : Json::arrayValue);
  for (const std::vector<Entry>& row : table.Rows)
  {
    Json::Value& object = table.IsObject ? json[row[0].Value.asString()] : json.append({});
    for (std::size_t i = table.IsObject ? 1 : 0; i < table.Columns.size(); ++i)
    {
      if (table.Columns[i].Key)
      {
        object[table.Columns[i].Key] = row[i].Value;
      }
    }
  }
  return json;
}

// Infinity would be written as 1e+9999, which some programs refuse.
Json::Value WithFiniteNumbers(Json::Value value)
{
  if (value.isDouble() && !std::isfinite(value.asDouble()))
  {
    return {};
  }
  if (value.isArray() || value.isObject())
  {
    for (Json::Value& part : value)
    {
      part = WithFiniteNumbers(std::move(part));
    }
  }
  return value;
}

std::string Written(const Json::Value& value, const char* indentation)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = indentation;
  builder["enableYAMLCompatibility"] = true; // a colon, and no space before it
  return Json::writeString(builder, WithFiniteNumbers(value));
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::string WriteJson(const Json::Value& value)
{
  return Written(value, "  ") + "\n";
}

//------------------------------------------------------------------------------
std::string WriteJsonLine(const Json::Value& value)
{
  return Written(value, "");
}

//------------------------------------------------------------------------------
Entry::Entry(const std::string& name)
  : Entry(name, MakePrintableLine(name))
{
}

//------------------------------------------------------------------------------
Entry::Entry(std::uint64_t number)
  : Entry(Json::Value(Json::UInt64{ number }), GroupDigits(number))
{
}

//------------------------------------------------------------------------------
void Description::Add(const char* key, const char* title, Entry entry)
{
  this->Fields.push_back({ key, title, std::move(entry) });
}

//------------------------------------------------------------------------------
Description& Description::AddPart(const char* key, std::string title)
{
  return this->Parts.emplace_back(key, Description(std::move(title))).second;
}

//------------------------------------------------------------------------------
std::string Description::GetText() const
{
  std::string text = this->Title + "\n";
  for (const Field& field : this->Fields)
  {
    if (field.Title)
    {
      std::string title = field.Title;
      title.resize(std::max<std::size_t>(title.size(), 16), ' ');
      text += "  " + title + " " + field.Content.Text + "\n";
    }
  }
  for (const Table& table : this->Tables)
  {
    if (!table.Rows.empty())
    {
      text += '\n';
      text += TextOf(table);
    }
  }
  for (const auto& [key, part] : this->Parts)
  {
    text += '\n';
    text += part.GetText();
  }
  return text;
}

//------------------------------------------------------------------------------
Json::Value Description::GetJson() const
{
  Json::Value json(Json::objectValue);
  for (const Field& field : this->Fields)
  {
    if (field.Key)
    {
      json[field.Key] = field.Content.Value;
    }
  }
  for (const Table& table : this->Tables)
  {
    if (table.Key)
    {
      json[table.Key] = JsonOf(table);
    }
  }
  for (const auto& [key, part] : this->Parts)
  {
    json[key] = part.GetJson();
  }
  return json;
}
}
