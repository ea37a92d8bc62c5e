// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnJson.h"

#include <fmt/core.h>

#include <cmath>

namespace gtn
{
namespace
{

// Length of the UTF-8 sequence at the start of the text; 0 if there is none.
std::size_t SequenceLength(std::string_view text)
{
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80 ? 1
    : first >= 0xc2 && first < 0xe0       ? 2
    : first >= 0xe0 && first < 0xf0       ? 3
    : first >= 0xf0 && first < 0xf5       ? 4
                                          : 0;
  if (length > text.size())
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(i) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  // Overlong forms, surrogates, beyond the last character.
  const bool wrong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) >= 0xa0) ||
    (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) >= 0x90);
  return wrong ? 0 : length;
}

std::string Quoted(std::string_view text)
{
  std::string quoted = "\"";
  while (!text.empty())
  {
    const std::size_t length = SequenceLength(text);
    const auto first = static_cast<unsigned char>(text[0]);
    if (length == 0)
    {
      quoted += "\\ufffd";
    }
    else if (first == '"' || first == '\\')
    {
      quoted += '\\';
      quoted += text[0];
    }
    else if (first < 0x20)
    {
      quoted += fmt::format("\\u{:04x}", first);
    }
    else
    {
      quoted += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return quoted + '"';
}

} // anonymous namespace

//------------------------------------------------------------------------------
Json& Json::Add(std::string_view name, double value)
{
  return this->AddRaw(name, std::isfinite(value) ? fmt::format("{}", value) : "null");
}

//------------------------------------------------------------------------------
Json& Json::Add(std::string_view name, std::uint64_t value)
{
  return this->AddRaw(name, std::to_string(value));
}

//------------------------------------------------------------------------------
Json& Json::Add(std::string_view name, std::string_view value)
{
  return this->AddRaw(name, Quoted(value));
}

//------------------------------------------------------------------------------
Json& Json::AddRaw(std::string_view name, std::string_view value)
{
  this->Start(name);
  this->Text += value;
  return *this;
}

//------------------------------------------------------------------------------
void Json::Start(std::string_view name)
{
  if (!this->First)
  {
    this->Text += ',';
  }
  if (this->Depth > 0)
  {
    this->Text += '\n';
    this->Text.append(2 * this->Depth, ' ');
  }
  if (name.data())
  {
    this->Text += Quoted(name) + ": ";
  }
  this->First = false;
}

//------------------------------------------------------------------------------
Json& Json::Begin(std::string_view name, char bracket)
{
  this->Start(name);
  this->Text += bracket;
  ++this->Depth;
  this->First = true;
  return *this;
}

//------------------------------------------------------------------------------
Json& Json::End(char bracket)
{
  --this->Depth;
  if (!this->First)
  {
    this->Text += '\n';
    this->Text.append(2 * this->Depth, ' ');
  }
  this->Text += bracket;
  if (this->Depth == 0)
  {
    this->Text += '\n';
  }
  this->First = false;
  return *this;
}
}
