// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn info: prints the contents of a file.

#include "gtnArraySetting.h"
#include "gtnCommands.h"
#include "gtnDescription.h"
#include "gtnFailure.h"
#include "gtnHistogram.h"
#include "gtnInput.h"
#include "gtnJson.h"
#include "gtnNames.h"
#include "gtnOtherProfile.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunMeshDescription.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>
#include <optional>

namespace gtn
{
namespace
{

struct InfoOptions
{
  std::string File;
  bool Json = false;
  std::optional<std::string> Histogram; ///< as given
  int Component = -1;
};

// Parses --histogram. The name is empty without it.
HistogramOptions HistogramOf(const InfoOptions& options)
{
  constexpr int most = 1000;
  HistogramOptions wanted;
  if (options.Histogram)
  {
    const ArraySetting choice = ParseArraySetting("--histogram", *options.Histogram, most, {});
    wanted.Array = choice.Name;
    wanted.Bins = choice.Count.value_or(wanted.Bins);
    wanted.Component = options.Component;
    if (wanted.Bins < 1)
    {
      throw UsageError("--histogram " + *options.Histogram + ": there must be a bin");
    }
  }
  return wanted;
}

// Opens a file. Throws Failure with what reads it if it is of another format.
std::shared_ptr<const gatun::FileReader> Open(const std::string& file)
{
  CheckReadable(file);
  const std::string extension = ExtensionOf(file);
  if (extension == ".ghv")
  {
    throw Failure(file, "is a volume; see gtn volume info");
  }
  try
  {
    return std::make_shared<const gatun::FileReader>(file);
  }
  catch (const gatun::Error&)
  {
    if (extension == ".gtn")
    {
      throw;
    }
    throw Failure(file, "is not a .gtn file; gtn pack makes one of a mesh");
  }
}

// About how many bytes the file would take in the other profile. What else is known about a file
// is printed even if that cannot be found, as in a damaged one.
void DescribeOtherProfile(const gatun::FileReader& file, Description& description)
{
  const bool isFast = file.GetProfile() == gatun::Profile::Fast;
  const std::string title =
    "  as " + NameOfProfile(isFast ? gatun::Profile::Small : gatun::Profile::Fast);
  try
  {
    if (const auto bytes = EstimateOtherProfile(file))
    {
      description.Add("otherProfileBytes", title.c_str(),
        { Json::Value(Json::UInt64{ *bytes }), "about " + GroupDigits(*bytes) + " bytes" });
    }
  }
  catch (const Failure& failure)
  {
    description.Add("otherProfileBytes", title.c_str(),
      { Json::Value(), std::string("unknown: ") + failure.what() });
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddInfo(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = AddCommand(app, settings, "info",
    "Print the contents of a .gtn file and the sizes of its parts. Only the directory of the file "
    "is\n"
    "read; with --histogram also one array, a few chunks at a time, and with -v a piece, to see\n"
    "what the file would take in the other profile.",
    "  gtn info mesh.gtn\n"
    "  gtn info -v mesh.gtn             # with the times, the chunk table, the other profile\n"
    "  gtn info --histogram pressure:30 mesh.gtn\n"
    "  gtn info --json mesh.gtn | jq .sizes.connectivity.bitsPerCell");
  command->add_flag("--json", options->Json, "Print JSON");
  auto* histogramOption = command
                            ->add_option("--histogram", options->Histogram,
                              "Print the histogram of an array at the first time step, with 1 to "
                              "1000 bins (default: 20). For a point array, also print how much of "
                              "the file an isosurface in the middle of each bin reads")
                            ->option_text("ARRAY[:BINS]");
  AddComponent(command, "--component", options->Component,
    "Component for --histogram: a number from 0, or magnitude (default: magnitude)")
    ->needs(histogramOption);
  command->add_option("IN", options->File, "The .gtn file")->required();
  command->callback(
    [options, &settings]
    {
      const HistogramOptions wanted = HistogramOf(*options);
      const auto file = Open(options->File);
      Description description = gatun::DescribeMesh(*file, settings.Verbose);
      if (settings.Verbose)
      {
        DescribeOtherProfile(*file, description);
      }
      if (!wanted.Array.empty())
      {
        Histogram(file, wanted).Describe(description);
      }
      fmt::print("{}", options->Json ? WriteJson(description.GetJson()) : description.GetText());
    });
}
}
