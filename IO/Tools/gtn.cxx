// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVersion.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <exception>

int main(int argc, char* argv[])
{
  try
  {
    CLI::App app{ "Compressed tetrahedral meshes.", "gtn" };
    app.set_version_flag("--version",
      fmt::format("gtn {} (format {})", gatun::PackageVersion(), gatun::FormatVersion()));
    try
    {
      app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
      return app.exit(error) == 0 ? 0 : 2;
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    fmt::print(stderr, "gtn: {}\n", error.what());
    return 1;
  }
}
