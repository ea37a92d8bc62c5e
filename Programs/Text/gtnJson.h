// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnJson_h
#define gtnJson_h

#include <cstdint>
#include <string>
#include <string_view>

namespace gtn
{
/** Builds a JSON text, indented, piece after piece. */
class Json
{
public:
  /** A name is given inside objects only. */
  Json& BeginObject(std::string_view name = {}) { return this->Begin(name, '{'); }
  Json& EndObject() { return this->End('}'); }
  Json& BeginArray(std::string_view name = {}) { return this->Begin(name, '['); }
  Json& EndArray() { return this->End(']'); }

  /** Numbers that are not finite become null; bytes that are not UTF-8 become U+FFFD. */
  Json& Add(std::string_view name, double value);
  Json& Add(std::string_view name, std::uint64_t value);
  Json& Add(std::string_view name, int value) { return this->AddRaw(name, std::to_string(value)); }
  Json& Add(std::string_view name, bool value)
  {
    return this->AddRaw(name, value ? "true" : "false");
  }
  Json& Add(std::string_view name, const char* value)
  {
    return this->Add(name, std::string_view(value));
  }
  Json& Add(std::string_view name, std::string_view value);
  Json& Add(std::string_view name, const std::string& value)
  {
    return this->Add(name, std::string_view(value));
  }

  const std::string& GetText() const { return this->Text; }

private:
  Json& Begin(std::string_view name, char bracket);
  Json& End(char bracket);
  Json& AddRaw(std::string_view name, std::string_view value);
  void Start(std::string_view name);

  std::string Text;
  int Depth = 0;
  bool First = true;
};
}

#endif
