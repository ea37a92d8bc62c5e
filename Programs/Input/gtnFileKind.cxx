// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnFileKind.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <string_view>

namespace gtn
{
namespace
{
std::string ReadStart(const std::string& file, std::size_t most)
{
  std::string bytes(most, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

bool IsNetCDFStart(std::string_view bytes)
{
  return bytes.starts_with("CDF") || bytes.starts_with("\x89HDF");
}
}

//------------------------------------------------------------------------------
bool IsNetCDF(const std::string& file)
{
  return IsNetCDFStart(ReadStart(file, 4));
}

//------------------------------------------------------------------------------
bool HasExodusContent(const std::string& file)
{
  // Dimensions come first; the tables of HDF5 are farther from the beginning.
  constexpr std::size_t enough = std::size_t{ 1 } << 20;
  if (!IsNetCDF(file))
  {
    return false;
  }
  const std::string bytes = ReadStart(file, enough);
  return bytes.find("num_dim") != bytes.npos && bytes.find("num_nodes") != bytes.npos;
}

//------------------------------------------------------------------------------
std::string ReadXMLType(const std::string& file)
{
  constexpr std::size_t enough = 65536; // comments may come first
  const std::string start = ReadStart(file, enough);
  const std::size_t element = start.find("<VTKFile");
  if (element == start.npos)
  {
    return {};
  }
  const std::string text = start.substr(element, start.find('>', element) - element);
  std::smatch found;
  const std::regex type(R"re(\stype\s*=\s*["']([^"']*)["'])re");
  return std::regex_search(text, found, type) ? found[1].str() : std::string();
}

//------------------------------------------------------------------------------
void CheckXMLType(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  const std::string type = extension.starts_with(".vt") || extension.starts_with(".pvt")
    ? ReadXMLType(file)
    : std::string();
  if (type.empty())
  {
    return;
  }
  constexpr std::array<std::string_view, 7> known{ "UnstructuredGrid", "PolyData", "ImageData",
    "StructuredGrid", "RectilinearGrid", "vtkMultiBlockDataSet",
    "vtkPartitionedDataSetCollection" };
  const std::string_view single = type.starts_with('P') && type != "PolyData"
    ? std::string_view(type).substr(1)
    : std::string_view(type); // without the mark of files that list pieces
  if (std::find(known.begin(), known.end(), single) == known.end())
  {
    throw Failure(file,
      "holds a " + MakePrintableLine(type) +
        ", which gtn does not read; make an unstructured grid of it, such as by Merge Blocks of "
        "ParaView, and save that as .vtu");
  }
  const std::string_view own = extension == ".vtu" ? known[0] : known[1];
  if ((extension == ".vtu" || extension == ".vtp") && type != own)
  {
    throw Failure(file,
      "holds a " + type + ", and not the " + std::string(own) + " that its name says; rename it");
  }
}

//------------------------------------------------------------------------------
bool IsWideText(const std::string& file)
{
  const std::string bytes = ReadStart(file, 2);
  return bytes == "\xfe\xff" || bytes == "\xff\xfe";
}

//------------------------------------------------------------------------------
void CheckNrrd(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  const std::regex text(R"(encoding:\s*(ascii|text|txt)\s*)", std::regex::icase);
  while (std::getline(stream, line) && !line.empty() && line != "\r") // up to the values
  {
    if (line.size() < 256 && std::regex_match(line, text))
    {
      throw Failure(file,
        "has its values as text, which VTK does not read right; write it with the encoding raw or "
        "gzip, such as by: unu save -f nrrd -e gzip -i " +
          MakePrintableLine(file) + " -o new.nrrd");
    }
  }
}

//------------------------------------------------------------------------------
bool HasCGNSContent(const std::string& file)
{
  const std::string bytes = ReadStart(file, 8);
  // ADF has the first four characters of its name also with the highest bit set.
  return bytes.starts_with("\x89HDF") || bytes.starts_with("@(#)ADF") ||
    bytes.starts_with("\xc0\xa8\xa3\xa9"
                      "ADF");
}
}
