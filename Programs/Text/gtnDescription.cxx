// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnDescription.h"

#include "gtnText.h"

#include <fmt/core.h>

#include <algorithm>

namespace gtn
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
        text += table.Columns[i].IsNumber ? fmt::format("  {:>{}}", textOf(i), widths[i])
                                          : fmt::format("  {:<{}}", textOf(i), widths[i]);
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

} // anonymous namespace

//------------------------------------------------------------------------------
Entry::Entry(const std::string& name)
  : Entry(name, Printable(name))
{
}

//------------------------------------------------------------------------------
Entry::Entry(std::uint64_t number)
  : Entry(Json::Value(Json::UInt64{ number }), Grouped(number))
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
      text += fmt::format("  {:<16} {}\n", field.Title, field.Content.Text);
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
