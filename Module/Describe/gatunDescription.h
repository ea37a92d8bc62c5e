// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunDescription_h
#define gatunDescription_h

// A description of a file that is written once and printed in two ways: as text for people and as
// JSON.

#include "gatunExport.h" // For export macro

#include <json/json.h>

#include <cstdint>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace gatun
{
/** The indented text of a value, or the text on one line without a line break at its end.
 *
 * The text is ASCII: jsoncpp escapes all other characters, so that it is JSON whatever the bytes of
 * a string are. Numbers have 17 digits and read back as the same number. Numbers that are not
 * finite become null. */
GATUN_EXPORT std::string WriteJson(const Json::Value& value);
GATUN_EXPORT std::string WriteJsonLine(const Json::Value& value);

/** An array of the elements of a range, which may be empty. */
template <typename Elements>
Json::Value MakeJsonArray(const Elements& elements)
{
  Json::Value array(Json::arrayValue);
  for (const auto& element : elements)
  {
    array.append(element);
  }
  return array;
}

/** A value, and its text for people. */
struct GATUN_EXPORT Entry
{
  Entry(Json::Value value, std::string text)
    : Value(std::move(value))
    , Text(std::move(text))
  {
  }
  explicit Entry(const std::string& name);
  explicit Entry(std::uint64_t number);

  Json::Value Value;
  std::string Text;
};

/** A column of a table. A column without a key is left out of JSON, one without a title out of the
 * text. */
struct Column
{
  const char* Key;
  const char* Title;
  bool IsNumber = true; ///< aligned to the right in the text
};

/** Rows of entries; each row has one for each column. A table without a key is left out of JSON. */
struct Table
{
  const char* Key;
  std::string Title;
  std::vector<Column> Columns;
  std::vector<std::vector<Entry>> Rows = {};

  /** JSON: an object with a member for each row, named by the first column, instead of an array. */
  bool IsObject = false;
};

/** Fields, tables and parts, each of which is a description. */
class GATUN_EXPORT Description
{
public:
  explicit Description(std::string title = {})
    : Title(std::move(title))
  {
  }

  /** Adds a field. A null pointer for the key or the title leaves it out of JSON or of the text. */
  void Add(const char* key, const char* title, Entry entry);

  void Add(Table table) { this->Tables.push_back(std::move(table)); }

  /** Adds an empty part, an object in JSON. The reference stays valid. */
  Description& AddPart(const char* key, std::string title);

  std::string GetText() const;
  Json::Value GetJson() const;

private:
  struct Field
  {
    const char* Key;
    const char* Title;
    Entry Content;
  };

  std::string Title;
  std::vector<Field> Fields;
  std::vector<Table> Tables;
  std::list<std::pair<const char*, Description>> Parts;
};
}

#endif
